"""What a node of an evaluation graph does: read, compute point by point, slide, reach."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from typing import TypeAlias

import numpy as np

from ...diagnostics import Code
from ..errors import stl_error
from ..formula.interval import Interval
from .kernels import Extreme
from .trace import FloatArray

Function: TypeAlias = Callable[..., FloatArray]


@dataclass(frozen=True)
class Read:
    """The signal of this name."""

    name: str


@dataclass(frozen=True)
class Number:
    """The same value at every sample."""

    value: float


@dataclass(frozen=True)
class Pointwise:
    """`function` of the inputs, sample by sample."""

    function: Function


@dataclass(frozen=True)
class Sliding:
    """The extreme of the input in a window."""

    extreme: Extreme
    interval: Interval | None
    past: bool


@dataclass(frozen=True)
class Reaching:
    """The first input until (since, for `past`) the second."""

    interval: Interval | None
    past: bool


@dataclass(frozen=True)
class Given:
    """Numbers per variant, infinite ones welcome, that are computed with the graph."""

    name: str


@dataclass(frozen=True)
class Extend:
    """The first input at the first `seen` samples, the second at the stand-ins behind them."""

    seen: int


@dataclass(frozen=True)
class AtUnseen:
    """The first input; behind the first `seen` samples joined with the second by `function`."""

    seen: int
    function: Function


Operation: TypeAlias = Read | Number | Given | Pointwise | Sliding | Reaching | Extend | AtUnseen


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


_HELP = {
    "/": "compare without dividing, `a < 2 * b` for `a / b < 2`, or divide by `max(b, 0.01)`",
    "^": "keep the base of a root positive with `max(x, 0)`",
}


def quotient(left: FloatArray, right: FloatArray) -> FloatArray:
    """left / right. Raises DiagnosticError RL307 where that is no number."""
    with np.errstate(all="ignore"):
        return _numbers(np.divide(left, right), "/")


def power(left: FloatArray, right: FloatArray) -> FloatArray:
    """left ^ right. Raises DiagnosticError RL307 where that is no number."""
    with np.errstate(all="ignore"):
        return _numbers(np.power(left, right), "^")


def _numbers(values: FloatArray, op: str) -> FloatArray:
    if not np.isfinite(values).all():
        raise stl_error(Code.NON_FINITE_TERM, op=op, help=_HELP.get(op, ()))
    return values


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


def _of_infinities(leaf: Function) -> Function:
    def value(left: FloatArray, right: FloatArray) -> FloatArray:
        with np.errstate(invalid="ignore"):
            return np.where(np.equal(left, right), 0.0, leaf(left, right))

    return value


OF_INFINITIES: dict[Function, Function] = {leaf: _of_infinities(leaf) for leaf in ROBUST.values()}
"""The same where both sides can be infinite: equal infinities are 0 apart."""
