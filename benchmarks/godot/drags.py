"""CPU time of a drag by hand, from the move of the mouse to the new mesh: client and engine."""

from __future__ import annotations

import statistics
import tempfile
import time
from pathlib import Path

import roadlang
from benchmarks.godot.engine_time import engine_seconds
from roadlang.commands import handles_of
from roadlang_godot.commands.watch import Watcher
from roadlang_godot.editing.live import HandEdit
from roadlang_godot.engines import engine

MOVES = 60
THINGS = """
object kiosk is building at (40m, 40m) { length: 4m, width: 4m, height: 3m }
object elm is tree on main at 60m { side: left, offset: 6m }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 1m/s } }
"""
POINTS = ", ".join(f"({40 * i}m, {6 * (i % 3)}m)" for i in range(13))
WAYPOINTS = f"road main {{ draw with waypoints {{ points: [{POINTS}] }} }}\n" + THINGS
SEGMENTS = (
    "road main { draw with segments { pieces: [straight(200m), arc(150m, 60deg), "
    "straight(130m)] } }\n" + THINGS
)
TOWN = (
    'image plan from """\n.....#.....\n.....#.....\n.#########.\n.....#.....\n""" '
    '{ scale: 12m/px, legend: { "#": road } }\nnetwork main from plan { lanes: 2 }\n'
)
DRAGS = {
    "waypoint": (WAYPOINTS, "main"),
    "place of a road": (SEGMENTS, "main"),
    "junction": (TOWN, "main"),
    "object": (SEGMENTS, "kiosk"),
    "object on a road": (SEGMENTS, "elm"),
    "agent": (SEGMENTS, "ego"),
}


def drags() -> None:
    """Moves of each kind of handle, one after another; without the drawing of frames."""
    for kind, (text, name) in DRAGS.items():
        with tempfile.TemporaryDirectory() as folder:
            client, built = _cost(Path(folder) / "scene.rl", text, name)
        rate = 1000.0 / (client + built)
        print(f"drag of a {kind}: client {client:.1f} ms, engine {built:.1f} ms: {rate:.0f} Hz")


def _cost(file: Path, text: str, name: str) -> tuple[float, float]:
    """CPU ms of a move: median in the client, mean in the engine with all else that it does."""
    file.write_text(text, encoding="utf-8")
    loaded = roadlang.load(file)
    with engine.start() as running, running.connect() as session:
        watcher = Watcher(loaded, 0, "mesh", save=False)
        live = watcher.start(session, loaded.sample(1, seed=0)[0].record)
        watcher.settle(live)
        handle = next(h for h in handles_of(text, live.scene) if h.name == name)
        took, before = [], engine_seconds(running)
        for move in range(1, MOVES + 1):
            edit = HandEdit("move", handle, (handle.x + 0.05 * move, handle.y - 0.03 * move), 1,
                            False)  # fmt: skip
            start = time.process_time()
            watcher.take(live, edit)
            took.append(1000 * (time.process_time() - start))
            watcher.look(live)
        spent = engine_seconds(running) - before
    return statistics.median(took), 1000 * spent / MOVES
