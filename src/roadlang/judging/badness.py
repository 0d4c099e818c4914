"""Which of several verdicts is the worst."""

from __future__ import annotations

import math


def badness(satisfied: bool | None, robustness: float | None) -> tuple[bool, bool, float]:
    """What the worst expectation, or scene, has least of.

    What is violated is worse than what holds. What equality decides (`ego.contacts == 0`) holds
    with robustness 0, which says nothing of how near it came: it comes after all others that hold.
    """
    rho = math.inf if robustness is None else robustness
    return satisfied is not False, satisfied is True and rho == 0.0, rho
