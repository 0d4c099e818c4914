"""Which of several verdicts is the worst."""

from __future__ import annotations

import math

import pytest

from roadlang.judging.badness import badness, says_how_near

FROM_WORST = [
    (False, None),  # minus infinity: the robustness of no scene is lower
    (False, -5.0),
    (False, -0.1),
    (True, 0.1),
    (True, 5.0),
    (True, None),
    (True, 0.0),  # of an equality
]


def test_verdicts_from_the_worst_on() -> None:
    mixed = FROM_WORST[::-1]
    assert sorted(mixed, key=lambda verdict: badness(*verdict)) == FROM_WORST


def test_what_is_not_judged_is_not_among_the_worst() -> None:
    assert badness(None, None) > badness(False, math.inf)


@pytest.mark.parametrize(
    ("satisfied", "robustness", "near"),
    [
        (True, 0.4, True),
        (True, 0.0, False),  # of an equality
        (True, math.inf, False),
        (True, None, False),
        (False, -0.4, True),
        (False, 0.0, True),
        (False, None, True),  # minus infinity
        (None, None, True),
    ],
)
def test_what_holds_says_how_near_it_came_to_failing_by_a_finite_robustness(
    satisfied: bool | None, robustness: float | None, near: bool
) -> None:
    assert says_how_near(satisfied, robustness) is near
