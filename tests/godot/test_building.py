"""Scenes built in a real engine: proven by what its scene tree holds."""

from __future__ import annotations

import base64
from dataclasses import replace

import cv2
import numpy as np
import pytest

from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.lane_strips import lane_strips
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.line import polyline
from roadlang_godot.build.road_mesh import road_parts, strip_part
from roadlang_godot.engines.engine import Engine
from roadlang_godot.faults import EngineError
from roadlang_godot.net.messages import refusal
from roadlang_godot.net.protocol import Message
from roadlang_godot.net.scene_part import ScenePart
from roadlang_godot.net.session import Session
from tests.godot.godot_engines import started
from tests.godot.godot_scenes import bends, call, car, pieces, scene, straight, thing, town

pytestmark = pytest.mark.godot


def everything() -> tuple[ScenePart, ...]:
    """One of each kind of thing."""
    roads, network = town()
    made = scene(
        *roads,
        networks=[network],
        agents=[car("ego", roads[0], 20.0, call("pure_pursuit", speed=8.0))],
        objects=[thing("tree", 20.0 + 3 * i, 30.0) for i in range(90)],
    )
    return layout_of(made).parts


def begin(session: Session, things: tuple[ScenePart, ...] | list[ScenePart]) -> None:
    session.begin({"name": "test", "extent": 500.0}, clear=True)
    session.update(things)


def test_the_engine_proves_every_kind_of_thing(session: Session) -> None:
    things = everything()
    begin(session, things)
    proof = session.prove()
    assert proof.parts == len(things)
    assert {thing.kind for thing in things} >= {
        Message.SEGMENT, Message.PATCH, Message.OBJECTS, Message.PATH, Message.AGENT, Message.WORLD
    }  # fmt: skip


def test_all_sixteen_tiles_are_proven(session: Session) -> None:
    pixels = np.zeros((12, 12), bool)
    pixels[1:8, 2] = pixels[4, 1:11] = pixels[1:10, 8] = pixels[8, 8:11] = True
    pixels[10, 0] = pixels[1, 4:7] = pixels[7, 4:7] = pixels[6:9, 5] = True
    roads, network = town()
    png = base64.b64encode(cv2.imencode(".png", pixels.astype(np.uint8) * 255)[1]).decode()
    pixelled = replace(network, mask=png, mask_scale=8.0)
    things = layout_of(scene(*roads, networks=[pixelled]), "tiles").parts
    begin(session, things)
    assert session.prove().parts == len(things)
    assert session.probe(*_cell(layout_of(scene(*roads)).frame, 12, 2, 4)) == pytest.approx(0.0)


def _cell(frame: SceneOrigin, rows: int, column: int, row: int) -> tuple[float, float]:
    """The middle of a cell of 8 m in the engine's coordinates."""
    return 8.0 * (column + 0.5) - frame.x, 8.0 * (rows - row - 0.5) - frame.y


def test_what_the_engine_does_not_hold_is_named(session: Session) -> None:
    things = [t for t in everything() if t.kind == Message.SEGMENT]
    begin(session, things)
    false = replace(things[0], content=things[0].content[:-1] + b"\x07")
    session._built[0][false.key] = (session._built[0][false.key][0], false)
    with pytest.raises(EngineError, match=f"RL504\\]: 1 thing.*{false.label}"):
        session.prove()


def test_only_what_changed_is_sent_again(session: Session) -> None:
    line = polyline("main", pieces(straight(900)), 7.0)
    things = road_parts(line, 1, SceneOrigin())
    begin(session, things)
    edges = np.frombuffer(things[4].content, "<f4").reshape(-1, 2, 3).copy()
    edges[3:6, :, 1] += 0.4
    s = np.linspace(400, 500, len(edges))
    (look,) = lane_strips(line.cross_section)
    changed = strip_part("main", edges, s, look, things[4].id)
    assert session.update([*things[:4], changed, *things[5:]]) == 1
    assert session.prove().builds == len(things) + 1


def test_what_is_gone_from_the_scene_is_removed(session: Session) -> None:
    things = road_parts(polyline("main", pieces(straight(500)), 7.0), 1, SceneOrigin())
    begin(session, things)
    session.update(things[:2])
    assert session.prove().parts == 2


def test_a_malformed_thing_is_refused_in_words(session: Session) -> None:
    begin(session, [])
    session.send(Message.SEGMENT, b"\0\0\0\0\1\0\0\0\1\0\0\0" + b"\2\0\1\0" + bytes(8), "bad")
    with pytest.raises(EngineError, match=r"RL507.*stations"):
        session.expect(Message.BUILT)


def test_a_car_at_a_junction_finds_road_under_every_wheel(session: Session) -> None:
    roads, network = town()
    layout = layout_of(scene(*roads, networks=[network]))
    begin(session, layout.parts)
    for x in np.arange(-12.0, 12.0, 1.5):
        assert session.probe(x - layout.frame.x, -layout.frame.y) == pytest.approx(0.0, abs=1e-3)


def test_the_websocket_carries_the_same_messages() -> None:
    things = everything()
    with started(transport="websocket") as engine, engine.connect("test") as session:
        begin(session, things)
        assert session.prove().parts == len(things)


def test_an_engine_that_is_forgotten_ends_by_itself() -> None:
    with started(quit_idle=3.0) as engine:
        with engine.connect("brief") as session:
            session.flush()
        engine.process.wait(timeout=300)


def test_an_engine_that_dies_is_noticed_at_once() -> None:
    with started() as engine, engine.connect("brief") as session:
        engine.process.kill()
        engine.process.wait()
        with pytest.raises(EngineError, match=r"RL505.*its process was killed by SIGKILL"):
            session.prove()
        with pytest.raises(EngineError, match=r"RL505.*its process was killed by SIGKILL"):
            engine.connect("again")


def test_a_second_client_is_refused_while_the_first_is_there(fast_engine: Engine) -> None:
    with (
        fast_engine.connect("first"),
        pytest.raises(EngineError, match=r"RL503.*another client") as refused,
    ):
        fast_engine.connect("second")
    assert "start another engine with `roadlang godot --port" in str(refused.value)


@pytest.mark.parametrize("payload", [b"\xff\x00", b"[1]", b"null", b'{"code": []}', b""])
def test_a_refusal_that_is_no_complaint_is_an_error_all_the_same(payload: bytes) -> None:
    assert "error[RL503]" in str(refusal(payload))


def test_a_hundred_kilometers_are_proven_built(session: Session) -> None:
    x = np.arange(0, 100_001, 20.0)
    line = polyline("long", np.stack([x, 60 * np.sin(x / 150)], axis=-1), 7.0)
    things = road_parts(line, 1, SceneOrigin(50_000.0, 0.0))
    session.begin({"name": "long", "extent": 50_000.0}, clear=True)
    session.update(things)
    proof = session.prove()
    assert proof.parts == len(things) >= 1000


def test_a_road_in_the_paper_drives_to_the_end(session: Session) -> None:
    from roadlang_godot.drive.simulate import Settings, drive_in

    bent = bends()
    ego = car("ego", bent, 5.0, call("pure_pursuit", speed=14.0, lookahead=6.0))
    trace = drive_in(session, scene(bent, agents=[ego]), Settings(duration=90), {})
    assert trace.agents["ego"].progress[-1] > 0.99
