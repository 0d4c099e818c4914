"""Sampled signals, checked once: positions, shapes, names and finite values."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...diagnostics import Code, DiagnosticError, arguments
from ...diagnostics.nearest import nearest
from ..errors import stl_error
from ..formula.terms import name_text
from .position_text import position_text
from .windows import BoolArray

FloatArray: TypeAlias = NDArray[np.float64]
Positions: TypeAlias = ArrayLike
Signals: TypeAlias = Mapping[str, ArrayLike]


_UNIT = r"{}(\s*[\[(][^\[\]()]*[\])]|-.*)"
_ORDER = "sort the samples by position, and drop those that repeat one or have none"
_FILL = "drop the samples without a value (positions may be uneven), or fill them in"
_OWN_GRID = "signals with grids of their own need `semantics`: `held` or `linear`"


class InfiniteSignal(Exception):
    """A signal has an infinite sample: it is evaluated by functions that are slower."""


@dataclass(frozen=True)
class SampledSignals:
    """`positions` (S,), strictly increasing; each signal (r, n), r in {1, V}, n in {1, S}.

    `batched` is False when no signal had two dimensions, whether the formula reads it or not;
    results then lose the variant axis.
    `wrap` is the length of a closed road, or None.
    """

    positions: FloatArray
    signals: Mapping[str, NDArray[np.generic]]
    variants: int
    batched: bool
    wrap: float | None = None
    constants: frozenset[str] = frozenset()
    """The signals that are one number per variant, at every sample now and later."""

    @classmethod
    def of(
        cls,
        positions: Positions,
        signals: Signals,
        names: Iterable[str],
        wrap: float | None = None,
    ) -> SampledSignals:
        """Check the signals called `names`. Raises DiagnosticError RL300 to RL306."""
        names = sorted(names)
        arguments.mapping("signals", signals, keys=names)
        stations = checked_positions(positions)
        checked = {name: _checked_signal(name, signals, stations) for name in names}
        variants = _variants(signals)
        _check_wrap(wrap, stations)
        return cls(
            positions=stations,
            signals={name: np.atleast_2d(array) for name, array in checked.items()},
            variants=variants or 1,
            batched=variants is not None,
            wrap=wrap,
            constants=frozenset(
                name
                for name, array in checked.items()
                if array.ndim == 0 or array.shape[-1] == 1 < stations.size
            ),
        )

    @property
    def samples(self) -> int:
        """How many samples there are."""
        return int(self.positions.size)

    def rows(self, name: str, first: int, last: int) -> FloatArray:
        """Variants first..last-1 of a signal, shape (r, n). Raises RL302 for NaN."""
        return self._rows(name, first, last)[0]

    def finite_rows(self, name: str, first: int, last: int) -> FloatArray:
        """As `rows`. Raises `InfiniteSignal` where they are not finite."""
        values, has_finite_sum = self._rows(name, first, last)
        if not has_finite_sum and np.isinf(values).any():
            raise InfiniteSignal
        return values

    def _rows(self, name: str, first: int, last: int) -> tuple[FloatArray, bool]:
        """Variants first..last-1, and whether their sum says that all are finite."""
        array = self.signals[name]
        part = array if array.shape[0] == 1 else array[first:last]
        values = np.asarray(part, dtype=np.float64)
        with np.errstate(invalid="ignore", over="ignore"):  # infinities of both signs
            has_finite_sum = math.isfinite(np.add.reduce(values, axis=None))
        if not has_finite_sum:
            _check_numbers(name, values, first, self.positions)
        return values, has_finite_sum

    def check(self) -> None:
        """Read every signal once. Raises DiagnosticError RL302 for a value that is not a number."""
        for name in self.signals:
            self.rows(name, 0, self.variants)

    def unchecked(self, name: str, first: int, last: int) -> FloatArray:
        """Numbers per variant that need no check, shape (1, r)."""
        array = self.signals[name]
        part = array if array.shape[0] == 1 else array[first:last]
        return np.asarray(part, dtype=np.float64).T

    def alone(self, variant: int) -> SampledSignals:
        """The trace of one variant. Raises as `checked_variant`."""
        variant = checked_variant(variant, self.variants)
        chosen = {
            name: array if array.shape[0] == 1 else array[variant : variant + 1]
            for name, array in self.signals.items()
        }
        return SampledSignals(self.positions, chosen, 1, False, self.wrap, self.constants)


def checked_variant(variant: int, count: int) -> int:
    """The number of one of `count` variants. Raises TypeError for what is no integer, and
    DiagnosticError RL342 for one that is not there."""
    number = arguments.whole_number("variant", variant)
    if not 0 <= number < count:
        there = f"there are {count} variants" if count > 1 else "there is 1 variant"
        problem = f"it is {number}, but {there}, counted from 0"
        raise stl_error(Code.INVALID_PARAMETER, name="variant", problem=problem)
    return number


def _variants(signals: Signals) -> int | None:
    """How many variants the two-dimensional signals have; None where there is no such signal."""
    shapes = {name: _shape(values) for name, values in signals.items()}
    counts = {name: shape[0] for name, shape in shapes.items() if len(shape) == 2}
    if len(set(counts.values()) - {1}) > 1:
        found = ", ".join(f"`{name}` has {count}" for name, count in counts.items())
        raise stl_error(
            Code.WRONG_SIGNAL_SHAPE, what="the signals", expected="agree in variants", found=found
        )
    return max(counts.values(), default=None)


def _shape(values: ArrayLike) -> tuple[int, ...]:
    """That of an array; none of rows of different lengths, which are refused where they are
    read."""
    try:
        return np.shape(values)
    except ValueError:
        return ()


def checked_positions(positions: Positions) -> FloatArray:
    """Positions as a float array (S,). Raises DiagnosticError RL300 or RL301."""
    try:
        stations = np.asarray(_unmasked(positions), dtype=np.float64)
    except (TypeError, ValueError):
        raise stl_error(Code.INVALID_POSITIONS, problem="they are not numbers") from None
    if stations.ndim != 1:
        raise stl_error(
            Code.INVALID_POSITIONS, problem=f"their shape is {stations.shape}, not (S,)"
        )
    if stations.size == 0:
        raise stl_error(Code.EMPTY_TRACE)
    grows = stations[1:] > stations[:-1]
    # Where all grow, none is NaN, and only the ends can be infinite.
    if not (grows.all() and math.isfinite(stations[0]) and math.isfinite(stations[-1])):
        raise _wrong_positions(stations, grows)
    return stations


def _wrong_positions(stations: FloatArray, grows: BoolArray) -> DiagnosticError:
    if not np.isfinite(stations).all():
        index = int(np.argmin(np.isfinite(stations)))
        problem = f"position {index} is {stations[index]}"
        return stl_error(Code.INVALID_POSITIONS, problem=problem, help=_ORDER)
    index = int(np.argmin(grows))
    pair = " is followed by ".join(map(position_text, stations[index : index + 2]))
    problem = f"{pair} (sample {index + 1})"
    return stl_error(Code.INVALID_POSITIONS, problem=problem, help=_ORDER)


def _shown(name: str) -> str:
    text = name_text(name)
    return text if text.startswith("`") else f"`{text}`"


def _written(name: str) -> str:
    """A name as it has to be written: with the back quotes that it needs."""
    if name_text(name).startswith("`") or "(" in name:
        return f"`` `{name}` `` (in back quotes)"
    return f"`{name}`"


def _longer_name(name: str, signals: Signals) -> str | None:
    """The signal whose name is this one and a unit in brackets, `x [m]`, or begins with it and a
    hyphen, `x-left`, which was taken for a difference."""
    return next(
        (each for each in signals if re.fullmatch(_UNIT.format(re.escape(name)), each)), None
    )


def _checked_signal(name: str, signals: Signals, stations: FloatArray) -> NDArray[np.generic]:
    if name not in signals:
        known = ", ".join(map(_shown, sorted(signals))) or "none"
        meant = _longer_name(name, signals) or nearest(name, signals)
        hints = () if meant is None else (f"did you mean {_written(meant)}?",)
        help = (*hints, f"the signals given are: {known}")
        raise stl_error(Code.MISSING_SIGNAL, name=name, help=help)
    try:
        array = _unmasked(signals[name])
    except ValueError:
        raise stl_error(
            Code.WRONG_SIGNAL_SHAPE, what=f"`{name}`", expected="be an array",
            found="has rows of different lengths",
        ) from None  # fmt: skip
    if array.dtype.kind not in "fiub":
        raise stl_error(
            Code.WRONG_SIGNAL_SHAPE,
            what=f"`{name}`",
            expected="be numbers",
            found=_no_numbers(signals[name], array),
            help=_OWN_GRID if hasattr(signals[name], "positions") else (),
        )
    samples = stations.size
    if array.ndim > 2 or (array.ndim > 0 and array.shape[-1] not in (1, samples)):
        expected = f"have shape ({samples},), (V, {samples}) or (V, 1)"
        raise stl_error(
            Code.WRONG_SIGNAL_SHAPE, what=f"`{name}`", expected=expected, found=f"has {array.shape}"
        )
    if array.ndim == 2 and array.shape[0] == 0:
        raise stl_error(Code.EMPTY_TRACE)
    return array


def _no_numbers(values: ArrayLike, array: NDArray[np.generic]) -> str:
    """What an array of another type than numbers is, with the first text in it."""
    items = enumerate(values if isinstance(values, list) else array.reshape(-1))
    sample, text = next(((n, item) for n, item in items if isinstance(item, str)), (0, None))
    if text is None:
        return f"is of type {array.dtype}"
    return f"is {str(text)!r} {getattr(text, 'place', f'at sample {sample}')}"


def _unmasked(values: ArrayLike) -> NDArray[np.generic]:
    """As an array; masked values are NaN, which a formula that reads them refuses."""
    if isinstance(values, np.ma.MaskedArray):
        return np.ma.filled(values.astype(np.float64), np.nan)
    return np.asarray(values)


def _check_numbers(name: str, values: FloatArray, first: int, positions: FloatArray) -> None:
    """The sum overflowed, or a value is infinite or NaN: say where it is in the last case."""
    wrong = np.isnan(values)
    if not wrong.any():
        return
    row, column = (int(index) for index in np.argwhere(wrong)[0])
    place = "every position"
    if values.shape[1] > 1:
        place = f"position {position_text(positions[column])}"
    if values.shape[0] > 1:
        place += f" of variant {first + row}"
    value = values[row, column]
    raise stl_error(Code.NON_FINITE_SIGNAL, name=name, value=value, place=place, help=_FILL)


def _check_wrap(wrap: float | None, stations: FloatArray) -> None:
    length = float(stations[-1] - stations[0])
    if wrap is not None:
        wrap = arguments.number("wrap", wrap)
    if wrap is not None and not (np.isfinite(wrap) and wrap > length):
        raise stl_error(Code.INVALID_WRAP_LENGTH, wrap=f"{wrap:g}", length=f"{length:g}")
