"""Conditions on drives are read once where they cannot change, and anew where they can."""

from __future__ import annotations

from typing import Any

from roadlang import testing
from roadlang.judging.drive_formulas import drive_formula
from roadlang.plugins.discovery import load_registry
from tests.straight_road import STRAIGHT

TEXT = (
    STRAIGHT
    + """
agent ego is car on main at 10m..50m { drive with brake }
expect slow: always (ego.speed < 20m/s)
"""
)


def test_the_scenes_of_a_run_share_what_is_read_of_an_expectation() -> None:
    registry = load_registry()
    one, other = (scene.record.expectations[0].formula for scene in testing.sample(TEXT, 2))
    assert one is not None
    assert other is not None
    assert drive_formula(one, registry) is drive_formula(other, registry)


def test_a_condition_that_can_change_is_read_anew() -> None:
    registry = load_registry()
    condition: dict[str, Any] = {"formula": {"always": {"<": ["limit", 20.0]}}}
    condition["numbers"] = {"limit": 5}
    assert drive_formula(condition, registry).numbers == {"limit": 5.0}
    condition["numbers"] = {"limit": 7}
    assert drive_formula(condition, registry).numbers == {"limit": 7.0}


def test_a_member_signal_knows_the_agent_it_belongs_to() -> None:
    (scene,) = testing.sample(TEXT, 1)
    condition = scene.record.expectations[0].formula
    assert condition is not None
    (signal,) = drive_formula(condition, load_registry()).signals
    assert signal.entities == {"agent": "ego"}
    assert signal.members == {"ego"}
