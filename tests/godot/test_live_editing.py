"""A scene that is changed while it is driven: physics feels it, and the car drives on."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
import pytest

from roadlang.commands import Handle
from roadlang.ir.scene import Scene
from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.lane_strips import lane_strips
from roadlang_godot.build.line import polyline
from roadlang_godot.build.road_mesh import strip_part
from roadlang_godot.editing.live import LiveScene
from roadlang_godot.engines.engine import Engine
from roadlang_godot.net.protocol import Message
from roadlang_godot.net.scene_part import ScenePart
from roadlang_godot.net.session import Session
from tests.godot.godot_engines import until
from tests.godot.godot_scenes import call, car, pieces, road, scene, straight, thing

pytestmark = pytest.mark.godot


@pytest.fixture
def live_session(fresh_engine: Engine) -> Iterator[Session]:
    with fresh_engine.connect("live") as session:
        yield session


def raised(height: float) -> ScenePart:
    """100 m of road at a height."""
    s = np.linspace(0, 100, 41)
    left, right = polyline("main", pieces(straight(100)), 7.0).edges(s)
    strip = np.stack(
        [SceneOrigin().ground(left, height), SceneOrigin().ground(right, height)], axis=1
    )
    (look,) = lane_strips(polyline("main", pieces(straight(100)), 7.0).cross_section)
    return strip_part("main", strip, s, look, 1)


def probes(session: Session, height: object) -> bool:
    return session.probe(50.0, 0.0) == height


def test_physics_feels_every_change(live_session: Session) -> None:
    live_session.begin({"name": "live", "extent": 200.0}, clear=True)
    live_session.update([raised(0.0)])
    for height in (0.3, 0.1, 2.0):
        live_session.update([raised(height)])
        felt = pytest.approx(height, abs=1e-3)
        until(partial(probes, live_session, felt))


def test_a_car_drives_on_while_its_road_is_moved(live_session: Session) -> None:
    def shifted(by: float) -> Scene:
        points = pieces(straight(120))
        points[:, 1] += by * np.clip((points[:, 0] - 40) / 40, 0, 1)
        main = road("main", points)
        ego = car("ego", main, 5.0, call("pure_pursuit", speed=7.0, lookahead=5.0))
        return scene(main, agents=[ego], objects=[thing("tree", 30.0, 20.0, name="oak")])

    def driven() -> float:
        """How far the car has come."""
        live.listen(0.02)
        trace = live.trace()
        return 0.0 if trace is None else float(trace.agents["ego"].x[-1])

    live = LiveScene(live_session, shifted(0.0))
    for step in range(1, 6):
        until(partial(lambda goal: driven() > goal, 5.0 + step))
        assert live.change(shifted(0.4 * step)) < 12
    until(lambda: driven() > 15.0)
    trace = live.trace()
    assert trace is not None
    ego = trace.agents["ego"]
    assert (np.diff(ego.x) / np.diff(trace.time)).max() < 12.0, "the car jumped"
    assert np.abs(ego.cross_track_error).max() < 1.0
    assert live_session.prove().parts == len(live.layout.parts)


def test_the_ground_grows_where_an_edit_moves_a_road_beyond_it(live_session: Session) -> None:
    def of_length(meters: float) -> Scene:
        return scene(road("main", pieces(straight(meters))), objects=[thing("tree", 30.0, 20.0)])

    live = LiveScene(live_session, of_length(100.0))
    beside = 820.0 - live.layout.frame.x, 30.0
    assert live_session.probe(*beside) is None
    live.change(of_length(800.0))
    until(lambda: live_session.probe(*beside) is not None)
    sent = live.change(of_length(810.0))
    assert sent < 25, "the ground is not sent again"
    assert live_session.prove().parts == len(live.layout.parts)


def test_the_drive_of_a_client_that_left_is_not_reported_to_the_next(fresh_engine: Engine) -> None:
    main = road("main", pieces(straight(120)))
    ego = car("ego", main, 5.0, call("pure_pursuit", speed=7.0, lookahead=5.0))
    with fresh_engine.connect("first") as first:
        left = LiveScene(first, scene(main, agents=[ego]))
        until(lambda: left.listen(0.02) is not None and left.trace() is not None)
    with fresh_engine.connect("second") as second:
        second.begin({"name": "second", "extent": 200.0}, clear=True)
        second.prove()
        second.pump(0.2)
        for message in (Message.TRACE, Message.CONTACTS, Message.DONE):
            assert second.take(message) is None, message


def test_what_a_human_does_is_about_a_handle(live_session: Session) -> None:
    main = road("main", pieces(straight(80)))
    made = scene(main, objects=[thing("tree", 30.0, 20.0, name="oak")])
    handles = [Handle("waypoint", "main", 0.0, 0.0), Handle("waypoint", "main", 80.0, 0.0, 1)]
    oak = Handle("object", "oak", 30.0, 20.0)
    live = LiveScene(live_session, made, handles=[*handles, oak])
    assert live_session.prove().parts == len(live.layout.parts) + 2
    for edit in (
        '{"what":"move","id":2,"index":0,"to":[3,4],"drag":1,"done":true}',
        '{"what":"remove","id":1,"index":1}',
        '{"what":"remove","id":1,"index":2}',
        '{"what":"undo","id":0,"index":0}',
    ):
        live_session._inbox.append((Message.EDIT, edit.encode()))
    moved, gone, undone = live.listen(0.01)
    assert (moved.handle, moved.drag, moved.done) == (oak, 1, True)
    assert moved.to == (live.layout.frame.x + 3, live.layout.frame.y + 4)
    assert (gone.what, gone.handle) == ("remove", handles[1])
    assert (undone.what, undone.handle) == ("undo", None)
