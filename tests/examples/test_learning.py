"""The examples that go all the way: falsify a lane keeper; train a policy and drive with it."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

LEARNING = Path(__file__).parents[2] / "examples" / "learning"
pytestmark = pytest.mark.slow


def run(folder: Path, *command: str) -> str:
    done = subprocess.run(
        [sys.executable, *command], cwd=folder, capture_output=True, text=True, timeout=600
    )
    assert done.returncode in (0, 4), done.stderr  # 4: an expectation is violated
    assert "Traceback" not in done.stderr
    return done.stdout + done.stderr


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copytree(LEARNING, tmp_path, dirs_exist_ok=True)
    return tmp_path


def test_a_lane_keeper_of_the_user_is_falsified(folder: Path) -> None:
    held = run(folder, "-m", "roadlang", "run", "pid_keeper.rl", "-n", "10", "-o", "drives")
    assert "all expectations hold in 10 of 10 scenes" in held
    run(folder, "-m", "roadlang", "falsify", "pid_keeper.rl", "--seed", "1", "-o", "failures")
    failures = sorted((folder / "failures" / "failures").glob("????.json"))
    assert len(failures) == 5
    name = failures[0].relative_to(folder).as_posix()
    again = run(folder, "-m", "roadlang", "run", name, "-o", "again")
    assert "violated  in_lane" in again


def test_a_policy_that_is_trained_on_its_failures_fails_less(folder: Path) -> None:
    lines = run(folder, "train_policy.py").splitlines()
    before, *_, after = [line for line in lines if line.startswith("generation")]
    assert mean_of(after) > mean_of(before) + 100.0
    policy = json.loads((folder / "policy.json").read_text())
    assert len(policy["weights"]) == 68
    first = failing(folder, "search")
    assert first >= 1
    run(folder, "train_policy.py", "--failures", "search")
    assert failing(folder, "again") < first


def mean_of(line: str) -> float:
    return float(line.split("mean ")[1].split(",")[0])


def failing(folder: Path, name: str) -> int:
    """How many of the scenes of a search fail."""
    run(folder, "-m", "roadlang", "falsify", "policy_keeper.rl", "--seed", "1", "-o", name)
    return int(json.loads((folder / name / "summary.json").read_text())["failing"])
