"""Requirements that no draw can satisfy, before anything is searched."""

from __future__ import annotations

import numpy as np

from ..evaluate.candidates import CandidateBatch
from .acceptance import Acceptance

FIRST = 16
"""Candidates that must agree with bounds that refute a requirement"""


def impossible_requirements(acceptance: Acceptance, seed: int) -> frozenset[int]:
    """Requirements that bounds refute, or that nothing random has a say in and that fail, by index.

    Raises RL474 where a bound, stated by a kind, is wrong.
    """
    count = 1 if acceptance.has_varying_stations else FIRST
    attempts = np.arange(count)
    few = CandidateBatch(acceptance.scenario, seed, np.zeros(count, np.int64), attempts)
    refuted = acceptance.impossible(few)
    return refuted | _failing_without_draws(acceptance, few.take(np.zeros(1, np.intp)), refuted)


def _failing_without_draws(
    acceptance: Acceptance, first: CandidateBatch, refuted: frozenset[int]
) -> frozenset[int]:
    """Of the requirements that nothing random has a say in, those that fail: the last ones are
    judged where all others hold."""
    fixed = [i for i, each in enumerate(acceptance.requirements) if not each.is_random]
    found = set(refuted)
    for last in (False, True):
        if last and found:
            break
        for index in fixed:
            requirement = acceptance.requirements[index]
            if requirement.last is not last or index in found:
                continue
            if not requirement.is_satisfied(first, requirement.rho(first)).all():
                found.add(index)
    return frozenset(found)
