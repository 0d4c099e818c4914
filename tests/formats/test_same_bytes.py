"""All formats give the same bytes on a second run: another process, other hashes, two workers."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

FORMATS = {
    "compile": (
        "opendrive", "openscenario", "sumo", "commonroad", "lanelet2", "gltf", "mujoco", "scenic",
        "json", "svg",
    ),
    "run": ("commonroad", "gltf", "openscenario", "sumo"),
}  # fmt: skip
"""By command: with `run` those that write drives."""
TEXT = '''image plan from """
..#....#..
..#....#..
##########
..#....#..
..#....#..
""" { scale: 30m/px }
network town from plan {
  lanes: 2, sidewalks: 2m, speed_limit: 50km/h, control with signals
  perturb with sine { amplitude: 0m..3m, wavelength: 40m..90m }
}
road street from town { select: longest }
agent ego is car on street at 20m { drive with pure_pursuit { speed: 10m/s } }
agent cars is choice(car, bus, truck, bicycle) on town at random { count: 5, drive with traffic }
agent walkers is pedestrian on street at random { count: 3, side: right, drive with walk }
object things is choice(tree, cone, building) on town at random { count: 6, offset: 7m..12m }
simulate with builtin { duration: 5s }
'''
FILES = 3
EXAMPLES = Path(__file__).parents[2] / "examples"


def written(scene: Path, folder: Path, verb: str, *more: str, seed: str) -> dict[str, bytes]:
    """All files of a run, by name."""
    command = [sys.executable, "-m", "roadlang", verb, str(scene), "-o", str(folder), *more]
    command += ["--emit", ",".join(FORMATS[verb])]
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert done.returncode in (0, 1), done.stderr
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


@pytest.mark.slow
@pytest.mark.parametrize("verb", ["compile", "run"])
def test_another_process_writes_the_same_bytes(tmp_path: Path, verb: str) -> None:
    scene = tmp_path / "town.rl"
    scene.write_text(TEXT, encoding="utf-8")
    count = ("-n", str(FILES), "--seed", "11")
    first = written(scene, tmp_path / "a", verb, *count, seed="1")
    second = written(scene, tmp_path / "b", verb, *count, "--jobs", "2", seed="2")
    assert first.keys() == second.keys()
    assert len(first) > FILES * len(FORMATS[verb])
    assert [name for name in first if first[name] != second[name]] == []


@pytest.mark.slow
@pytest.mark.parametrize("example", sorted(path.stem for path in EXAMPLES.glob("*.rl")))
def test_examples_are_written_the_same(tmp_path: Path, example: str) -> None:
    scene = EXAMPLES / f"{example}.rl"
    first = written(scene, tmp_path / "a", "compile", "-n", "1", seed="1")
    second = written(scene, tmp_path / "b", "compile", "-n", "1", seed="2")
    assert first == second
