"""`when:` and `while:` conditions of many agents at once, evaluated step by step."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Mapping
from copy import copy
from typing import Any

import numpy as np

from ... import stl
from ...diagnostics import Code, DiagnosticError, diagnose
from ...geometry.arrays import Booleans, Floats, Integers
from ...stl.evaluate.graph_operations import OF_INFINITIES, TERM_FUNCTIONS

Signal = Callable[[str], Floats]
"""(R,) the values now of a variable of the formula"""
_SOON = 1e-9
"""Seconds by which sums of time steps may differ."""


class ControllerCondition:
    """One formula for R agents. `numbers`: (R,) for each variable that is a number."""

    def __init__(self, formula: Any, numbers: Mapping[str, Floats], count: int) -> None:
        self.formula = stl.normal_form(stl.from_json(formula))
        self.numbers = dict(numbers)
        self._count = count
        self._past: dict[tuple[int, ...], deque[tuple[float, Booleans, Booleans]]] = {}
        self._power = _power_in(self.formula)

    def now(self, time: float, signal: Signal) -> Booleans:
        """(R,) whether it holds now. To be evaluated at every step, in order. Raises RL513."""
        if self._power is not None:
            raise unsupported(self._power)
        values: dict[str, Floats] = {}

        def value(name: str) -> Floats:
            if name not in values:
                values[name] = self.numbers[name] if name in self.numbers else signal(name)
            return values[name]

        return self._truth(self.formula, (), time, value)

    @property
    def is_pointwise(self) -> bool:
        """Whether its truth at a sample depends on that sample alone."""
        return not _has_memory(self.formula)

    def at_once(self, count: int, signal: Signal) -> Booleans:
        """(K, R) whether it holds at each of `count` samples, of a formula that is pointwise.
        `signal` gives (K, R). Raises RL513."""
        each = copy(self)
        each._count = count * self._count
        each.numbers = {name: np.tile(column, count) for name, column in self.numbers.items()}
        return each.now(0.0, lambda name: signal(name).ravel()).reshape(count, self._count)

    def carry_on(self, agent: int, before: ControllerCondition, at: int) -> None:
        """What was true of one agent of the same formula was true of this one."""
        for place, past in before._past.items():
            times = [time for time, _, _ in past]
            mine = self._past.get(place)
            if mine is None or [time for time, _, _ in mine] != times:
                false = np.zeros(self._count, dtype=bool)
                mine = self._past[place] = deque((t, false.copy(), false.copy()) for t in times)
            for (_, first, last), (_, was_first, was_last) in zip(mine, past, strict=True):
                first[agent], last[agent] = was_first[at], was_last[at]

    def take(self, rows: Integers) -> None:
        """From now on it is about these of its agents alone."""
        self._count = len(rows)
        self.numbers = {name: column[rows] for name, column in self.numbers.items()}
        for place, past in self._past.items():
            self._past[place] = deque((t, first[rows], last[rows]) for t, first, last in past)

    def _truth(
        self, formula: stl.Formula, place: tuple[int, ...], time: float, value: Signal
    ) -> Booleans:
        match formula:
            case stl.Truth(truth):
                return np.full(self._count, truth)
            case stl.Comparison(op, left, right):
                sides = [term_values(side, value, self._count) for side in (left, right)]
                return np.asarray(_COMPARE[op](*sides))
            case stl.TemporalOperator() if not formula.past:
                raise unsupported(formula.word)
        # Every part is evaluated at every step: what lies in the past is remembered there.
        parts = [
            self._truth(part, (*place, number), time, value)
            for number, part in enumerate(formula.parts)
        ]
        match formula:
            case stl.Not():
                return ~parts[0]
            case stl.LogicalJunction():
                start = np.full(self._count, formula.least)
                join = np.logical_and if formula.least else np.logical_or
                return np.asarray(join.reduce([start, *parts]))
            case stl.SampleStep():
                before = self._past.get(place) or ((0.0, np.zeros(self._count, dtype=bool)),)
                self._past[place] = deque([(time, parts[0], parts[0])])
                return before[0][1]
            case stl.UnaryTemporal(interval) | stl.BinaryTemporal(interval):
                return self._window(formula, parts, interval, place, time)
        raise unsupported(str(formula))

    def _window(
        self,
        formula: Any,
        parts: list[Booleans],
        interval: stl.Interval | None,
        place: tuple[int, ...],
        time: float,
    ) -> Booleans:
        low, high = (0.0, math.inf) if interval is None else (interval.lo, interval.hi)
        past = self._past.setdefault(place, deque())
        past.append((time, parts[0], parts[-1]))
        while past[0][0] < time - high - _SOON:
            past.popleft()
        if isinstance(formula, stl.BinaryTemporal):
            return _since(past, time - low + _SOON, self._count)
        inside = [last for moment, _, last in past if moment <= time - low + _SOON]
        join = np.logical_and if formula.least else np.logical_or
        return np.asarray(join.reduce([np.full(self._count, formula.least), *inside]))


def _has_memory(formula: stl.Formula) -> bool:
    if isinstance(formula, (stl.SampleStep, stl.UnaryTemporal, stl.BinaryTemporal)):
        return True
    parts = () if isinstance(formula, stl.Comparison) else formula.parts
    return any(_has_memory(part) for part in parts)


def term_values(term: stl.Term, value: Signal, count: int) -> Floats:
    """(R,) a term of a formula, of R agents, by the functions of `stl`: equal infinities are 0
    apart. Raises RL307 for the root of a negative number."""
    match term:
        case stl.Constant(number):
            return np.full(count, float(number))
        case stl.Variable(name):
            return value(name)
    parts = [term_values(part, value, count) for part in term.parts]
    match term:
        case stl.Negate():
            return -parts[0]
        case stl.Arithmetic(name) | stl.Apply(name):
            return np.asarray(_TERM_FUNCTIONS[name](*parts))
    raise TypeError(f"not a term: {term!r}")


def _power_in(formula: stl.Formula) -> str | None:
    """The first power in a formula, which no engine evaluates in conditions of controllers."""
    sides = (side for part in formula.walk() if isinstance(part, stl.Comparison)
             for side in (part.left, part.right))  # fmt: skip
    powers = (term for side in sides for term in side.walk()
              if isinstance(term, stl.Arithmetic) and term.op == "^")  # fmt: skip
    return next(map(str, powers), None)


def _since(past: deque[tuple[float, Booleans, Booleans]], latest: float, count: int) -> Booleans:
    """Whether the last part held at a moment no later than `latest`, and the first ever since."""
    found = np.zeros(count, dtype=bool)
    unbroken = np.ones(count, dtype=bool)
    for moment, first, last in reversed(past):
        if moment <= latest:
            found |= unbroken & last
        unbroken &= first
    return found


def unsupported(what: str) -> DiagnosticError:
    """RL513: the engine cannot evaluate this step by step."""
    engine = "the embedded engine"
    return DiagnosticError(diagnose(Code.UNSUPPORTED_CONDITION, what=what, engine=engine))


_COMPARE: dict[str, Callable[[Floats, Floats], Any]] = {
    "<": np.less,
    "<=": np.less_equal,
    ">": np.greater,
    ">=": np.greater_equal,
    "==": np.equal,
    "!=": np.not_equal,
}
_TERM_FUNCTIONS = {
    name: OF_INFINITIES.get(function, function) for name, function in TERM_FUNCTIONS.items()
}
