"""A real mouse on a virtual screen: what is dragged moves meanwhile, and is saved."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

import roadlang
from roadlang.commands import Handle, handles_of
from roadlang.ir.scene import Scene
from roadlang_godot.commands.watch import Watcher
from roadlang_godot.editing.live import HandEdit
from roadlang_godot.engines.engine import Engine
from roadlang_godot.net.protocol import Message
from roadlang_godot.net.session import Session
from tests.godot.godot_engines import started, until
from tests.godot.virtual_screen import Hand

pytestmark = pytest.mark.godot

THINGS = """
# what stands and drives beside it
object kiosk is building at (40m, 40m) { length: 4m, width: 4m, height: 3m }
object elm is tree on main at 60m { side: left, offset: 6m }
agent ego is car on main at 5m { start_speed: 0m/s, drive with pure_pursuit { speed: 1m/s } }
"""
PICTURE = """image plan from \"\"\"
.............
.###########.
.............
\"\"\" { scale: 10m/px, legend: { "#": road } }
network town from plan
road base from town { select: longest, width: 7m }
road main from base { perturb with sine { amplitude: 2m, wavelength: 60m } }
"""
SEGMENTS = """road main {
  draw with segments { pieces: [straight(50m), arc(80m, 40deg), straight(30m)] }  # bends
}
"""
WAYPOINTS = "road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (120m, 9m)] } }\n"
TOWN = """image plan from \"\"\"
.....#.....
.....#.....
.#########.
.....#.....
\"\"\" { scale: 12m/px, legend: { "#": road } }
network main from plan { lanes: 2 }
"""
METERS = 160.0
"""that the window shows from top to bottom"""


@pytest.fixture(scope="module")
def window(screen: str) -> Iterator[Engine]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("DISPLAY", screen)
        small = ["--resolution", "640x360", "--max-fps", "20"]  # it is drawn in software
        with started(window=True, extra=small, quit_idle=900.0) as engine:
            yield engine


class Desk:
    """A watched file in the window, seen from above, and the hand of a human."""

    def __init__(self, session: Session, hand: Hand, file: Path, text: str) -> None:
        file.write_text(text, encoding="utf-8")
        self.file, self.hand = file, hand
        loaded = roadlang.load(file)
        self.watcher = Watcher(loaded, 0, "mesh", save=True)
        self.live = self.watcher.start(session, loaded.sample(1, seed=0)[0].record)
        self.center = (60.0, 20.0)
        frame = self.live.layout.frame
        x, y = self.center[0] - frame.x, self.center[1] - frame.y
        session.send_json(Message.VIEW, {"camera": "top", "x": x, "y": y, "size": METERS})
        session.flush()
        self.step()

    def step(self) -> None:
        self.watcher.listen(self.live)
        self.watcher.look(self.live)

    def wait(self, holds: Callable[[], object]) -> None:
        def stepped() -> object:
            self.step()
            return holds()

        until(stepped)

    def handle(self, name: str, nearest: float = 0.0) -> Handle:
        """The handle of a road or thing whose x is nearest to a number."""
        found = handles_of(self.file.read_text(), self.live.scene)
        return min((h for h in found if h.name == name), key=lambda h: abs(h.x - nearest))

    def pixel(self, x: float, y: float) -> tuple[float, float]:
        scale = 360.0 / METERS
        return 320.0 + scale * (x - self.center[0]), 180.0 - scale * (y - self.center[1])


def scene_of(file: Path) -> Scene:
    return roadlang.load(file).sample(1, seed=0)[0].record


def farthest(one: Scene, other: Scene) -> float:
    """Between the roads, agents and objects of two scenes, meters."""
    away = np.subtract(places(one), places(other))
    return float(np.hypot(away[:, 0], away[:, 1]).max())


def places(scene: Scene) -> np.ndarray:
    """Agents, objects, and a hundred places along each road."""
    things = [(thing.x, thing.y) for thing in (*scene.agents, *scene.objects)]
    share = np.linspace(0.0, 1.0, 100)
    lines = [
        [np.interp(share * road.stations[-1], road.stations, column) for column in (road.x, road.y)]
        for road in scene.roads
    ]
    return np.vstack([np.reshape(things, (-1, 2)), *(np.transpose(line) for line in lines)])


@pytest.mark.parametrize(
    ("road", "name", "near"),
    [
        (WAYPOINTS, "main", 60.0),
        (SEGMENTS, "main", 60.0),
        (PICTURE, "main", 70.0),
        (WAYPOINTS, "kiosk", 40.0),
        (SEGMENTS, "elm", 60.0),
        (PICTURE, "ego", 5.0),
        (TOWN, "main", 66.0),
    ],
    ids=["waypoint", "segments", "picture", "object", "object on a road", "agent", "junction"],
)
def test_what_is_dragged_moves_is_saved_and_is_undone(
    window: Engine, screen: str, tmp_path: Path, road: str, name: str, near: float
) -> None:
    before = road + ("" if road == TOWN else THINGS)
    with window.connect("desk") as session:
        desk = Desk(session, Hand(screen), tmp_path / "scene.rl", before)
        first, handle = desk.live.scene, desk.handle(name, near)
        x, y = desk.pixel(handle.x, handle.y)
        desk.hand.move(x, y)
        desk.hand.do("mousedown", "1")
        for step in range(1, 6):
            desk.hand.move(x + 9 * step, y - 3 * step)
        desk.wait(lambda: farthest(desk.live.scene, first) > 1.0)
        assert desk.file.read_text() == before, "nothing is saved before the button is released"
        desk.hand.do("mouseup", "1")
        desk.wait(lambda: desk.file.read_text() != before)
        assert farthest(desk.live.scene, scene_of(desk.file)) < 0.01
        pixels = math.dist((45.0, -15.0), (0.0, 0.0))
        moved = desk.handle(name, handle.x + 45 * METERS / 360)
        assert math.dist((moved.x, moved.y), (handle.x, handle.y)) > 0.5 * pixels * METERS / 360
        desk.hand.do("key", "ctrl+z")
        desk.wait(lambda: desk.file.read_text() == before)
        desk.wait(lambda: farthest(desk.live.scene, first) == 0.0)
        desk.hand.do("key", "ctrl+y")
        desk.wait(lambda: desk.file.read_text() != before)


@pytest.mark.parametrize("name", ["main", "ego", "kiosk"])
def test_a_click_selects_and_changes_nothing(
    window: Engine, screen: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    before = SEGMENTS + THINGS.replace("at 5m", "at 2m..9m")
    with window.connect("desk") as session:
        desk = Desk(session, Hand(screen), tmp_path / "scene.rl", before)
        edits: list[HandEdit] = []
        monkeypatch.setattr(desk.watcher, "take", lambda _, edit: edits.append(edit))
        handle = desk.handle(name, 100.0)
        x, y = desk.pixel(handle.x, handle.y)
        desk.hand.move(x + 3, y)
        desk.hand.do("mousedown", "1")
        desk.hand.move(x + 5, y + 1)
        desk.hand.do("mouseup", "1")
        desk.hand.do("key", "Delete")
        desk.wait(lambda: edits)
        assert [(edit.what, edit.handle and edit.handle.name) for edit in edits] == [
            ("remove", name)
        ]
