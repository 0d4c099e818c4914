"""What a search says of the failure rate, and how much of the scenario it has seen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .outcome import Outcome

_CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class FailureRate:
    """Of scenes that satisfy the requirements, drawn at random, how many fail."""

    failures: int
    scenes: int
    low: float
    """ends of the interval of Clopper and Pearson (1934), at 95% confidence"""
    high: float


@dataclass(frozen=True, slots=True)
class Coverage:
    """What was seen of a measure: its extremes, and counts in equal parts between them."""

    low: float
    high: float
    scenes: tuple[int, ...]
    failures: tuple[int, ...]


def failure_rate(outcomes: Sequence[Outcome]) -> FailureRate:
    """The rate among the random share of the candidates."""
    drawn = [outcome for outcome in outcomes if outcome.is_random and outcome.is_valid]
    failures = sum(outcome.is_failure for outcome in drawn)
    return FailureRate(failures, len(drawn), *clopper_pearson(failures, len(drawn)))


def clopper_pearson(
    successes: int, trials: int, confidence: float = _CONFIDENCE
) -> tuple[float, float]:
    """The exact interval of a rate (Clopper and Pearson 1934); (0, 1) without trials."""
    from scipy.special import betaincinv

    tail = (1.0 - confidence) / 2.0
    low, high = 0.0, 1.0
    if successes > 0:
        low = float(betaincinv(successes, trials - successes + 1, tail))
    if successes < trials:
        high = float(betaincinv(successes + 1, trials - successes, 1.0 - tail))
    return low, high


def coverage(outcomes: Sequence[Outcome], parts: int = 10) -> dict[str, Coverage]:
    """Of each measure that any outcome has."""
    return measure_coverage([(o.measures, o.is_failure) for o in outcomes], parts)


def measure_coverage(
    drives: Sequence[tuple[Mapping[str, float | None], bool]], parts: int = 10
) -> dict[str, Coverage]:
    """The same of the measures of each drive, and whether it is a failure."""
    names = dict.fromkeys(name for measures, _ in drives for name in measures)
    found = {}
    for name in names:
        seen = [(m[name], failed) for m, failed in drives if m.get(name) is not None]
        values = np.array([value for value, _ in seen], dtype=float)
        failing = np.array([failed for _, failed in seen], dtype=bool)
        if not len(values):
            continue
        low, high = float(values.min()), float(values.max())
        limits = (low, high if high > low else low + 1.0)
        counts = [np.histogram(part, parts, limits)[0] for part in (values, values[failing])]
        scenes, failures = (tuple(count.tolist()) for count in counts)
        found[name] = Coverage(low, high, scenes, failures)
    return found


def best_so_far(outcomes: Sequence[Outcome], name: str) -> list[tuple[int, float]]:
    """(evaluation, robustness) each time that an expectation came closer to being violated."""
    found: list[tuple[int, float]] = []
    for outcome in outcomes:
        robustness = outcome.expectations.get(name)
        if robustness is not None and (not found or robustness < found[-1][1]):
            found.append((outcome.index, robustness))
    return found
