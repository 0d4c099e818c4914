"""Robustness over dense time written from its definitions, in exact arithmetic.

A moment is (time, side): the limit from the left (-1), the value (0) or the limit from the right
(+1). Slow on purpose, and nothing of it is shared with the engine but the formula type.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from roadlang import stl

Moment = tuple[Fraction, int]
Grid = tuple[Sequence[float], Sequence[float]]
Number = Any
"""A fraction, or an infinite float"""


class DenseReference:
    """Formulas over signals that are held, or linear between their samples."""

    def __init__(self, grids: Mapping[str, Grid], *, linear: bool) -> None:
        self.linear = linear
        self.grids = {
            name: [(Fraction(t), Fraction(x)) for t, x in zip(times, values, strict=True)]
            for name, (times, values) in grids.items()
        }
        self.start = max(grid[0][0] for grid in self.grids.values())
        self.end = min(grid[-1][0] for grid in self.grids.values())
        # By identity: the hash of a formula is that of all its parts, each time it is asked.
        self._values: dict[tuple[int, Moment], Number] = {}
        self._kinks: dict[int, list[Fraction]] = {}
        self._seen: dict[int, Any] = {}
        self._made: dict[Any, Any] = {}

    def rho(self, formula: stl.Formula, time: float) -> float:
        return float(self.value(formula, (Fraction(time), 0)))

    def value(self, node: Any, at: Moment) -> Number:
        self._seen[id(node)] = node  # kept alive, so that no other one gets its identity
        key = (id(node), at)
        if key not in self._values:
            self._values[key] = self._value(node, at)
        return self._values[key]

    def _value(self, node: Any, at: Moment) -> Number:
        def of(part: Any) -> Number:
            return self.value(part, at)

        match node:
            case stl.Constant(value):
                return Fraction(value)
            case stl.Variable(name):
                return self._signal(name, at)
            case stl.Negate(x) | stl.Not(x):
                return -of(x)
            case stl.Apply(function, parts):
                values = [of(part) for part in parts]
                return (
                    abs(values[0])
                    if function == "abs"
                    else {"min": min, "max": max}[function](values)
                )
            case stl.Arithmetic(op, x, y):
                return of(x) + of(y) if op == "+" else of(x) - of(y)
            case stl.Truth(value):
                return math.inf if value else -math.inf
            case stl.Comparison(op, x, y):
                difference = of(y) - of(x) if op[0] == "<" else of(x) - of(y)
                return {"==": -abs(difference), "!=": abs(difference)}.get(op, difference)
            case stl.And(parts):
                return min((of(part) for part in parts), default=math.inf)
            case stl.Or(parts):
                return max((of(part) for part in parts), default=-math.inf)
            case stl.Implies(p, q):
                return max(-of(p), of(q))
            case stl.Iff(p, q):
                return min(max(-of(p), of(q)), max(-of(q), of(p)))
            case stl.Xor(p, q):
                return max(min(of(p), -of(q)), min(-of(p), of(q)))
            case stl.Always(_, p) | stl.Historically(_, p):
                window = self._window(node, at)
                return min((self.value(p, m) for m in self._moments([p], window)), default=math.inf)
            case stl.Eventually(_, p) | stl.Once(_, p):
                window = self._window(node, at)
                return max(
                    (self.value(p, m) for m in self._moments([p], window)), default=-math.inf
                )
            case stl.Until(_, p, q) | stl.Since(_, p, q):
                return max(self._witnesses(node, p, q, at), default=-math.inf)
            case stl.Release(interval, p, q):
                return -of(self._one(stl.Until(interval, stl.Not(p), stl.Not(q))))
            case stl.PastRelease(interval, p, q):
                return -of(self._one(stl.Since(interval, stl.Not(p), stl.Not(q))))
            case stl.WeakUntil(interval, p, q):
                to_end = stl.Interval(0, interval.hi if interval else math.inf)
                return max(
                    of(self._one(stl.Until(interval, p, q))), of(self._one(stl.Always(to_end, p)))
                )
            case stl.WeakSince(interval, p, q):
                to_end = stl.Interval(0, interval.hi if interval else math.inf)
                return max(
                    of(self._one(stl.Since(interval, p, q))),
                    of(self._one(stl.Historically(to_end, p))),
                )
            case stl.Duration(_, p, op, amount):
                return self._duration(node, p, op, Fraction(amount), at)
        raise TypeError(node)

    def _duration(self, node: Any, p: Any, op: str, amount: Fraction, at: Moment) -> Number:
        """The greatest level that p has for so long, or (`strict`) for longer."""
        if op in ("<", "<="):
            opposite: Any = {"<": ">=", "<=": ">"}[op]
            at_least = self._one(stl.Duration(node.interval, p, opposite, float(amount)))
            return -self.value(at_least, at)
        if amount < 0 or (amount == 0 and op == ">="):
            return math.inf
        window = self._window(node, at)
        if window is None:
            return -math.inf
        first, last = window[0][0], window[1][0]
        times = sorted({first, last, *(t for t in self.kinks(p) if first < t < last)})
        pieces = [
            (end - start, self.value(p, (start, 1)), self.value(p, (end, -1)))
            for start, end in itertools.pairwise(times)
        ]

        def lasts(level: Number) -> Fraction:
            return sum((_time_at(level, *piece) for piece in pieces), Fraction(0))

        def is_enough(time: Fraction) -> bool:
            return time > amount if op == ">" else time >= amount

        levels = sorted({value for piece in pieces for value in piece[1:]})
        reached = [level for level in levels if is_enough(lasts(level))]
        best = max(reached, default=-math.inf)
        higher = [level for level in levels if level > best]
        if higher and math.isfinite(higher[0]):
            # Linear between two levels; below the lowest one nothing changes.
            if math.isinf(best):
                return best
            middle, near = (best + higher[0]) / 2, (3 * best + higher[0]) / 4
            slope = (lasts(middle) - lasts(near)) / (middle - near)
            if slope:
                crossing = middle + (amount - lasts(middle)) / slope
                best = max(best, min(crossing, higher[0]))
            elif is_enough(lasts(middle)):
                best = higher[0]
        return best

    def _signal(self, name: str, at: Moment) -> Fraction:
        grid = self.grids[name]
        time, side = at
        k = max(
            (k for k, (t, _) in enumerate(grid) if (t < time if side < 0 else t <= time)), default=0
        )
        t0, x0 = grid[k]
        if not self.linear or k + 1 == len(grid):
            return x0
        t1, x1 = grid[k + 1]
        return x0 + (x1 - x0) * (time - t0) / (t1 - t0)

    def _window(self, node: Any, at: Moment) -> tuple[Moment, Moment] | None:
        """The first and the last moment of the window, clipped to the time that is known."""
        lo, hi = _bounds(node.interval)
        time, side = at
        if node.past:
            first = (time - hi, side) if hi < math.inf else (self.start, 0)
            first, last = max(first, (self.start, 0)), (time - lo, side)
        else:
            last = (time + hi, side) if hi < math.inf else (self.end, 0)
            first, last = (time + lo, side), min(last, (self.end, 0))
        return (first, last) if first <= last else None

    def _moments(self, nodes: Sequence[Any], window: tuple[Moment, Moment] | None) -> list[Moment]:
        """Moments of a window among which the extremes of functions linear in between are."""
        if window is None:
            return []
        first, last = window
        times = {*itertools.chain(*(self.kinks(node) for node in nodes)), first[0], last[0]}
        found = {(time, side) for time in times for side in (-1, 0, 1)}
        return sorted({first, last, *(m for m in found if first <= m <= last)})

    def _witnesses(self, node: Any, p: Any, q: Any, at: Moment) -> Iterable[Number]:
        both = self._one(stl.And((p, q)))
        for witness in self._moments([p, q, both], self._window(node, at)):
            ends = sorted([at, witness])
            path = [m for m in self._moments([p], (ends[0], ends[1])) if m != witness or m[1]]
            held = [self.value(p, m) for m in path] if witness != at else []
            yield min([self.value(q, witness), *held])

    def _one(self, node: Any) -> Any:
        """The node made before that equals this one, so that its values are known."""
        return self._made.setdefault(node, node)

    def kinks(self, node: Any) -> list[Fraction]:
        """Times in order, between which the node is linear; both ends are among them."""
        self._seen[id(node)] = node
        if id(node) not in self._kinks:
            times = sorted({t for t in self._candidates(node) if self.start <= t <= self.end})
            self._kinks[id(node)] = self._needed(node, times)
        return self._kinks[id(node)]

    def _needed(self, node: Any, times: list[Fraction]) -> list[Fraction]:
        kept = times[:1]
        for before, time, after in zip(times, times[1:], times[2:], strict=False):
            sides = [self.value(node, (time, side)) for side in (-1, 0, 1)]
            if sides[0] == sides[1] == sides[2]:
                if math.isinf(sides[0]):
                    continue
                left = (sides[0] - self.value(node, (before, 1))) / (time - before)
                right = (self.value(node, (after, -1)) - sides[0]) / (after - time)
                if left == right:
                    continue
            kept.append(time)
        return kept + times[-1:] * (len(times) > 1)

    def _candidates(self, node: Any) -> set[Fraction]:
        ends = {self.start, self.end}
        match node:
            case stl.Variable(name):
                return ends | {t for t, _ in self.grids[name]}
            case stl.Constant() | stl.Truth():
                return ends
            case stl.TemporalOperator():
                return ends | self._temporal_candidates(node)
        times = set(ends).union(*(self.kinks(part) for part in _parts(node)))
        lines: list[Callable[[Moment], Number]] = [
            lambda at, part=part, sign=sign: sign * self.value(part, at)  # type: ignore[misc]
            for part in _parts(node)
            for sign in (1, -1)
        ]
        lines += [lambda at: Fraction(0)]
        if isinstance(node, stl.Comparison):
            left, right = node.left, node.right
            lines += [lambda at: self.value(left, at) - self.value(right, at)]
        return times | self._crossings(sorted(times), lines)

    def _temporal_candidates(self, node: Any) -> set[Fraction]:
        if isinstance(node, (stl.Release, stl.PastRelease, stl.WeakUntil, stl.WeakSince)):
            return set(self.kinks(self._one(node.expanded())))
        parts = list(_parts(node))
        if len(parts) == 2:
            parts.append(self._one(stl.And(tuple(parts))))
        lo, hi = _bounds(node.interval)
        way = 1 if node.past else -1
        shifts = {way * shift for shift in (Fraction(0), lo, hi) if shift < math.inf}
        kinks = set().union(*(self.kinks(part) for part in parts))
        times = sorted(
            {t + s for t in kinks | {self.start, self.end} for s in shifts} | {self.start, self.end}
        )
        times = [t for t in times if self.start <= t <= self.end]

        def line(part: Any, shift: Fraction) -> Callable[[Moment], Number]:
            def at(moment: Moment) -> Number:
                moved = moment[0] - shift
                known = self.start <= moved <= self.end
                return self.value(part, (moved, moment[1])) if known else math.inf

            return at

        lines = [line(part, shift) for part in _parts(node) for shift in shifts]
        levels = {self.value(p, (t, s)) for p in _parts(node) for t in kinks for s in (-1, 0, 1)
                  if (self.start, 0) <= (t, s) <= (self.end, 0)}  # fmt: skip
        lines += [lambda at, level=level: level for level in levels]  # type: ignore[misc]
        return {*times, *self._crossings(times, lines)}

    def _crossings(
        self, times: Sequence[Fraction], lines: Sequence[Callable[[Moment], Number]]
    ) -> set[Fraction]:
        found = set()
        for t0, t1 in itertools.pairwise(times):
            ends = {(line((t0, 1)), line((t1, -1))) for line in lines}
            finite = [pair for pair in ends if not any(map(math.isinf, pair))]
            for (a0, a1), (b0, b1) in itertools.combinations(finite, 2):
                d0, d1 = a0 - b0, a1 - b1
                if d0 * d1 < 0:
                    found.add(t0 + (t1 - t0) * d0 / (d0 - d1))
        return found


def _time_at(level: Number, length: Fraction, first: Number, last: Number) -> Fraction:
    """For how long a piece is at a level or above."""
    top, bottom = max(first, last), min(first, last)
    if bottom >= level:
        return length
    return Fraction(0) if top < level else length * (top - level) / (top - bottom)


def _bounds(interval: stl.Interval | None) -> tuple[Fraction, Number]:
    if interval is None:
        return Fraction(0), math.inf
    return Fraction(interval.lo), Fraction(interval.hi) if interval.hi < math.inf else math.inf


def _parts(node: Any) -> Sequence[Any]:
    return (node.left, node.right) if isinstance(node, stl.Comparison) else node.parts
