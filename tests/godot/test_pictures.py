"""Pictures of scenes, drawn in software: what should be seen is there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roadlang.api import Scene, SceneActor
from roadlang.cli import main as cli
from roadlang_godot.build.line import line_of
from roadlang_godot.engines.engine import Engine
from roadlang_godot.faults import EngineError, fault
from roadlang_godot.rendering import pictures as drawing
from roadlang_godot.rendering.pictures import Shot, build, take, view_of
from tests.godot.godot_scenes import bend, car, pieces, road, scene, straight, thing

pytestmark = pytest.mark.godot


def curved() -> Scene:
    main = road("main", pieces(straight(60), bend(50, 120), straight(60)))
    return scene(main, agents=[car("ego", main, 30.0)])


def drawn(engine: Engine, shot: Shot) -> tuple[np.ndarray, object]:
    with engine.connect("pictures") as session:
        layout = build(session, curved())
        picture = np.frombuffer(take(session, layout, shot), np.uint8)
        return cv2.imdecode(picture, cv2.IMREAD_COLOR), layout


def test_a_top_view_shows_the_road_where_it_is(drawing_engine: Engine) -> None:
    shot = Shot("top", 640, 640)
    picture, layout = drawn(drawing_engine, shot)
    frame, view = layout.frame, view_of(layout, shot)  # type: ignore[attr-defined, arg-type]
    scale = view["size"] / shot.height
    middle = (frame.x + view["x"], frame.y + view["y"])
    line = line_of(curved().roads[0])
    s = np.linspace(2, line.length - 2, 60)
    points, heading, _ = line.at(s)
    side = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)

    def colors(at: np.ndarray) -> np.ndarray:
        column = np.round((at[:, 0] - middle[0]) / scale + 319.5).astype(int)
        row = np.round((middle[1] - at[:, 1]) / scale + 319.5).astype(int)
        return np.asarray(picture[row, column], int)

    asphalt = colors(points + 1.5 * side)
    grass = colors(points + 6.0 * side)
    saturation = np.ptp(asphalt, axis=1), np.ptp(grass, axis=1)
    assert np.median(saturation[0]) < 25
    assert np.median(saturation[1]) > 40
    assert (saturation[0] < saturation[1]).mean() > 0.9


def test_the_chase_view_shows_sky_above_and_a_car_in_the_middle(drawing_engine: Engine) -> None:
    picture, _ = drawn(drawing_engine, Shot("chase", 480, 270))
    sky = picture[:40].reshape(-1, 3).mean(axis=0)
    assert sky[0] > sky[2] + 20
    center, edge = picture[170:230, 210:270], picture[170:230, 5:65]
    assert np.abs(center.mean(axis=(0, 1)) - edge.mean(axis=(0, 1))).max() > 15


def test_the_commands_picture_and_clip(tmp_path: Path) -> None:
    from tests.godot.godot_engines import started

    started(draw=True).stop()
    file = tmp_path / "scene.rl"
    file.write_text(
        "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] }, width: 8m }\n"
        "agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s } }\n",
        encoding="utf-8",
    )
    size = ["--size", "160x90"]
    for name, more in (("a.png", ["--at", "1"]), ("b.avi", ["--duration", "1", "--fps", "4"])):
        code = cli.run(["render", str(file), "-o", str(tmp_path / name), *size, *more])
        assert code == 0
    assert cv2.imread(str(tmp_path / "a.png")).shape == (90, 160, 3)
    clip = cv2.VideoCapture(str(tmp_path / "b.avi"))
    frames = [frame for good, frame in iter(clip.read, (False, None)) if good]
    assert len(frames) == 4
    assert np.abs(frames[0].astype(int) - frames[-1].astype(int)).mean() > 1


def test_a_clip_that_fails_leaves_no_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def failing() -> Iterator[bytes]:
        yield bytes(cv2.imencode(".png", np.zeros((16, 16, 3), np.uint8))[1])
        raise fault("RL508")

    monkeypatch.setattr(drawing, "_pictures", lambda *_: failing())
    with pytest.raises(EngineError):
        drawing.render_clip(curved(), Shot(), tmp_path / "a.avi", 1.0, 4)
    assert not list(tmp_path.iterdir())


def night(*objects: SceneActor, hours: float = 22.0) -> Scene:
    main = road("main", pieces(straight(60)))
    made = scene(main, agents=[car("ego", main, 8.0)], objects=objects)
    return replace(made, world={"time_of_day": hours * 3600.0})


def test_at_night_lamps_light_the_road_and_the_sky_is_not_black(drawing_engine: Engine) -> None:
    def brightness(made: Scene, shot: Shot) -> np.ndarray:
        with drawing_engine.connect("night") as session:
            layout = build(session, made)
            picture = np.frombuffer(take(session, layout, shot), np.uint8)
            again = np.frombuffer(take(session, layout, shot), np.uint8)
            assert np.array_equal(picture, again)
            pixels = np.asarray(cv2.imdecode(picture, cv2.IMREAD_COLOR), float)
            return np.asarray(pixels.mean(axis=2))

    below = Shot("top", 200, 200, scale=0.3)
    lamp = thing("lamp", 45.0, 4.5, 0.3, 0.3, 6.0)
    dark, lit = brightness(night(), below), brightness(night(lamp), below)
    # The road below the lamp, 15 m right of the middle and 3 m above it.
    place = np.s_[88:94, 144:156]
    assert lit[place].mean() > 1.5 * dark[place].mean()
    # What the headlamps reach, 10 m before the car.
    assert dark[96:104, 60:70].mean() > 1.3 * dark[96:104, 150:160].mean()
    sky = brightness(night(), Shot("chase", 160, 90))[:25]
    assert 4.0 < sky.mean() < 60.0
    dusk = brightness(night(hours=18.3), Shot("chase", 160, 90))[:25]
    assert dusk.mean() > 2.0 * sky.mean()
