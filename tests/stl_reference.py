"""Robustness and Boolean satisfaction written from their definitions, one sample at a time.

Slow on purpose, and nothing of it is shared with the engine but the formula type.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from roadlang import stl
from roadlang.stl.formula.measures import AtLeast

Row = Mapping[str, Sequence[float]]


class Reference:
    """Evaluates formulas over one trace. `wrap` repeats it for ever, in both directions."""

    def __init__(
        self,
        positions: Sequence[float] | NDArray[np.float64],
        signals: Row,
        wrap: float | None = None,
    ) -> None:
        self.positions = [float(position) for position in positions]
        self.signals = signals
        self.wrap = wrap
        # By identity: the hash of a formula is that of all its parts, each time it is asked.
        self._known: dict[tuple[int, int, object], float] = {}
        self._seen: dict[int, stl.Formula] = {}

    def rho(self, formula: stl.Formula) -> list[float]:
        return [self._value(formula, k, _margin) for k in range(len(self.positions))]

    def satisfied(self, formula: stl.Formula) -> list[bool]:
        return [self._value(formula, k, _truth) > 0 for k in range(len(self.positions))]

    def _value(self, formula: stl.Formula, k: int, leaf: Callable[..., float]) -> float:
        def at(part: stl.Formula, sample: int) -> float:
            sample = sample if self.wrap is None else sample % len(self.positions)
            self._seen[id(part)] = part  # kept alive, so that no other one gets its identity
            key = (id(part), sample, leaf)
            if key not in self._known:
                self._known[key] = self._value(part, sample, leaf)
            return self._known[key]

        match formula:
            case stl.Truth(value):
                return math.inf if value else -math.inf
            case stl.Comparison(op, left, right):
                return leaf(op, self._term(left, k), self._term(right, k))
            case stl.Not(p):
                return -at(p, k)
            case stl.And(parts):
                return min((at(p, k) for p in parts), default=math.inf)
            case stl.Or(parts):
                return max((at(p, k) for p in parts), default=-math.inf)
            case stl.Implies(p, q):
                return max(-at(p, k), at(q, k))
            case stl.Iff(p, q):
                return min(max(-at(p, k), at(q, k)), max(-at(q, k), at(p, k)))
            case stl.Xor(p, q):
                return max(min(at(p, k), -at(q, k)), min(-at(p, k), at(q, k)))
            case stl.Always(interval, p):
                return min((at(p, i) for i in self._ahead(k, interval)), default=math.inf)
            case stl.Eventually(interval, p):
                return max((at(p, i) for i in self._ahead(k, interval)), default=-math.inf)
            case stl.Historically(interval, p):
                return min((at(p, i) for i in self._behind(k, interval)), default=math.inf)
            case stl.Once(interval, p):
                return max((at(p, i) for i in self._behind(k, interval)), default=-math.inf)
            case stl.Until(interval, p, q):
                witnesses = self._ahead(k, interval)
                return max(
                    (min(at(q, i), *(at(p, j) for j in range(k, i)), math.inf) for i in witnesses),
                    default=-math.inf,
                )
            case stl.Since(interval, p, q):
                witnesses = self._behind(k, interval)
                return max(
                    (
                        min(at(q, i), *(at(p, j) for j in range(i + 1, k + 1)), math.inf)
                        for i in witnesses
                    ),
                    default=-math.inf,
                )
            case stl.Release(interval, p, q):
                return min(
                    (
                        max(at(q, i), *(at(p, j) for j in range(k, i)), -math.inf)
                        for i in self._ahead(k, interval)
                    ),
                    default=math.inf,
                )
            case stl.PastRelease(interval, p, q):
                return min(
                    (
                        max(at(q, i), *(at(p, j) for j in range(i + 1, k + 1)), -math.inf)
                        for i in self._behind(k, interval)
                    ),
                    default=math.inf,
                )
            case stl.WeakUntil(interval, p, q):
                hi = interval.hi if interval else math.inf
                to_end = min(at(p, i) for i in self._ahead(k, stl.Interval(0, hi)))
                return max(at(stl.Until(interval, p, q), k), to_end)
            case stl.WeakSince(interval, p, q):
                hi = interval.hi if interval else math.inf
                to_end = min(at(p, i) for i in self._behind(k, stl.Interval(0, hi)))
                return max(at(stl.Since(interval, p, q), k), to_end)
            case stl.Next(_, p):
                return at(p, k + 1) if self._is_sample(k + 1) else -math.inf
            case stl.Prev(_, p):
                return at(p, k - 1) if self._is_sample(k - 1) else -math.inf
            case stl.Rise(_, p):
                return min(at(p, k), -at(p, k - 1) if self._is_sample(k - 1) else math.inf)
            case stl.Fall(_, p):
                return min(-at(p, k), at(p, k - 1) if self._is_sample(k - 1) else math.inf)
            case stl.Count(interval, p, op, amount):
                weighed = [(at(p, i), 1.0) for i in self._on_one_lap(k, interval)]
                return _compared(weighed, op, amount)
            case AtLeast():
                return at(formula.measured, k)
            case stl.Duration(interval, p, op, amount):
                weighed = [(at(p, i), self._lasts(k, i, interval)) for i in
                           self._on_one_lap(k, interval)]  # fmt: skip
                return _compared(weighed, op, amount)
        raise TypeError(formula)

    def _on_one_lap(self, k: int, interval: stl.Interval | None) -> list[int]:
        """The samples of a window, none of them twice."""
        return self._ahead(k, interval)[: len(self.positions)]

    def _lasts(self, k: int, i: int, interval: stl.Interval | None) -> float:
        """From a sample to the next one, the end of the window or that of the trace."""
        following = self._position(i + 1) if self._is_sample(i + 1) else self._position(i)
        if interval is not None:
            longest = (
                interval.hi if self.wrap is None else min(interval.hi, interval.lo + self.wrap)
            )
            following = min(following, self._position(k) + longest)
        return max(following - self._position(i), 0.0)

    def _is_sample(self, k: int) -> bool:
        return self.wrap is not None or 0 <= k < len(self.positions)

    def _position(self, k: int) -> float:
        laps, sample = divmod(k, len(self.positions))
        return self.positions[sample] + (laps * self.wrap if self.wrap is not None else 0.0)

    def _ahead(self, k: int, interval: stl.Interval | None) -> list[int]:
        lo, hi = (interval.lo, interval.hi) if interval else (0.0, math.inf)
        return [i for i in self._reachable(k, lo, hi, +1) if i >= k and self._in(k, i, lo, hi, +1)]

    def _behind(self, k: int, interval: stl.Interval | None) -> list[int]:
        lo, hi = (interval.lo, interval.hi) if interval else (0.0, math.inf)
        return [i for i in self._reachable(k, lo, hi, -1) if i <= k and self._in(k, i, lo, hi, -1)]

    def _reachable(self, k: int, lo: float, hi: float, way: int) -> range:
        if self.wrap is None:
            return range(len(self.positions))
        far = hi if math.isfinite(hi) else lo + self.wrap
        steps = len(self.positions) * (math.ceil(far / self.wrap) + 1)
        return range(k, k + steps) if way > 0 else range(k - steps, k + 1)

    def _in(self, k: int, i: int, lo: float, hi: float, way: int) -> bool:
        own, other = self._position(k), self._position(i)
        near, far = own + way * lo, own + way * hi
        if way > 0:
            return other >= near - _slack(near) and (math.isinf(hi) or other <= far + _slack(far))
        return other <= near + _slack(near) and (math.isinf(hi) or other >= far - _slack(far))

    def _term(self, term: stl.Term, k: int) -> float:
        match term:
            case stl.Constant(value):
                return value
            case stl.Variable(name):
                return float(self.signals[name][k % len(self.positions)])
            case stl.Negate(operand):
                return -self._term(operand, k)
            case stl.Apply(function, arguments):
                values = [self._term(argument, k) for argument in arguments]
                return {"abs": lambda: abs(values[0]), "min": lambda: min(values),
                        "max": lambda: max(values)}[function]()  # fmt: skip
            case stl.Arithmetic(op, left, right):
                x, y = self._term(left, k), self._term(right, k)
                operators: dict[str, Callable[[], float]] = {
                    "+": lambda: x + y,
                    "-": lambda: x - y,
                    "*": lambda: x * y,
                    "/": lambda: _quotient(x, y),
                    "^": lambda: float(x**y),
                }
                return _number(operators[op]())
        raise TypeError(term)


def _compared(weighed: list[tuple[float, float]], op: str, amount: float) -> float:
    """The greatest level that is held long enough, or minus that."""
    if op in ("<", "<="):
        return -_compared(weighed, ">=" if op == "<" else ">", amount)
    slack = 1e-7

    def is_enough(weight: float) -> bool:
        return weight > amount + slack if op == ">" else weight >= amount - slack

    if is_enough(0.0):
        return math.inf
    levels = {level for level, _ in weighed}
    return max(
        (level for level in levels if is_enough(sum(w for v, w in weighed if v >= level))),
        default=-math.inf,
    )


def _quotient(x: float, y: float) -> float:
    return x / y if y else x * math.inf


def _number(value: float) -> float:
    """inf - inf, 0 inf, inf / inf and 0 / 0 are 0."""
    return 0.0 if math.isnan(value) else value


def _margin(op: str, x: float, y: float) -> float:
    if op in ("<", "<="):
        return _number(y - x)
    if op in (">", ">="):
        return _number(x - y)
    return -_number(abs(x - y)) if op == "==" else _number(abs(x - y))


def _truth(op: str, x: float, y: float) -> float:
    holds = {"<": x < y, "<=": x <= y, ">": x > y, ">=": x >= y, "==": x == y, "!=": x != y}[op]
    return 1.0 if holds else -1.0


def _slack(bound: float) -> float:
    return 1e-9 * max(1.0, abs(bound))
