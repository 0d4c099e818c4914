"""The examples that go all the way: falsify a lane keeper; train a policy and drive with it."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

LEARNING = Path(__file__).parents[2] / "examples" / "learning"
pytestmark = pytest.mark.slow


def run(folder: Path, *command: str) -> str:
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        [sys.executable, *command],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=600,
        env={**os.environ, "PATH": path},  # its `python3` is this one, not a shell script
    )
    assert done.returncode in (0, 4), done.stderr  # 4: an expectation is violated
    assert "Traceback" not in done.stderr
    return done.stdout + done.stderr


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copytree(LEARNING, tmp_path, dirs_exist_ok=True)
    return tmp_path


def test_a_lane_keeper_of_the_user_is_falsified(folder: Path) -> None:
    held = run(folder, "-m", "roadlang", "run", "pid_keeper.rl", "-n", "4", "-o", "drives")
    assert "all expectations hold in 4 of 4 scenes" in held
    one = ("--seed", "1", "--failures", "1", "-o", "failures")
    run(folder, "-m", "roadlang", "falsify", "pid_keeper.rl", *one)
    (failure,) = (folder / "failures" / "failures").glob("????.json")
    name = failure.relative_to(folder).as_posix()
    again = run(folder, "-m", "roadlang", "run", name, "-o", "again")
    assert "violated  in_lane" in again


def test_a_policy_that_is_trained_on_its_failures_fails_less(folder: Path) -> None:
    untrained, *_ = means(run(folder, "train_policy.py", "--generations", "8"))
    policy = json.loads((folder / "policy.json").read_text())
    assert len(policy["weights"]) == 68
    assert policy["actions"] == {"steering": 0.6109, "acceleration": 4.0, "deceleration": 8.0}
    first = failing(folder, "search")
    assert first >= 1
    more = ("--failures", "search", "--generations", "8")
    *_, trained = means(run(folder, "train_policy.py", *more))
    assert trained > untrained + 100.0
    assert failing(folder, "again") < first


def means(printed: str) -> list[float]:
    """The mean reward of each generation that training printed."""
    return [float(found) for found in re.findall(r"^generation \d+: mean (\S+),", printed, re.M)]


def failing(folder: Path, name: str) -> int:
    """How many of the scenes of a search fail."""
    search = ["falsify", "policy_keeper.rl", "--seed", "1", "--evaluations", "12", "-o", name]
    run(folder, "-m", "roadlang", *search)
    return int(json.loads((folder / name / "summary.json").read_text())["failing"])
