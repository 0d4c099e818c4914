"""Scenes for each second of processor time, beside Scenic on the same problems.

    python -m benchmarks.scenes.beside_scenic [ROUNDS]

Scenes are made and not written; reading the files and maps is not counted. Scenic runs in the
virtual environment that the tests use for it (see `tests/formats/tool_installation.py`), in turn
with roadlang, so that both see the same load. Exit code 1 if a bar is missed.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import roadlang
from tests.formats.tool_installation import installed_tool

SIDE = Path(__file__).parents[2] / "tests/formats/tool_scripts/scenic_rate.py"
SCENES = 4_000
SQUARE = """
workspace = Workspace(RectangularRegion(0 @ 0, 0, 60, 60))
ego = new Object at Range(-25, 25) @ Range(-25, 25), with width 2, with length 4
other = new Object at Range(-25, 25) @ Range(-25, 25), with width 2, with length 4
require 6 < (distance from ego to other) < {far}
"""
OUR_SQUARE = """
param x = -25m..25m
param y = -25m..25m
param other_x = -25m..25m
param other_y = -25m..25m
object one is box at (x, y) {{ length: 4m, width: 2m }}
object other is box at (other_x, other_y) {{ length: 4m, width: 2m }}
require far: (x - other_x) ^ 2 + (y - other_y) ^ 2 > (6m) ^ 2
require near: (x - other_x) ^ 2 + (y - other_y) ^ 2 < ({far}m) ^ 2
sample with random {{ attempts: 1000000 }}
"""
STREET = """
param map = localPath("scene-0000.xodr")
model scenic.domains.driving.model
ego = new Car
other = new Car
require (distance from ego to other) < {far}
"""
OUR_STREET = """
param at_first = 3m..197m
param at_second = 3m..197m
road main {{ draw with segments {{ pieces: [straight(200m)] }} width: 7m, lanes: 2 }}
agent ego is car on main at at_first {{ lane: choice(-1, 1) }}
agent other is car on main at at_second {{ lane: choice(-1, 1) }}
require near: abs(at_first - at_second) < {far}m
sample with random {{ attempts: 1000000 }}
"""
CASES = (
    ("two boxes, 6 to 15 m apart", SQUARE, OUR_SQUARE, 15, 200, 10.0),
    ("two boxes, 6 to 8 m apart", SQUARE, OUR_SQUARE, 8, 60, 40.0),
    ("two cars, less than 20 m apart", STREET, OUR_STREET, 20, 60, 40.0),
)
"""Name, Scenic's program, ours, the distance in them, scenes of Scenic in a round, and the bar."""


def main() -> int:
    """Print a line for each problem."""
    rounds = int([*sys.argv[1:], "3"][0])
    python = installed_tool("scenic") / "bin" / "python"
    met = True
    with tempfile.TemporaryDirectory() as name:
        for title, theirs, ours, far, count, bar in CASES:
            folder = Path(name)
            program, file = folder / "program.scenic", folder / "scene.rl"
            program.write_text(theirs.format(far=far))
            file.write_text(ours.format(far=far))
            loaded = roadlang.load(file)
            if "map" in theirs:
                loaded.sample(1, seed=1).emit(folder, ["opendrive"])
            found = [
                (our_rate(loaded, seed), *scenic_rate(python, program, count))
                for seed in range(1, rounds + 1)
            ]
            rate, other, share = map(statistics.median, zip(*found, strict=True))
            ratio = statistics.median(our / their for our, their, _ in found)
            met &= ratio >= bar
            print(
                f"{title:32} roadlang {rate:7.0f}/s   Scenic {other:6.1f}/s ({share:.1%} accepted)"
                f"   {ratio:5.0f} times, bar >= {bar:g}  {'met' if ratio >= bar else 'MISSED'}"
            )
    return 0 if met else 1


def our_rate(loaded: roadlang.LoadedScenario, seed: int) -> float:
    """Scenes for each second of processor time."""
    start = time.process_time()
    found = len(loaded.sample(SCENES, seed=seed))
    return found / (time.process_time() - start)


def scenic_rate(python: Path, program: Path, count: int) -> tuple[float, float]:
    """The same of Scenic, and the share of its iterations that were scenes."""
    done = subprocess.run(
        [python, SIDE, program, str(count)],
        capture_output=True,
        text=True,
        check=True,
        cwd=program.parent,
    )
    rate, share = map(float, done.stdout.split()[-2:])
    return rate, share


if __name__ == "__main__":
    sys.exit(main())
