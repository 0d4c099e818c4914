"""Temporal operators that look at nothing, as all their windows begin after the end of a trace."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..formula import formulas as f
from ..formula.normal_form import normal_form
from .axis import SamplePositions
from .trace import FloatArray


@dataclass(frozen=True)
class TraceEnd:
    """The end of a trace that does not continue, counted from its start. `samples` (S,): where
    operators are evaluated; None: at any moment. `tolerance`: how far beyond it a window may
    begin."""

    end: float
    tolerance: float
    samples: FloatArray | None = None

    @classmethod
    def of(cls, axis: SamplePositions) -> TraceEnd:
        """Of samples; a closed road has no end."""
        end = np.inf if axis.wrap is not None else float(axis.positions[-1])
        return cls(end, axis.tolerance, axis.positions)

    def operators_beyond(self, formula: f.Formula) -> tuple[f.TemporalOperator, ...]:
        """The operators of `formula` whose windows all begin after the end."""
        return tuple(dict.fromkeys(self._beyond(formula, 0.0)))

    def reversed(self, formula: f.Formula) -> f.Formula:
        """The formula with these operators counted the other way: `always` false, others true."""
        plain = normal_form(formula)
        beyond = frozenset(self.operators_beyond(plain))
        return _replaced(plain, beyond) if beyond else formula

    def _beyond(self, formula: f.Formula, earliest: float) -> Iterator[f.TemporalOperator]:
        """`earliest`: the first moment at which the formula is evaluated."""
        first = last = earliest
        if isinstance(formula, f.TemporalOperator) and formula.past:
            # Without an interval, and for the sample before, back to the start at most.
            first = last = max(0.0, earliest - formula.window.hi) if formula.window else 0.0
        elif isinstance(formula, f.TemporalOperator) and formula.window is not None:
            last = self._sample(earliest + formula.window.lo)
            if last > self.end + self.tolerance:
                yield formula
                return
            if not isinstance(formula, f.BinaryTemporal):
                first = last
        parts = formula.parts
        for number, part in enumerate(parts):
            yield from self._beyond(part, last if number == len(parts) - 1 else first)

    def _sample(self, moment: float) -> float:
        """The first sample from `moment` on, where there is one."""
        if self.samples is None:
            return moment
        index = int(np.searchsorted(self.samples, moment - self.tolerance))
        return moment if index == self.samples.size else float(self.samples[index])


def _replaced(formula: f.Formula, beyond: frozenset[f.TemporalOperator]) -> f.Formula:
    if isinstance(formula, f.TemporalOperator) and formula in beyond:
        return f.Truth(not (isinstance(formula, f.UnaryTemporal) and formula.least))
    if not isinstance(formula, f.Compound):
        return formula
    return formula.with_parts([_replaced(part, beyond) for part in formula.parts])
