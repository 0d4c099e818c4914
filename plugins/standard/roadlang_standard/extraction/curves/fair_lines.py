"""Lines one after another in arrays, to be solved together though each is on its own.

For a short line, to begin an operation of numpy takes longer than to do it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

Indices = NDArray[np.intp]


@dataclass(frozen=True)
class SeenOffsets:
    """What was seen along a curve of n points: `offset` (n,), pixels to the left of each point,
    how much it weighs (n,), 0 to 1, and the `tolerance` (n,) in pixels within which it is as good
    as met. `pins` are offsets that are met exactly, by the index of their point."""

    offset: Floats
    weight: Floats
    tolerance: Floats
    pins: tuple[tuple[int, float], ...] = ()


@dataclass(frozen=True)
class FairLine:
    """A line of n points that are `step` pixels apart: what was seen along it, and its signed
    curvature (n - 2,) in 1/px at all points but its ends."""

    seen: SeenOffsets
    bend: Floats
    step: float

    def __len__(self) -> int:
        return len(self.seen.offset)


@dataclass(frozen=True)
class FairLines:
    """Lines of N points in all: what was `seen` along them, where each of them ends, curvature
    (N - 2,) and its change (N - 3,) in 1/px and 1/px^2, square (N - 2,) and cube (N - 3,) of the
    step between points.

    `turning` (N - 2,) and `changing` (N - 3,) are the weights of the sums of both, but 0 for
    differences across the end of a line: so no line has an effect on the next one.
    """

    ends: Indices
    seen: SeenOffsets
    bend: Floats
    change: Floats
    square: Floats
    cube: Floats
    turning: Floats
    changing: Floats

    def parts(self, values: Floats) -> list[Floats]:
        """Those of each line, of values (N,) of all points."""
        return np.split(values, self.ends[:-1])


def in_a_row(lines: Sequence[FairLine], turning: float, changing: float) -> FairLines:
    """The lines one after another, with weights of |curvature| and of its |change|, summed over
    their length."""
    ends = np.cumsum([len(line) for line in lines])
    steps = [line.step for line in lines]
    return FairLines(
        ends,
        _seen(lines, ends),
        _apart([line.bend for line in lines], 2),
        _apart([np.diff(line.bend) / line.step for line in lines], 3),
        _each([step**2 for step in steps], ends, 1.0, 2),
        _each([step**3 for step in steps], ends, 1.0, 3),
        _each([turning / step for step in steps], ends, 0.0, 2),
        _each([changing / step**2 for step in steps], ends, 0.0, 3),
    )


def _seen(lines: Sequence[FairLine], ends: Indices) -> SeenOffsets:
    starts = ends - [len(line) for line in lines]
    pins = tuple(
        (int(start) + index, value)
        for start, line in zip(starts, lines, strict=True)
        for index, value in line.seen.pins
    )
    return SeenOffsets(
        np.concatenate([line.seen.offset for line in lines]),
        np.concatenate([line.step * line.seen.weight for line in lines]),
        np.concatenate([line.seen.tolerance for line in lines]),
        pins,
    )


def _each(values: Sequence[float], ends: Indices, across: float, order: int) -> Floats:
    """A value of each line for all its differences of an order, and another one across its end."""
    total = np.repeat(np.asarray(values), np.diff(ends, prepend=0))
    for back in range(1, order + 1):
        total[ends - back] = across
    return total[:-order]


def _apart(values: Sequence[Floats], order: int) -> Floats:
    """Differences of an order, one line's after the other's, with zeros across their ends."""
    gap = np.zeros(order)
    return np.concatenate([part for value in values for part in (value, gap)])[:-order]
