"""Random formulas and traces for the property tests, as functions of a seed."""

from __future__ import annotations

import math
import random
from typing import TypeVar, get_args

import numpy as np
from numpy.typing import NDArray

from roadlang import stl
from roadlang.stl.formula.formulas import (
    COMPOUNDS,
    BinaryTemporal,
    ComparisonOperator,
    Compound,
    Connective,
    LogicalJunction,
    Measured,
    Pointwise,
    SampleStep,
    TemporalOperator,
    TruthChange,
)
from roadlang.stl.formula.measures import MeasureComparison
from roadlang.stl.formula.terms import ArithmeticOperator
from roadlang.syntax.operators import BY_WORD

Shape = TypeVar("Shape", bound=Compound)

NAMES = ("x", "y", "z")


class FormulaDraw:
    """Draws formulas: with `past` operators or not, with `corners` (truth values, equality, bounds
    between samples) or not; `bounded` leaves out infinite intervals and products of signals;
    `divisions` have quotients, whose divisor may be 0;
    `contextual`: with the operators that are words only where they fit.
    """

    def __init__(
        self,
        seed: int,
        *,
        past: bool = True,
        corners: bool = True,
        bounded: bool = False,
        divisions: bool = False,
        contextual: bool = True,
    ) -> None:
        self.random = random.Random(seed)
        self.divisions, self.contextual = divisions, contextual
        self.past, self.corners, self.bounded = past, corners, bounded
        self.step = 0.5

    def formula(self, depth: int) -> stl.Formula:
        if depth == 0:
            return self._leaf()
        return self.random.choice([self._logic, self._temporal, self._temporal])(depth - 1)

    def term(self, depth: int = 1) -> stl.Term:
        draw = self.random
        if depth == 0 or draw.random() < 0.5:
            if draw.random() < 0.8:
                return stl.Variable(draw.choice(NAMES))
            return stl.Constant(float(draw.randint(-3, 3)))
        kind = draw.randrange(4)
        if kind == 0:
            return stl.Negate(stl.Variable(draw.choice(NAMES)))
        if kind == 1:
            return stl.Apply("abs", (self.term(depth - 1),))
        if kind == 2:
            return stl.Apply(draw.choice(["min", "max"]), (self.term(depth - 1), self.term(0)))
        ops: list[ArithmeticOperator] = ["+", "-"] if self.bounded else ["+", "-", "*"]
        if self.divisions:
            ops += ["/", "/"]
        return stl.Arithmetic(draw.choice(ops), self.term(depth - 1), self.term(0))

    def interval(self) -> stl.Interval | None:
        draw = self.random
        if not self.bounded and draw.random() < 0.25:
            return None
        lo = self.step * draw.choice([0, 0, 1, 2, 3, 7])
        if self.corners and not self.bounded and draw.random() < 0.1:
            return stl.Interval(lo, math.inf)
        if self.corners and draw.random() < 0.15:
            lo += 0.3 * self.step
        return stl.Interval(lo, lo + self.step * draw.choice([0, 1, 2, 4, 9, 30]))

    def _leaf(self) -> stl.Formula:
        draw = self.random
        if self.corners and draw.random() < 0.05:
            return stl.Truth(draw.random() < 0.5)
        ops: list[ComparisonOperator] = ["<", "<=", ">", ">="]
        if self.corners:
            ops += ["==", "!="]
        right = stl.Constant(float(draw.randint(-2, 2)))
        return stl.Comparison(draw.choice(ops), self.term(), right)

    def _logic(self, depth: int) -> stl.Formula:
        draw = self.random
        kind = draw.choice(self._of_shape(Pointwise))
        if issubclass(kind, LogicalJunction):
            parts = [self.formula(draw.randint(0, depth)) for _ in range(draw.randint(2, 3))]
            return kind.of(parts)
        if issubclass(kind, Connective):
            return kind.of([self.formula(depth), self.formula(draw.randint(0, depth))])
        return kind.of([self.formula(depth)])

    def _temporal(self, depth: int) -> stl.Formula:
        draw = self.random
        kinds = self._of_shape(TemporalOperator)
        kind = draw.choice([kind for kind in kinds if self.past or not kind.past])
        if issubclass(kind, BinaryTemporal):
            sides = [self.formula(draw.randint(0, depth)), self.formula(depth)]
            return kind.of(sides, self.interval())
        if issubclass(kind, Measured):
            steps = 1.0 if kind.counts else self.step
            amounts = [steps * amount for amount in (0, 1, 2, 2.5, 3, 6)]
            op, amount = draw.choice(list(get_args(MeasureComparison))), draw.choice(amounts)
            return kind(self.interval(), self.formula(depth), op, float(amount))
        if issubclass(kind, SampleStep | TruthChange):
            return kind.of([self.formula(depth)])
        return kind.of([self.formula(depth)], self.interval())

    def _of_shape(self, shape: type[Shape]) -> list[type[Shape]]:
        return [
            kind
            for word, kind in COMPOUNDS.items()
            if issubclass(kind, shape) and (self.contextual or not BY_WORD[word].contextual)
        ]


def draw_trace(
    seed: int, samples: int, variants: int, *, even: bool, step: float = 0.5
) -> tuple[NDArray[np.float64], dict[str, NDArray[np.float64]]]:
    """Positions (S,) and signals x, y, z (V, S); some values are whole numbers, so ties occur."""
    rng = np.random.default_rng(seed)
    if even:
        positions = np.asarray(3.0 + step * np.arange(samples), np.float64)
    else:
        positions = np.cumsum(rng.choice([0.1, 0.25, 0.5, 0.5, 0.7, 2.0], size=samples))
    signals = {name: rng.normal(0, 2, size=(variants, samples)) for name in NAMES}
    signals["y"] = np.round(signals["y"])
    return positions, signals
