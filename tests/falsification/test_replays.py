"""Failures on disk, driven again one by one: the same verdicts, the same bytes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import roadlang
from benchmarks.falsification.bent_road import lane_keeper
from benchmarks.falsification.rare import FAILS

FEW_DECISIONS = "\nsimulate with builtin { control_step: 0.1s }\n"
"""Deciding takes most of the time of a drive."""

SLIPPERY = {
    "hard": lane_keeper(0.54) + FEW_DECISIONS,
    "rare": FAILS.replace("choice(0.55, 0.6, 0.65, 0.7, 0.75)", "choice(0.5, 0.52, 0.55)")
    + FEW_DECISIONS,
}


@pytest.mark.parametrize("problem", SLIPPERY)
def test_a_failure_driven_alone_is_the_drive_of_the_search(problem: str, tmp_path: Path) -> None:
    found = roadlang.loads(SLIPPERY[problem]).falsify(evaluations=80, seed=1)
    found.write(tmp_path)
    index = json.loads((tmp_path / "failures/index.json").read_text())
    assert len(index["failures"]) >= 3
    for failure in index["failures"][:3]:
        file = tmp_path / "failures" / failure["scene"]
        again = roadlang.Scene.from_json(file.read_bytes()).run()
        assert failure["replays"]
        assert not again.satisfied
        assert again.verdicts["in_lane"].robustness == failure["robustness"]["in_lane"]
        assert again.to_csv() == file.with_suffix(".trace.csv").read_text()


def test_the_scene_of_a_failure_made_alone_is_the_one_made_with_others() -> None:
    found = roadlang.loads(SLIPPERY["rare"]).falsify(evaluations=60, seed=1)
    assert len(found.failures) >= 2
    for failure, drive in zip(found.failures, found.failure_drives, strict=True):
        assert failure.scene.to_json() == drive.scene.to_json()
