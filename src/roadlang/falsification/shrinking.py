"""What a failure needs: the simplest draws that still fail, and which draws matter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from .evaluator import Evaluator, Proposal
from .outcome import Outcome
from .outcome_rows import is_made, places_of

MEDIAN = 0.5
"""The coordinate of the median of a draw."""
LEAST_STEP = 0.05
"""Shorter steps toward the simplest value are not tried, in parts of the range of a draw."""
_MOST_PAIRED = 8
"""Draws whose pairs are tried: those that matter most by themselves."""


def shrunk(failure: Outcome, evaluator: Evaluator) -> Outcome:
    """The failure with as many draws as possible at their simplest values, and the others half
    way toward them as often as it still fails of the same cause.

    All are tried together first: where that fails, many drives are saved, and nothing can be
    simpler. Else they are changed one after the other, always the one with which it fails worst,
    until none can be any more. Draws of unordered values have no half way.
    """
    current, simplest = failure, evaluator.simplest
    together = _worst(failure, [Proposal(failure.index, tuple(simplest))], evaluator)
    if together is not None:
        return together
    while True:
        others = [axis for axis, at in enumerate(current.point) if at != simplest[axis]]
        resets = [_moved(current, axis, simplest[axis]) for axis in others]
        halves = [
            _moved(current, axis, middle)
            for axis in others
            if evaluator.ordered[axis]
            and abs(current.point[axis] - (middle := _between(current, axis, simplest)))
            >= LEAST_STEP
        ]
        better = _worst(failure, resets, evaluator) or _worst(failure, halves, evaluator)
        if better is None:
            return current
        current = better


def _between(outcome: Outcome, axis: int, simplest: Sequence[float]) -> float:
    return 0.5 * (outcome.point[axis] + simplest[axis])


def _worst(failure: Outcome, proposals: Sequence[Proposal], evaluator: Evaluator) -> Outcome | None:
    """The one that fails worst of the same cause; None where none fails."""
    name = failure.violated[0]
    tried = evaluator.evaluate(proposals) if proposals else []
    failing = [outcome for outcome in tried if name in outcome.violated]
    return min(failing, key=lambda outcome: _rho(outcome, name), default=None)


def _moved(outcome: Outcome, axis: int, at: float) -> Proposal:
    """The same candidate with one coordinate somewhere else."""
    point = (*outcome.point[:axis], at, *outcome.point[axis + 1 :])
    return Proposal(outcome.index, point)


@dataclass(frozen=True)
class Influence:
    """The violated expectation with some draws at their medians, the others as they are."""

    draws: tuple[str, ...]
    robustness: float | None
    """None where it is infinite, or there is no such scene"""
    holds: bool | None
    """whether the expectation holds then; None where a requirement is violated"""


def influences(
    failure: Outcome, evaluator: Evaluator, axes: Sequence[str]
) -> tuple[Influence, ...]:
    """Of each draw, and of each pair of those that matter most; the greatest robustness first.
    Draws that the scene does not make, as those of copies that it lacks, are left out."""
    name, places = failure.violated[0], places_of([failure])
    singles = [
        (number,) for number, axis in enumerate(axes) if is_made(axis, failure.draws, places)
    ]
    found = _tried(failure, singles, evaluator)
    order = sorted(singles, key=lambda key: -_margin(found[key], name))
    leading = sorted(axis for (axis,) in order[:_MOST_PAIRED])
    found |= _tried(failure, list(combinations(leading, 2)), evaluator)
    ranked = sorted(found, key=lambda key: (-_margin(found[key], name), len(key), key))
    return tuple(
        Influence(
            tuple(axes[axis] for axis in key),
            found[key].expectations.get(name),
            name not in found[key].violated if found[key].is_valid else None,
        )
        for key in ranked
    )


def _tried(
    failure: Outcome, keys: Sequence[tuple[int, ...]], evaluator: Evaluator
) -> dict[tuple[int, ...], Outcome]:
    outcomes = evaluator.evaluate([_reset(failure, key) for key in keys])
    return dict(zip(keys, outcomes, strict=True))


def _reset(outcome: Outcome, axes: Sequence[int]) -> Proposal:
    """The same candidate with some coordinates at the medians; its other draws stay."""
    point = tuple(MEDIAN if axis in axes else v for axis, v in enumerate(outcome.point))
    return Proposal(outcome.index, point)


def _margin(outcome: Outcome, name: str) -> float:
    """The robustness, infinite where the expectation holds and has none that is finite."""
    robustness = outcome.expectations.get(name)
    holds = outcome.is_valid and name not in outcome.violated
    return float("inf") if robustness is None and holds else _rho(outcome, name)


def _rho(outcome: Outcome, name: str) -> float:
    robustness = outcome.expectations.get(name)
    return float("-inf") if robustness is None else robustness
