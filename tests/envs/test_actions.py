"""What is taken as actions of a step."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("gymnasium")

from roadlang.envs.spaces import checked_actions


def test_actions_are_held_within_minus_one_and_one() -> None:
    assert checked_actions([0.5, 9], 2).tolist() == [0.5, 1.0]
    assert checked_actions(np.array([-np.inf, 0]), 2).tolist() == [-1.0, 0.0]


@pytest.mark.parametrize(
    ("actions", "reason"),
    [
        ("left", "actions must be numbers, not 'left'"),
        ({"steering": 1}, r"actions must be numbers, not \{'steering': 1\}"),
        ([[0, 0], [0]], "actions must be numbers"),
        ([0, 0, 0], r"actions must have the shape \(2,\), not \(3,\)"),
        ([0, np.nan], "an action is not a number"),
    ],
)
def test_anything_else_is_refused_with_the_reason(actions: Any, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        checked_actions(actions, 2)
