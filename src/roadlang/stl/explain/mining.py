"""Parameter mining: the tightest thresholds and intervals with which a formula still holds."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from ...diagnostics import Code, DiagnosticError, arguments
from ..errors import stl_error
from ..formula import formulas as f
from .loosest_corner import corners, loosest_corner
from .parameter_values import with_values
from .parameters import Parameter, Recording, checked

_Found = TypeVar("_Found")

_STEPS, _PROBES = 60, 15
_FINEST = 1e-12
"""The least difference of values that is looked at, as a share of the bounds of a parameter."""
_WIDEN = "widen the bounds; `roadlang monitor` shows where a trace violates the formula"
_CUT_OFF = (
    "only the unknown future of a trace prevents it: `--unknown-holds` (`unknown_holds=True`) "
    "counts as holding what a longer trace could still make hold"
)


@dataclass(frozen=True)
class Mined:
    """`values` make `formula` hold on every trace; `rho` is the least robustness then.

    `at_bound` are the parameters that could go no further within their bounds. `not_monotone` are
    those of whose values some hold beyond one that does not: the value is then one boundary of
    several.
    """

    values: Mapping[str, float]
    formula: f.Formula
    rho: float
    at_bound: tuple[str, ...]
    not_monotone: tuple[str, ...] = ()


def mine(
    text: str,
    parameters: Sequence[Parameter],
    recordings: Iterable[Recording],
    *,
    margin: float | None = None,
    digits: int = 6,
    unknown_holds: bool = False,
) -> Mined:
    """Tighten the parameters, one after the other, as far as `text` holds on all recordings.

    A formula holds if it is satisfied at the start (or, with `margin`, has that much robustness);
    with `unknown_holds`, also where a recording that goes on could still satisfy it, so that
    windows cut off by the end of a recording do not count against it. Values that make an
    interval end before it starts do not hold. The formula should be monotone in each parameter:
    then its boundary is found by bisection to `digits` significant digits, but no finer than 1e-12
    of the distance of its bounds, and the value returned is on the side that holds. Of several
    parameters the first is made tightest, then the second given the first, and so on.

    Raises DiagnosticError RL341 where no corner of the box of parameters holds, RL342 for wrong
    parameters.
    """
    search = _search(text, parameters, recordings, margin, unknown_holds)
    digits = arguments.whole_number("digits", digits, least=1)
    corner = search.loosest()
    return _tightened(search, corner, corner, parameters, digits)


def mine_front(
    text: str,
    parameters: Sequence[Parameter],
    recordings: Iterable[Recording],
    *,
    points: int = 11,
    margin: float | None = None,
    digits: int = 6,
    unknown_holds: bool = False,
) -> tuple[Mined, ...]:
    """The Pareto front: sets of parameters that hold, none of which is tighter in all of them.

    The first parameter takes at most `points` values between its tightest and its loosest one;
    at each of them the others are tightened in order. The rest as for `mine`.
    """
    search = _search(text, parameters, recordings, margin, unknown_holds)
    digits = arguments.whole_number("digits", digits, least=1)
    points = arguments.whole_number("points", points, least=2)
    first, *others = parameters
    corner = search.loosest()
    tightest = _tightened(search, corner, corner, parameters, digits)
    front = [tightest]
    for place in np.linspace(tightest.values[first.name], corner[first.name], points)[1:]:
        start = {**corner, first.name: float(place)}
        if not search.holds(start):
            continue
        found = _tightened(search, start, corner, others, digits)
        if any(found.values[other.name] != front[-1].values[other.name] for other in others):
            front.append(found)
    return tuple(front)


def _search(
    text: str,
    parameters: Sequence[Parameter],
    recordings: Iterable[Recording],
    margin: float | None,
    unknown_holds: bool,
) -> _ParameterSearch:
    pairs = checked(text, parameters, recordings)
    if margin is not None:
        margin = arguments.number("margin", margin)
    return _ParameterSearch(text, tuple(parameters), pairs, margin, unknown_holds)


def _tightened(
    search: _ParameterSearch,
    start: Mapping[str, float],
    corner: Mapping[str, float],
    parameters: Sequence[Parameter],
    digits: int,
) -> Mined:
    """`parameters` tightened in order from values that hold, away from the loosest `corner`."""
    values = dict(start)
    at_bound, not_monotone = [], []
    for parameter in parameters:
        name, loose = parameter.name, values[parameter.name]
        tight = parameter.low + parameter.high - corner[name]
        if search.holds({**values, name: tight}):
            values[name] = failing = tight
            at_bound.append(name)
        else:
            values[name], failing = search.boundary(values, name, tight, digits)
        if not search.is_monotone(values, name, loose, failing, tight):
            not_monotone.append(name)
    formula, rho = search.formula(values), search.rho(values)
    return Mined(values, formula, rho, tuple(at_bound), tuple(not_monotone))


class RecordingError(DiagnosticError):
    """A formula cannot be evaluated on a recording; `recording` is its place among `count`."""

    recording, count = 0, 1

    @property
    def details(self) -> str:
        """Which recording it is, where there are several."""
        return f"in `recordings[{self.recording}]`" if self.count > 1 else ""


@dataclass(frozen=True)
class _ParameterSearch:
    text: str
    parameters: tuple[Parameter, ...]
    recordings: tuple[Recording, ...]
    margin: float | None
    unknown_holds: bool

    def formula(self, values: Mapping[str, float]) -> f.Formula:
        return with_values(self.text, values)

    def rho(self, values: Mapping[str, float]) -> float:
        formula = self.formula(values)
        return min(self._on_each(lambda recording: float(np.min(formula.rho(*recording)))))

    def holds(self, values: Mapping[str, float]) -> bool:
        """Whether the formula with these values holds; one without a meaning does not."""
        try:
            formula = self.formula(values)
        except DiagnosticError as error:
            if _is_of_interval(error):
                return False
            raise
        return all(self._on_each(lambda recording: self._holds_on(formula, recording)))

    def _on_each(self, measure: Callable[[Recording], _Found]) -> Iterator[_Found]:
        """Raises RecordingError."""
        for place, recording in enumerate(self.recordings):
            try:
                yield measure(recording)
            except DiagnosticError as error:
                named = RecordingError(*error.diagnostics)
                named.recording, named.count = place, len(self.recordings)
                raise named from None

    def _holds_on(self, formula: f.Formula, recording: Recording) -> bool:
        if self.margin is not None and self.unknown_holds:
            return bool(np.all(formula.range(*recording).hi >= self.margin))
        if self.margin is not None:
            return bool(np.all(formula.rho(*recording) >= self.margin))
        if self.unknown_holds:
            return bool(np.all(np.asarray(formula.verdict(*recording)) != "violated"))
        return bool(np.all(formula.satisfied(*recording)))

    def loosest(self) -> Mapping[str, float]:
        """A corner of the box at which the formula holds; the greatest robustness decides."""
        holding = self._holding_corners()
        if not holding:
            forgiving = replace(self, unknown_holds=True)
            is_cut_off = not self.unknown_holds and bool(forgiving._holding_corners())
            help = _CUT_OFF if is_cut_off else _WIDEN
            raise stl_error(Code.UNSATISFIABLE_TEMPLATE, formula=self.text, help=help)
        return loosest_corner(self.parameters, holding, self._rho_if_any)

    def _holding_corners(self) -> list[Mapping[str, float]]:
        return [values for values in corners(self.parameters) if self.holds(values)]

    def _rho_if_any(self, values: Mapping[str, float]) -> float:
        """-inf where an interval ends before it starts."""
        try:
            return self.rho(values)
        except DiagnosticError as error:
            if _is_of_interval(error):
                return -math.inf
            raise

    def is_monotone(
        self, values: Mapping[str, float], name: str, loose: float, failing: float, tight: float
    ) -> bool:
        """Whether all values of a few between `loose` and the one found hold, and none beyond the
        `failing` one next to it."""
        found = values[name]
        between = np.linspace(loose, found, _PROBES + 2)[1:-1].tolist()
        beyond = np.linspace(failing, tight, _PROBES + 2)[:-1].tolist() if found != tight else []
        return all(self.holds({**values, name: value}) for value in between) and not any(
            self.holds({**values, name: value}) for value in beyond
        )

    def boundary(
        self, values: Mapping[str, float], name: str, failing: float, digits: int
    ) -> tuple[float, float]:
        """The last value that holds, and the one next to it that does not."""
        holding, finest = values[name], _FINEST * abs(values[name] - failing)
        for _ in range(_STEPS):
            middle = holding / 2 + failing / 2
            if holding * failing < 0:  # else a boundary at 0 would be met by no bisection
                middle = 0.0
            middle = _rounded(middle, abs(holding - failing), digits, finest)
            if middle in (holding, failing):
                break
            if self.holds({**values, name: middle}):
                holding = middle
            else:
                failing = middle
        return holding, failing


def _rounded(value: float, width: float, digits: int, finest: float) -> float:
    """`value` to `digits` significant digits, or fewer where the bracket is still wide or the last
    of them is worth less than `finest`."""
    if value == 0 or width == 0:
        return value
    places = digits - 1 - math.floor(math.log10(max(abs(value), width)))
    return round(value, min(places, math.ceil(-math.log10(finest))))


def _is_of_interval(error: DiagnosticError) -> bool:
    return {diagnostic.code for diagnostic in error.diagnostics} == {Code.INVALID_INTERVAL}
