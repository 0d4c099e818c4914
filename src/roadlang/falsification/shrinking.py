"""What a failure needs: the simplest draws that still fail, and which draws matter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from .evaluator import Evaluator, Proposal
from .outcome import Outcome

MIDDLE = 0.5
"""The coordinate that counts as plain: the median of a draw."""
_MOST_PAIRED = 8
"""Draws whose pairs are tried: those that matter most by themselves."""


def shrunk(failure: Outcome, evaluator: Evaluator) -> Outcome:
    """The failure with as many draws as possible at their medians, still of the same cause.

    Draws are reset one after the other, always the one with which it fails worst, until none can
    be reset any more.
    """
    current = failure
    while True:
        others = [i for i, value in enumerate(current.point) if value != MIDDLE]
        tried = evaluator.evaluate([_reset(current, [axis]) for axis in others])
        name = failure.violated[0]
        failing = [outcome for outcome in tried if name in outcome.violated]
        if not failing:
            return current
        current = min(failing, key=lambda outcome: _rho(outcome, name))


def influences(
    failure: Outcome, evaluator: Evaluator, axes: Sequence[str]
) -> Mapping[tuple[str, ...], float | None]:
    """The robustness of the violated expectation with each draw reset to its median, and with each
    pair of those that matter most; the greatest first. None where a requirement is then violated.
    """
    name = failure.violated[0]
    singles = [(axis,) for axis in range(len(axes))]
    found = _tried(failure, singles, evaluator)
    order = sorted(singles, key=lambda key: -_rho(found[key], name))
    leading = sorted(axis for (axis,) in order[:_MOST_PAIRED])
    found |= _tried(failure, list(combinations(leading, 2)), evaluator)
    ranked = sorted(found, key=lambda key: (-_rho(found[key], name), len(key), key))
    return {tuple(axes[axis] for axis in key): found[key].expectations.get(name) for key in ranked}


def _tried(
    failure: Outcome, keys: Sequence[tuple[int, ...]], evaluator: Evaluator
) -> dict[tuple[int, ...], Outcome]:
    outcomes = evaluator.evaluate([_reset(failure, key) for key in keys])
    return dict(zip(keys, outcomes, strict=True))


def _reset(outcome: Outcome, axes: Sequence[int]) -> Proposal:
    """The same candidate with some coordinates in the middle; its other draws stay."""
    point = tuple(MIDDLE if axis in axes else v for axis, v in enumerate(outcome.point))
    return Proposal(outcome.index, point)


def _rho(outcome: Outcome, name: str) -> float:
    robustness = outcome.expectations.get(name)
    return float("-inf") if robustness is None else robustness
