"""What a node of an evaluation graph does: read, compute point by point, slide, reach."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from typing import ClassVar, Literal, TypeAlias

import numpy as np

from ...diagnostics import Code
from ..errors import stl_error
from ..formula.interval import Interval, Reach
from .sliding_and_until import Extreme
from .trace import FloatArray

Function: TypeAlias = Callable[..., FloatArray]


@dataclass(frozen=True)
class Read:
    """The signal of this name."""

    name: str


@dataclass(frozen=True)
class NumberOperation:
    """The same value at every sample."""

    value: float


@dataclass(frozen=True)
class PointwiseOperation:
    """`function` of the inputs, sample by sample."""

    function: Function


@dataclass(frozen=True)
class Sliding:
    """The extreme of the input in a window."""

    extreme: Extreme
    reach: Reach
    past: bool


@dataclass(frozen=True)
class Reaching:
    """The first input until (since, for `past`) the second."""

    interval: Interval | None
    past: bool


@dataclass(frozen=True)
class Measuring:
    """The greatest level that the input has at `amount` samples of a window (`counts`) or for that
    long, or (`strict`) more. `side`: as a bound, where samples are yet to come."""

    interval: Interval | None
    amount: float
    strict: bool
    counts: bool
    side: Literal["lower", "upper"] | None = None
    past: ClassVar[bool] = False


@dataclass(frozen=True)
class GivenNumbers:
    """Numbers per variant, infinite ones welcome, that are computed with the graph."""

    name: str


@dataclass(frozen=True)
class Extend:
    """The first input at the first `seen` samples, the second at the stand-ins after them."""

    seen: int


@dataclass(frozen=True)
class AtUnseen:
    """The first input; after the first `seen` samples joined with the second by `function`."""

    seen: int
    function: Function


Operation: TypeAlias = (
    Read
    | NumberOperation
    | GivenNumbers
    | PointwiseOperation
    | Sliding
    | Reaching
    | Measuring
    | Extend
    | AtUnseen
)


def least(*values: FloatArray) -> FloatArray:
    """The least of the inputs at each sample."""
    return reduce(np.minimum, values)


def greatest(*values: FloatArray) -> FloatArray:
    """The greatest of the inputs at each sample."""
    return reduce(np.maximum, values)


def difference(left: FloatArray, right: FloatArray) -> FloatArray:
    """left - right."""
    return np.subtract(left, right)


def distance(left: FloatArray, right: FloatArray) -> FloatArray:
    """|left - right|, the robustness of `!=`."""
    return np.abs(np.subtract(left, right))


def closeness(left: FloatArray, right: FloatArray) -> FloatArray:
    """-|left - right|, the robustness of `==`."""
    return -distance(left, right)


def negative(value: FloatArray) -> FloatArray:
    """-value."""
    return np.negative(value)


def quotient(left: FloatArray, right: FloatArray) -> FloatArray:
    """left / right; of a zero divisor infinity with the sign of left, and 0 / 0 is 0."""
    with np.errstate(all="ignore"):
        return _zero_for_nan(np.divide(left, np.add(right, 0.0)))  # -0 + 0 is 0


def power(left: FloatArray, right: FloatArray) -> FloatArray:
    """left ^ right. Raises DiagnosticError RL307 for the root of a negative number."""
    with np.errstate(all="ignore"):
        values = np.power(np.add(left, 0.0), right)
    if np.isnan(values).any():
        raise stl_error(Code.NON_FINITE_TERM, op="^", help=_HELP)
    return values


_HELP = "keep the base of a root positive with `max(x, 0)`"


def _zero_for_nan(values: FloatArray) -> FloatArray:
    return np.where(np.isnan(values), 0.0, values)


TERM_FUNCTIONS: dict[str, Function] = {
    "+": np.add, "-": difference, "*": np.multiply, "/": quotient, "^": power,
    "abs": np.abs, "min": least, "max": greatest,
}  # fmt: skip


def _truth_of(relation: np.ufunc) -> Function:
    def truth(left: FloatArray, right: FloatArray) -> FloatArray:
        return np.where(relation(left, right), 1.0, -1.0)

    return truth


BOOLEAN: dict[str, Function] = {
    "<": _truth_of(np.less), "<=": _truth_of(np.less_equal),
    ">": _truth_of(np.greater), ">=": _truth_of(np.greater_equal),
    "==": _truth_of(np.equal), "!=": _truth_of(np.not_equal),
}  # fmt: skip
"""Comparisons as +1 where they hold and -1 where they do not."""


def _reverse_difference(left: FloatArray, right: FloatArray) -> FloatArray:
    return np.subtract(right, left)


ROBUST: dict[str, Function] = {
    "<": _reverse_difference, "<=": _reverse_difference, ">": difference, ">=": difference,
    "==": closeness, "!=": distance,
}  # fmt: skip
"""Comparisons as the distance to where they change."""


def _of_infinities(function: Function) -> Function:
    def value(left: FloatArray, right: FloatArray) -> FloatArray:
        with np.errstate(invalid="ignore"):
            return _zero_for_nan(function(left, right))

    return value


_FINITE: tuple[Function, ...] = (np.add, np.multiply, *ROBUST.values())
OF_INFINITIES = {function: _of_infinities(function) for function in _FINITE}
"""The same where numbers can be infinite: equal infinities are 0 apart, and 0 times one is 0."""
