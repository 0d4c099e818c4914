"""Functions of time that are linear between breakpoints and may jump at them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ..evaluate.sliding_and_until import Extreme
from ..evaluate.trace import FloatArray
from ..evaluate.windows import BoolArray, IntArray


@dataclass(frozen=True)
class PiecewiseLinear:
    """`at` (m,) are the values at the breakpoints `times` (m,); between two of them the function
    runs from `after` to `before` (m - 1,). Times closer than `tolerance` are one."""

    times: FloatArray
    at: FloatArray
    after: FloatArray
    before: FloatArray
    tolerance: float

    def limits(self, times: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """The limit from the left, the value, and the limit from the right at each of `times`."""
        index = np.searchsorted(self.times, times - self.tolerance)
        index = np.minimum(index, self.times.size - 1)
        hit = np.abs(self.times[index] - times) <= self.tolerance
        if self.after.size == 0:
            return (self.at[index],) * 3
        piece = np.clip(index - 1, 0, self.after.size - 1)
        inside = self._on_piece(piece, times)
        before = np.where(hit, np.where(index > 0, self.before[piece], self.at[index]), inside)
        right = np.minimum(index, self.after.size - 1)
        ends = index == self.times.size - 1
        after = np.where(hit, np.where(ends, self.at[index], self.after[right]), inside)
        return before, np.where(hit, self.at[index], inside), after

    def _on_piece(self, piece: IntArray, times: FloatArray) -> FloatArray:
        start, end = self.times[piece], self.times[piece + 1]
        first, last = self.after[piece], self.before[piece]
        with np.errstate(invalid="ignore", over="ignore"):
            inside = first + (last - first) * ((times - start) / (end - start))
        values: FloatArray = np.where(first == last, first, inside)
        return values

    def refined(self, times: FloatArray) -> PiecewiseLinear:
        """The same function over `times`, which hold all its breakpoints between their ends."""
        before, at, after = self.limits(times)
        return replace(self, times=times, at=at, after=after[:-1], before=before[1:])

    def _through(self, chosen: BoolArray, values: FloatArray) -> PiecewiseLinear:
        """The same function with these values (m,) at the `chosen` breakpoints, without jumps."""
        return replace(
            self,
            at=np.where(chosen, values, self.at),
            after=np.where(chosen[:-1], values[:-1], self.after),
            before=np.where(chosen[1:], values[1:], self.before),
        )

    def mapped(self, function: Callable[[FloatArray], FloatArray]) -> PiecewiseLinear:
        """A function of the values that is linear on every piece."""
        return replace(
            self,
            at=function(self.at),
            after=function(self.after),
            before=function(self.before),
        )

    def reversed(self) -> PiecewiseLinear:
        """As seen backwards in time."""
        return PiecewiseLinear(
            -self.times[::-1],
            self.at[::-1],
            self.before[::-1],
            self.after[::-1],
            self.tolerance,
        )

    @property
    def is_constant(self) -> bool:
        """Whether it has one value throughout."""
        value = self.at[0]
        return all((values == value).all() for values in (self.at, self.after, self.before))


def constant(value: float, times: FloatArray, tolerance: float) -> PiecewiseLinear:
    """One value from the first of `times` to the last."""
    ends = times[[0, -1]] if times.size > 1 else times
    at = np.full(ends.size, value)
    return PiecewiseLinear(ends, at, at[:-1], at[:-1], tolerance)


def merged(times: FloatArray, tolerance: float) -> FloatArray:
    """In order, those closer than the tolerance taken for one."""
    ordered = np.sort(times)
    result: FloatArray = ordered[np.append(True, np.diff(ordered) > 2 * tolerance)]
    return result


def together(
    f: PiecewiseLinear, g: PiecewiseLinear, *, crossings: bool = False
) -> tuple[PiecewiseLinear, PiecewiseLinear]:
    """Both over the same breakpoints; with `crossings`, neither crosses the other between two."""
    times = merged(np.concatenate([f.times, g.times]), f.tolerance)
    f, g = f.refined(times), g.refined(times)
    if not crossings:
        return f, g
    with np.errstate(invalid="ignore"):
        first, last = f.after - g.after, f.before - g.before
        cross = np.isfinite(first) & np.isfinite(last) & (np.sign(first) * np.sign(last) < 0)
    if not cross.any():
        return f, g
    first, last = first[cross], last[cross]
    start, end = times[:-1][cross], times[1:][cross]
    met = start + (end - start) * (first / (first - last))
    clear = (met - start > 2 * f.tolerance) & (end - met > 2 * f.tolerance)
    added = merged(np.concatenate([times, met[clear]]), f.tolerance)
    is_crossing = ~np.isin(added, times)
    f, g = f.refined(added), g.refined(added)
    # Both have one value there, without the rounding of either: |f| is 0 where f is.
    with np.errstate(invalid="ignore"):
        shared = np.where(_is_flat(g), g.at, np.where(_is_flat(f), f.at, (f.at + g.at) / 2))
    return f._through(is_crossing, shared), g._through(is_crossing, shared)


def _is_flat(f: PiecewiseLinear) -> BoolArray:
    """(m,) whether the function has one value on the piece that ends at each breakpoint."""
    return np.append(False, (f.after == f.before) & (f.before == f.at[1:]))


def extreme_of(f: PiecewiseLinear, g: PiecewiseLinear, extreme: Extreme) -> PiecewiseLinear:
    """The lesser or the greater of both at each time."""
    f, g = together(f, g, crossings=True)
    return joined(f, g, extreme.ufunc)


def joined(
    f: PiecewiseLinear,
    g: PiecewiseLinear,
    function: Callable[[FloatArray, FloatArray], FloatArray],
) -> PiecewiseLinear:
    """A function of both, over the same breakpoints, that is linear on every piece."""
    return PiecewiseLinear(
        f.times,
        function(f.at, g.at),
        function(f.after, g.after),
        function(f.before, g.before),
        f.tolerance,
    )


def holding(
    margin: PiecewiseLinear, relation: Callable[[FloatArray, FloatArray], FloatArray]
) -> PiecewiseLinear:
    """`relation` of 0 and the margin, which is constant between the moments at which it is 0."""
    given = margin.times
    margin, _ = together(margin, constant(0.0, given, margin.tolerance), crossings=True)
    crossed = ~np.isin(margin.times, given)
    at = relation(np.zeros_like(margin.at), np.where(crossed, 0.0, margin.at))
    is_first = np.abs(margin.after) > np.abs(margin.before)
    larger = np.where(is_first, margin.after, margin.before)
    inside = relation(np.zeros_like(larger), larger)
    return PiecewiseLinear(margin.times, at, inside, inside, margin.tolerance)
