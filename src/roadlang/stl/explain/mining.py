"""Parameter mining: the tightest thresholds and intervals with which a formula still holds."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from ...diagnostics import Code
from ..errors import stl_error
from ..evaluate.trace import Positions, Signals
from ..formats.text import parse
from ..formula import formulas as f
from ..formula.terms import number_text

Recording = tuple[Positions, Signals]

_STEPS = 60


@dataclass(frozen=True)
class Parameter:
    """A name in the text of a formula that stands for a number between `low` and `high`."""

    name: str
    low: float
    high: float


@dataclass(frozen=True)
class Mined:
    """`values` make `formula` hold on every trace; `rho` is the least robustness then.

    `at_bound` are the parameters that could go no further within their bounds.
    """

    values: Mapping[str, float]
    formula: f.Formula
    rho: float
    at_bound: tuple[str, ...]


def mine(
    text: str,
    parameters: Sequence[Parameter],
    recordings: Iterable[Recording],
    *,
    margin: float | None = None,
    digits: int = 6,
) -> Mined:
    """Tighten the parameters, one after the other, as far as `text` holds on all recordings.

    A formula holds if it is satisfied at the start (or, with `margin`, has that much robustness).
    It must be monotone in each parameter: then its boundary is found by bisection to `digits`
    significant digits, and the value returned is on the side that holds. Of several parameters the
    first is made tightest, then the second given the first, and so on. Raises DiagnosticError
    RL341 where no corner of the box of parameters holds, RL342 for wrong parameters.
    """
    search = _ParameterSearch(text, tuple(parameters), tuple(recordings), margin)
    search.check()
    values, ends = search.loosest()
    at_bound = []
    for parameter in parameters:
        tight = parameter.low + parameter.high - ends[parameter.name]
        if search.holds({**values, parameter.name: tight}):
            values[parameter.name] = tight
            at_bound.append(parameter.name)
        else:
            values[parameter.name] = search.boundary(values, parameter.name, tight, digits)
    return Mined(dict(values), search.formula(values), search.rho(values), tuple(at_bound))


@dataclass(frozen=True)
class _ParameterSearch:
    text: str
    parameters: tuple[Parameter, ...]
    recordings: tuple[Recording, ...]
    margin: float | None

    def check(self) -> None:
        """Each parameter has finite bounds in order and occurs in the text."""
        if not self.recordings:
            raise stl_error(Code.EMPTY_TRACE)
        for parameter in self.parameters:
            name, low, high = parameter.name, parameter.low, parameter.high
            if not (math.isfinite(low) and math.isfinite(high) and low < high):
                problem = f"its bounds are {number_text(low)} and {number_text(high)}"
                raise stl_error(Code.INVALID_PARAMETER, name=name, problem=problem)
            if not _word(name).search(self.text):
                raise stl_error(
                    Code.INVALID_PARAMETER, name=name, problem="the formula does not contain it"
                )

    def formula(self, values: Mapping[str, float]) -> f.Formula:
        text = self.text
        for name, value in values.items():
            shown = number_text(value)
            text = _word(name).sub(f"({shown})" if value < 0 else shown, text)
        return parse(text)

    def rho(self, values: Mapping[str, float]) -> float:
        formula = self.formula(values)
        return min(float(np.min(formula.rho(*recording))) for recording in self.recordings)

    def holds(self, values: Mapping[str, float]) -> bool:
        if self.margin is not None:
            return self.rho(values) >= self.margin
        formula = self.formula(values)
        return all(np.all(formula.satisfied(*recording)) for recording in self.recordings)

    def loosest(self) -> tuple[dict[str, float], dict[str, float]]:
        """A corner of the box at which the formula holds; the greatest robustness decides."""
        names = [parameter.name for parameter in self.parameters]
        corners = product(*((parameter.low, parameter.high) for parameter in self.parameters))
        holding = [
            values
            for corner in corners
            if self.holds(values := dict(zip(names, corner, strict=True)))
        ]
        if not holding:
            raise stl_error(Code.UNSATISFIABLE_TEMPLATE, formula=self.text)
        best = max(holding, key=self.rho)
        return dict(best), dict(best)

    def boundary(
        self, values: Mapping[str, float], name: str, failing: float, digits: int
    ) -> float:
        holding = values[name]
        for _ in range(_STEPS):
            middle = _rounded((holding + failing) / 2, abs(holding - failing), digits)
            if middle in (holding, failing):
                break
            if self.holds({**values, name: middle}):
                holding = middle
            else:
                failing = middle
        return holding


def _rounded(value: float, width: float, digits: int) -> float:
    """`value` to `digits` significant digits, or more where the bracket is still wide."""
    if value == 0 or width == 0:
        return value
    places = digits - 1 - math.floor(math.log10(max(abs(value), width)))
    return round(value, places)


def _word(name: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w.]){re.escape(name)}(?![\w.])")
