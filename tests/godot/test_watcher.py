"""What `roadlang watch` does with saves, with what is dragged in the window, and with faults."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import roadlang
from roadlang.cli.main import run
from roadlang.commands import Handle, handles_of
from roadlang_godot.commands import watch
from roadlang_godot.commands.watch import Watcher, _lines
from roadlang_godot.editing.live import HandEdit
from roadlang_godot.engines.engine import Engine
from roadlang_godot.net.protocol import Message
from tests.godot.godot_engines import started, until

pytestmark = pytest.mark.godot

TEXT = """road main { draw with waypoints { points: [(0m, 0m), (40m, 0m), (80m, %sm)] }, width: 8m }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s } }
object kiosk is building at (20m, 30m)
object tree is tree on main at 30m { side: left, offset: 4m }
let bend = abs(curvature(main))
require gentle: always (bend < 0.2/m)
expect slow: always (ego.speed < 3m/s)
expect arrives: eventually (ego.progress > 0.95)
expect moves: eventually (ego.speed > 2m/s)
"""
TOWN = """image plan from \"\"\"
.....#.....
.....#.....
.#########.
.....#.....
\"\"\" { scale: 12m/px, legend: { "#": road } }
network main from plan { lanes: 2 }
"""


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    with started() as engine:
        yield engine


class Watched:
    """A watcher of a file, and its scene in a running engine."""

    def __init__(
        self, engine: Engine, file: Path, save: bool, content: bytes = (TEXT % 0).encode()
    ) -> None:
        file.write_bytes(content)
        self.file = file
        loaded = roadlang.load(file)
        self.scenes = loaded.sample(1, seed=0)
        self.watcher = Watcher(loaded, 0, "mesh", save)
        self.session = engine.connect("watched")
        self.live = self.watcher.start(self.session, self.scenes[0].record)
        self.drags = 0

    def handle(self, name: str, number: int = 0) -> Handle:
        handles = handles_of(self.watcher._edited.text, self.live.scene)
        return next(h for h in handles if (h.name, h.number) == (name, number))

    def drag(self, handle: Handle, *places: tuple[float, float], done: bool = True) -> None:
        """Through some places, at each of which the scene is as the file would be."""
        self.drags += 1
        for place in places:
            last = done and place == places[-1]
            self.do(HandEdit("move", handle, place, self.drags, last))

    def do(self, edit: HandEdit) -> None:
        self.watcher.take(self.live, edit)
        self.watcher.settle(self.live)


@pytest.mark.parametrize("save", [False, True])
def test_what_is_dragged_changes_the_scene_and_with_save_the_file(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str], save: bool
) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save)
    with watched.session:
        kiosk, end = watched.handle("kiosk"), watched.handle("main", 2)
        watched.drag(kiosk, (22.0, 30.0), (25.0, 31.0), done=False)
        assert watched.live.scene.objects[0].x == 25.0, "it moves while it is dragged"
        assert watched.file.read_text() == TEXT % 0
        watched.drag(kiosk, (30.0, 31.0), (25.0, 31.0))
        placed = watched.live.scene.objects[0]
        assert (placed.x, placed.y) == (25.0, 31.0)
        watched.drag(end, (80.0, 3.0), (80.0, 6.0))
        main = watched.live.scene.roads[0]
        assert (main.x[-1], main.y[-1]) == pytest.approx((80.0, 6.0))
        assert ("(25m, 31m)" in watched.file.read_text()) is save
        assert ("(80m, 6m)" in watched.file.read_text()) is save
        printed = capsys.readouterr()
        assert printed.err == ""
        assert printed.out.count(" changes in ") == 2
        watched.drag(watched.handle("tree"), (50.0, 8.0))
        assert watched.live.scene.objects[1].start == pytest.approx(50.5, abs=0.5)


@pytest.mark.parametrize("origin", ["segments { pieces: [straight(90m)] }", None])
def test_what_is_dragged_back_is_as_it_was(
    engine: Engine, tmp_path: Path, origin: str | None
) -> None:
    road = "waypoints { points: [(0m, 0m), (40m, 0m), (80m, 0m)] }"
    text = (TEXT % 0).replace(road, origin or road).replace("at 5m", "at 2m..9m")
    watched = Watched(engine, tmp_path / "scene.rl", save=True, content=text.encode())
    with watched.session:
        first = watched.live.scene
        for name in ("main", "kiosk", "tree", "ego"):
            handle = watched.handle(name)
            watched.drag(handle, (handle.x + 4.0, handle.y + 3.0), (handle.x, handle.y))
            assert watched.file.read_text() == text, name
            assert watched.watcher._edited.text == text, name
            assert watched.live.scene == first, name


def test_an_agent_that_is_put_down_where_it_was_taken_drives_on_from_there(
    engine: Engine, tmp_path: Path
) -> None:
    text = (TEXT % 0).replace("{ drive with", "{ start_speed: 8m/s, drive with")
    watched = Watched(engine, tmp_path / "scene.rl", save=True, content=text.encode())
    with watched.session:
        until(lambda: watched.live.listen(0.02) or x_of_ego(watched) > 45.0)
        place = (x_of_ego(watched), 0.0)
        ego = watched.handle("ego")
        for y, done in ((20.0, False), (0.0, True)):
            watched.do(HandEdit("move", ego, (place[0], y), 1, done, place))
        assert watched.file.read_text() == text
        assert x_of_ego(watched) > 44.0, "not at its start, 5 m"
        watched.do(HandEdit("move", ego, (30.0, 0.0), 2, True, (x_of_ego(watched), 0.0)))
        assert "main at 30m" in watched.file.read_text()


def x_of_ego(watched: Watched) -> float:
    until(lambda: watched.live.listen(0.02) or watched.live.pose("ego") is not None)
    pose = watched.live.pose("ego")
    assert pose is not None
    return pose.x


def test_a_network_that_is_dragged_is_shown_moved_before_it_is_compiled(
    engine: Engine, tmp_path: Path
) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save=True, content=TOWN.encode())
    with watched.session:
        handles = handles_of(TOWN, watched.live.scene)
        junction = next(handle for handle in handles if handle.sort == "junction")
        before, strips = watched.live.scene, built_strips(watched)
        to = (junction.x + 3.0, junction.y - 2.0)
        watched.watcher.take(watched.live, HandEdit("move", junction, to, 1, False))
        shown = built_strips(watched)
        assert watched.live.scene == before, "it is not compiled yet"
        watched.watcher.settle(watched.live)
        compiled = built_strips(watched)
        assert shown.keys() == compiled.keys() == strips.keys()
        assert away(middles(strips), middles(compiled)) > 1.0
        # Lanes keep their width only once they are compiled; their middles differ by less.
        assert away(middles(shown), middles(compiled)) < 0.03
        back = (junction.x, junction.y)
        watched.watcher.take(watched.live, HandEdit("move", junction, back, 1, True))
        watched.watcher.settle(watched.live)
        assert built_strips(watched) == strips
        assert watched.file.read_text() == TOWN


def built_strips(watched: Watched) -> dict[int, bytes]:
    """The corners of the strips of roads that the engine was sent."""
    built = watched.session._built[0].values()
    return {part.id: part.content for _, part in built if part.kind == Message.SEGMENT}


def middles(strips: dict[int, bytes]) -> list[np.ndarray]:
    """The middle lines of strips, (n, 2) each."""
    corners = [np.frombuffer(strip, "<f4").reshape(-1, 2, 3) for strip in strips.values()]
    return [strip.mean(axis=1)[:, [0, 2]] for strip in corners]


def away(lines: list[np.ndarray], others: list[np.ndarray]) -> float:
    """The greatest distance of a point inside one line from the nearest place of the others."""
    places = np.vstack([dense(line) for line in others])
    points = np.vstack([line[2:-2] for line in lines])
    return float(np.hypot(*(points[:, None] - places).T).min(axis=0).max())


def dense(line: np.ndarray) -> np.ndarray:
    """A line with a point about each centimeter."""
    at = np.arange(len(line))
    fine = np.linspace(0, len(line) - 1, 250 * len(line))
    return np.column_stack([np.interp(fine, at, column) for column in line.T])


@pytest.mark.parametrize("name", ["main", "kiosk", "tree", "ego"])
def test_what_is_dragged_is_shown_before_it_is_compiled(
    engine: Engine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setattr(watch, "REST", float("inf"))
    watched = Watched(engine, tmp_path / "scene.rl", save=True)
    with watched.session:
        handle, before = watched.handle(name, 1 if name == "main" else 0), watched.live.scene
        for x in (1.0, 4.0):
            place = (handle.x + x, handle.y + 2.0)
            watched.watcher.take(watched.live, HandEdit("move", handle, place, 1, False))
            watched.watcher.look(watched.live)
            assert watched.watcher._compiling is None, "not while the mouse moves"
        shown = watched.live.scene
        assert shown != before
        watched.watcher.settle(watched.live)
        compiled = watched.live.scene
        (seen,), (road,) = shown.roads, compiled.roads
        at, on = (np.linspace(0, 1, len(one.x)) for one in (seen, road))
        np.testing.assert_allclose(np.interp(on, at, seen.x), road.x, atol=0.01)
        np.testing.assert_allclose(np.interp(on, at, seen.y), road.y, atol=0.01)
        if name != "main":  # What stands on a road stays until it is compiled.
            one, other = ([(a.x, a.y) for a in (*s.agents, *s.objects)] for s in (shown, compiled))
            np.testing.assert_allclose(one, other, atol=0.01)


def test_a_drag_in_progress_that_has_no_scene_says_so_in_the_window(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = TEXT % 0 + "require short: length(main) < 82m\n"
    watched = Watched(engine, tmp_path / "scene.rl", save=True, content=text.encode())
    with watched.session:
        end, first = watched.handle("main", 2), watched.live.scene
        watched.watcher.take(watched.live, HandEdit("move", end, (80.0, 30.0), 1, False))
        dragged = watched.live.scene
        watched.watcher.settle(watched.live)
        (problem,) = watched.watcher._problems
        assert problem.startswith("RL600")
        assert watched.live.scene == dragged, "it stays in the hand"
        assert capsys.readouterr().err == ""
        watched.do(HandEdit("move", end, (80.0, 5.0), 1, True))
        assert watched.watcher._problems == ()
        assert "(80m, 5m)" in watched.file.read_text()
        watched.do(HandEdit("move", watched.handle("main", 2), (80.0, 30.0), 2, True))
        assert "RL600" in capsys.readouterr().err
        assert watched.live.scene != first
        assert "(80m, 5m)" in watched.file.read_text()


def test_undo_restores_the_file_byte_for_byte(engine: Engine, tmp_path: Path) -> None:
    before = b"\xef\xbb\xbf" + (TEXT % 0).replace("\n", "\r\n").encode() + b"# end"
    watched = Watched(engine, tmp_path / "scene.rl", save=True, content=before)
    with watched.session:
        watched.drag(watched.handle("kiosk"), (25.0, 31.0))
        watched.drag(watched.handle("main", 1), (40.0, 4.0))
        after = watched.file.read_bytes()
        assert b"(25m, 31m)" in after
        assert b"(40m, 4m)" in after
        for _ in range(3):
            watched.do(HandEdit("undo"))
        assert watched.file.read_bytes() == before
        assert watched.live.scene.objects[0].x == 20.0
        for _ in range(3):
            watched.do(HandEdit("redo"))
        assert watched.file.read_bytes() == after
        assert watched.live.scene.objects[0].x == 25.0


def test_a_change_by_hand_that_has_no_scene_is_withdrawn(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save=True)
    with watched.session:
        ego = watched.handle("ego")
        watched.file.write_text(TEXT % 0 + "expect near: always (distance(ego, tree) < 90m)\n")
        watched.watcher.settle(watched.live)
        saved = watched.file.read_text()
        watched.do(HandEdit("remove", watched.handle("tree")))
        assert "tree" in capsys.readouterr().err
        assert watched.file.read_text() == saved
        watched.drag(ego, (30.0, 0.0))
        assert "main at 30m" in watched.file.read_text()


def test_waypoints_are_inserted_and_removed(engine: Engine, tmp_path: Path) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save=True)
    with watched.session:
        watched.do(HandEdit("insert", watched.handle("main", 2), (60.0, 5.0)))
        assert "(40m, 0m), (60m, 5m), (80m, 0m)" in watched.file.read_text()
        watched.do(HandEdit("remove", watched.handle("main", 1)))
        assert "(0m, 0m), (60m, 5m), (80m, 0m)" in watched.file.read_text()


def test_a_save_is_seen_once_and_a_moment_without_a_file_is_none(
    engine: Engine,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(watch, "time", SimpleNamespace(monotonic=lambda: 5000.0))  # it stands
    watched = Watched(engine, tmp_path / "scene.rl", save=False)
    with watched.session:
        watched.watcher.settle(watched.live)
        assert "changes" not in capsys.readouterr().out
        watched.file.write_text(TEXT % 5)
        for _ in range(3):
            watched.watcher.settle(watched.live)
        assert watched.live.scene.roads[0].y[-1] == pytest.approx(5.0)
        assert capsys.readouterr().out.count(" changes in 0 ms, after ") == 1
        watched.file.unlink()
        watched.watcher.settle(watched.live)
        watched.file.write_text("raod main\n")
        watched.watcher.settle(watched.live)
        assert "raod" in capsys.readouterr().err
        assert watched.live.scene.roads[0].y[-1] == pytest.approx(5.0)


def test_robustness_is_shown_of_requirements_and_of_what_was_driven(
    engine: Engine, tmp_path: Path
) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save=False)
    with watched.session:
        assert _lines(watched.live, watched.scenes) == ["satisfied  gentle  0.20"]
        until(lambda: bool(watched.live.listen(0.05)) or watched.live.trace() is not None)
        gentle, slow, arrives, moves = _lines(watched.live, watched.scenes)
        assert gentle == "satisfied  gentle  0.20"
        assert slow.startswith("VIOLATED  slow  -")
        assert arrives.startswith("unknown  arrives  -")
        assert moves.startswith("satisfied  moves  ")


def test_watching_ends_after_the_time_that_is_said(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "scene.rl"
    file.write_text(TEXT % 0, encoding="utf-8")
    words = ["watch", str(file), "--host", "127.0.0.1", "--port", str(engine.port)]
    assert run([*words, "--for", "0.5"]) == 0
    printed = capsys.readouterr().out
    assert printed == f"{file} is being driven: save it to update the scene, press Ctrl-C to stop\n"
