"""Cameras of agents: what they see is where the geometry says, and is the same every time."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np
import pytest

from roadlang.api import Scene
from roadlang_godot.build.camera_parts import camera_parts
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.mounted_camera import OUTPUTS, MountedCamera
from roadlang_godot.engines.engine import Engine
from roadlang_godot.faults import EngineError
from roadlang_godot.net.session import Session
from roadlang_godot.sensors import boxes
from roadlang_godot.sensors.boxes import SeenThing, seen_things
from roadlang_godot.sensors.camera_frames import CameraFrame
from roadlang_godot.sensors.eyes import Eyes
from roadlang_standard.semantic_classes import SemanticClass
from tests.godot.godot_scenes import car, pieces, road, scene, straight, thing

pytestmark = pytest.mark.godot

Frames = tuple[CameraFrame, ...]
MAIN = road("main", pieces(straight(120)))


def boxes_around() -> Scene:
    """Boxes at all sides of a car, each with free sight from it, and other things farther away."""
    objects, random = [], np.random.default_rng(3)
    for i in range(9):
        angle, away = math.tau * i / 9 + 0.35, random.uniform(9.0, 30.0)
        length, width, height = random.uniform(0.8, 3.0, 3)
        x, y = 60.0 + away * math.cos(angle), away * math.sin(angle)
        box = thing("box", x, y, length, width, height, f"box{i}")
        objects.append(box)
    kinds = ("tree", "building", "cone", "parked_van", "sign", "fence")
    objects += [thing(kind, 30.0 + 12.0 * i, 9.0, 1.5, 1.0, 2.0) for i, kind in enumerate(kinds)]
    agents = [
        car("ego", MAIN, 60.0, offset=0.0),
        car("ahead", MAIN, 75.0, offset=-1.75),
        car("walker", MAIN, 50.0, kind="pedestrian", offset=3.0),
    ]
    return scene(MAIN, agents=agents, objects=objects)


def poses(count: int) -> list[MountedCamera]:
    """Cameras of the car at random places above it, looking at all sides."""
    random = np.random.default_rng(4)
    return [
        MountedCamera(
            "ego",
            f"camera{i}",
            fov=math.radians(random.uniform(40.0, 110.0)),
            at=(random.uniform(-1.0, 1.0), random.uniform(-0.8, 0.8), random.uniform(1.7, 3.0)),
            yaw=random.uniform(-math.pi, math.pi),
            pitch=random.uniform(-0.25, 0.1),
            outputs=OUTPUTS,
        )
        for i in range(count)
    ]


def half_hidden() -> Scene:
    """A box ahead of a car, and a wall before it that ends on the line of sight."""
    wall = thing("box", 70.0, 1.5, 1.0, 3.0, 6.0, name="wall")
    hidden = thing("box", 80.0, 0.0, 2.0, 4.0, 3.0, name="hidden")
    return scene(MAIN, agents=[car("ego", MAIN, 60.0, offset=0.0)], objects=[wall, hidden])


def looked(session: Session, drawn: Scene, cameras: list[MountedCamera]) -> tuple[Eyes, Frames]:
    """What cameras of a scene see at its start."""
    layout = layout_of(drawn)
    session.begin(layout.settings(), clear=True)
    parts = camera_parts(drawn, layout.parts, layout.agents, layout.objects, cameras)
    session.update((*layout.parts, *parts))
    session.prove()
    eyes = Eyes(session, drawn, layout, cameras)
    return eyes, eyes.look(0.0)


@dataclass(frozen=True)
class Looks:
    """Looks through cameras: through many, through two of them again, and at what is hidden."""

    eyes: Eyes
    frames: Frames
    again: Frames
    hidden: dict[str, SeenThing]

    def seen(self) -> Iterator[tuple[CameraFrame, SeenThing]]:
        for frame in self.frames:
            for found in seen_things(frame, self.eyes.instances):
                yield frame, found


@pytest.fixture(scope="module")
def look(drawing_engine: Engine) -> Looks:
    with drawing_engine.connect("cameras") as session:
        straight_ahead = [MountedCamera("ego", outputs=OUTPUTS)]
        of_hidden, (frame,) = looked(session, half_hidden(), straight_ahead)
        hidden = {
            seen.instance.actor.name: seen for seen in seen_things(frame, of_hidden.instances)
        }
        eyes, frames = looked(session, boxes_around(), poses(12))
        again = eyes.look(0.0, eyes.cameras[:2])
        return Looks(eyes, frames, again, hidden)


def projected(frame: CameraFrame, points: np.ndarray) -> np.ndarray:
    """(n, 2) pixels of (n, 3) places in the world, by OpenCV."""
    turn = frame.pose.axes.T
    rotation, _ = cv2.Rodrigues(turn)
    pixels, _ = cv2.projectPoints(
        points, rotation, -turn @ frame.pose.place, frame.camera.matrix(), np.zeros(4)
    )
    return np.asarray(pixels.reshape(-1, 2))


def test_boxes_are_where_their_pixels_are(look: Looks) -> None:
    compared = 0
    for frame, found in look.seen():
        free = found.occlusion == 0.0 and found.truncation == 0.0
        if found.instance.actor.kind != "box" or not free:
            continue
        actor = found.instance.actor
        sides = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0, 1)])
        corners = sides * (actor.length, actor.width, actor.height) + (actor.x, actor.y, 0.0)
        pixels = projected(frame, corners)
        extent = (*pixels.min(axis=0), *pixels.max(axis=0))
        assert found.visible == pytest.approx(extent, abs=1.0)
        assert found.projected == pytest.approx(extent, abs=0.01)
        compared += 1
    assert compared >= 8


def test_every_pixel_of_a_thing_lies_in_its_solid_box(look: Looks) -> None:
    kinds = set()
    for frame, found in look.seen():
        assert frame.depth is not None
        assert frame.instance is not None
        rows, columns = np.nonzero(frame.instance == found.instance.number)
        assert len(rows) == found.pixels
        depth = frame.depth[rows, columns].astype(float)
        f, camera = frame.camera.focal_length, frame.camera
        x = (columns + 0.5 - 0.5 * camera.width) / f * depth
        y = (rows + 0.5 - 0.5 * camera.height) / f * depth
        places = frame.pose.place + np.stack([x, y, depth], axis=-1) @ frame.pose.axes.T
        inside = (
            np.abs((places - found.solid.place) @ found.solid.axes) - np.array(found.solid.size) / 2
        )
        assert (inside < 0.05 * np.array(found.solid.size) + 0.02).all(), found.instance.actor.kind
        if found.pixels:
            kinds.add(found.category)
    assert {SemanticClass.CAR, SemanticClass.PEDESTRIAN, SemanticClass.STREET_OBJECT} <= kinds


def test_classes_belong_to_instances(look: Looks) -> None:
    stuff = {SemanticClass.SKY, SemanticClass.TERRAIN, SemanticClass.ROAD}
    for frame in look.frames:
        assert frame.instance is not None
        assert frame.semantic is not None
        assert frame.depth is not None
        for instance in look.eyes.instances:
            assert set(frame.semantic[frame.instance == instance.number]) <= {instance.category}
        rest = set(frame.semantic[frame.instance == 0].tolist())
        assert rest <= stuff | {SemanticClass.VEGETATION}
        assert (np.isinf(frame.depth) == (frame.semantic == SemanticClass.SKY)).all()


def test_a_second_look_is_the_same(look: Looks) -> None:
    for first, second in zip(look.frames, look.again, strict=False):
        for output in OUTPUTS:
            assert np.array_equal(getattr(first, output), getattr(second, output)), output


def test_a_picture_of_nothing_has_no_boxes(look: Looks) -> None:
    frame = look.frames[0]
    empty = replace(frame, instance=np.zeros((180, 320), np.uint16))
    assert all(found.visible is None for found in seen_things(empty, look.eyes.instances))


def test_what_hides_a_thing_is_counted(look: Looks) -> None:
    hidden = look.hidden["hidden"]
    assert look.hidden["wall"].occlusion == 0.0
    assert hidden.occlusion == pytest.approx(0.5, abs=0.03)
    assert hidden.visible is not None
    assert hidden.visible[0] == pytest.approx(160.0, abs=1.0)


def test_occlusion_is_counted_in_parts_of_any_size(
    look: Looks, monkeypatch: pytest.MonkeyPatch
) -> None:
    def found() -> list[float]:
        return [seen.occlusion for seen in seen_things(look.frames[0], look.eyes.instances)]

    at_once = found()
    monkeypatch.setattr(boxes, "_ROWS", 7)
    assert found() == at_once


def test_a_headless_engine_says_that_it_has_no_screen(session: Session) -> None:
    eyes = Eyes(session, boxes_around(), layout_of(boxes_around()), poses(1))
    with pytest.raises(EngineError) as caught:
        eyes.look(0.0)
    assert caught.value.diagnostics[0].code == "RL508"


@pytest.mark.parametrize(("count", "size"), [(4, 4096), (3000, 16)], ids=["large", "many"])
def test_an_engine_takes_only_so_many_pixels(fast_engine: Engine, count: int, size: int) -> None:
    cameras = [MountedCamera("ego", f"c{i}", size, size, outputs=OUTPUTS) for i in range(count)]

    def built(first: int) -> int:
        with fast_engine.connect("pixels") as session:
            session.begin(layout_of(boxes_around()).settings(), clear=True)
            session.update([cameras[i].part(i + 1, 1) for i in range(first)])
            return session.prove().parts

    with pytest.raises(EngineError, match="all cameras together have at most 134217728 pixels"):
        built(count)
    assert built(2) == 2
