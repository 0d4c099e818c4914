"""Which of several verdicts is the worst."""

from __future__ import annotations

import math

from roadlang.judging.badness import badness

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
