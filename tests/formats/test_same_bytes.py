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
simulate with builtin { duration: 2s }
'''
FILES = 2
EXAMPLES = Path(__file__).parents[2] / "examples"


COMPILE_ALL = """
import sys
from roadlang.cli.main import run
folder, formats, *scenes = sys.argv[1:]
for scene in scenes:
    name = scene.replace("\\\\", "/").split("/")[-1]
    assert run(["compile", scene, "-n", "1", "-o", f"{folder}/{name}", "--emit", formats]) == 0
"""


def python(*arguments: str, seed: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    command = [sys.executable, *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=environment)


def files_in(folder: Path) -> dict[str, bytes]:
    """All files, by name."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def written(scene: Path, folder: Path, verb: str, *more: str, seed: str) -> dict[str, bytes]:
    """All files of a run, by name."""
    emitted = ("--emit", ",".join(FORMATS[verb]))
    command = ("-m", "roadlang", verb, str(scene), "-o", str(folder), *more, *emitted)
    done = python(*command, seed=seed)
    assert done.returncode in (0, 1), done.stderr
    return files_in(folder)


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
def test_examples_are_written_the_same(tmp_path: Path) -> None:
    """Every sixth one, whatever the process has compiled before: one goes through them forward,
    one backward."""
    scenes = [str(path) for path in sorted(EXAMPLES.glob("*.rl"))[::6]]
    for seed, order in (("1", scenes), ("2", scenes[::-1])):
        folder, formats = str(tmp_path / seed), ",".join(FORMATS["compile"])
        done = python("-c", COMPILE_ALL, folder, formats, *order, seed=seed)
        assert done.returncode == 0, done.stderr
    first, second = files_in(tmp_path / "1"), files_in(tmp_path / "2")
    assert first.keys() == second.keys()
    assert len(first) > len(scenes) * len(FORMATS["compile"])
    assert [name for name in first if first[name] != second[name]] == []
