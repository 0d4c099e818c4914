"""Scenes with traffic: the same bytes for one seed, whatever `-n`, `--jobs` and `--set` are."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from roadlang.cli.main import run

SCENE = """
param green = 6s
param speed = 40km/h
image plan from \"\"\"
...#...
...#...
...#...
#######
...#...
...#...
\"\"\" { scale: 20m/px, legend: { "#": road } }
network town from plan {
  extract with auto { width: 7m }
  lanes: 2
  speed_limit: speed
  control with signals { green: green, yellow: 2s, offset: 0s..20s }
}
agent cars is choice(car, van) on town at random {
  count: 5
  drive with traffic { speed_factor: 0.8..1.2, aggression: 0..1 }
}
agent walker is pedestrian on town at random { side: right, offset: 1m, drive with walk }
expect untouched: always (cars.contacts == 0)
simulate with builtin { duration: 8s, control_step: 0.1s }
emit json
"""

TRACE = ".trace.json"
Usual = Callable[[str], dict[str, bytes]]


@pytest.fixture(autouse=True)
def scene_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("town.rl").write_text(SCENE)


@pytest.fixture(scope="module")
def usual(tmp_path_factory: pytest.TempPathFactory) -> Usual:
    """What runs of so many scenes leave, each made once in a folder of its own."""

    @cache
    def made_once(count: str) -> dict[str, bytes]:
        with pytest.MonkeyPatch.context() as patch:
            patch.chdir(tmp_path_factory.mktemp("usual"))
            Path("town.rl").write_text(SCENE)
            return made("usual", "-n", count)

    return made_once


def made(folder: str, *words: str, file: str = "town.rl") -> dict[str, bytes]:
    """The scenes and the drives that a run leaves, by the names of their files."""
    assert run(["compile", file, "-o", folder, *words]) == 0
    assert run(["run", file, "-o", f"{folder}/driven", *words]) in (0, 4)
    paths = [path for path in Path(folder).rglob("scene-*") if path.is_file()]
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def test_the_same_seed_gives_the_same_bytes_and_another_one_others(usual: Usual) -> None:
    first, again = usual("1"), made("again", "-n", "1", "--seed", "0")
    assert any(name.endswith(TRACE) for name in first)
    assert first == again
    other = made("other", "-n", "1", "--seed", "6")
    assert other.keys() == first.keys()
    assert all(other[name] != first[name] for name in first if name.endswith(TRACE))


def test_more_scenes_begin_with_the_same(usual: Usual) -> None:
    few, many = usual("1"), usual("3")
    assert len(many) == 3 * len(few)
    assert few.items() <= many.items()


def test_more_processes_change_nothing(usual: Usual) -> None:
    assert usual("3") == made("both", "-n", "3", "--jobs", "2")


def test_a_parameter_that_is_set_is_as_one_that_is_written(usual: Usual) -> None:
    Path("written.rl").write_text(SCENE.replace("green = 6s", "green = 3s"))
    chosen = made("chosen", "-n", "1", "--set", "green=3s")
    written = made("written", "-n", "1", file="written.rl")
    (drive,) = (name for name in chosen if name.endswith(TRACE))
    assert chosen[drive] == written[drive]
    assert chosen[drive] != usual("1")[drive]
