"""Interval arithmetic holds whatever the values are; its ends are values that can occur."""

from __future__ import annotations

import math
import operator
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from roadlang import stl
from roadlang.stl.evaluate import interval_arithmetic as ia

EDGES = st.sampled_from([0.0, -0.0, 1.0, -1.0, 2.0])
NUMBERS = EDGES | st.floats(-100, 100, allow_nan=False)
INTERVALS = st.tuples(NUMBERS, NUMBERS).map(lambda ends: (min(ends), max(ends)))
SHARES = st.sampled_from([0.0, 1.0]) | st.floats(0, 1)
OPERATORS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}


def inside(share: float, ends: tuple[float, float]) -> float:
    return min(max(ends[0] + share * (ends[1] - ends[0]), ends[0]), ends[1])


@given(st.sampled_from(sorted(OPERATORS)), INTERVALS, INTERVALS, SHARES, SHARES)
def test_the_result_is_never_beyond_the_bounds(
    sign: str, a: tuple[float, float], b: tuple[float, float], s: float, t: float
) -> None:
    x, y = inside(s, a), inside(t, b)
    low, high = ia.arithmetic(sign, a, b)
    if sign != "/" or y != 0:
        assert low <= OPERATORS[sign](x, y) <= high
    if sign == "/" and b[0] <= 0 <= b[1]:
        assert (low, high) == ia.UNKNOWN


@given(st.sampled_from("+-*/"), INTERVALS, INTERVALS)
def test_the_bounds_are_results_of_the_ends(
    sign: str, a: tuple[float, float], b: tuple[float, float]
) -> None:
    found = ia.arithmetic(sign, a, b)
    if found != ia.UNKNOWN:
        corners = [OPERATORS[sign](x, y) for x in a for y in b]
        assert found == (min(corners), max(corners))


@given(INTERVALS, st.sampled_from([-3.0, -2.0, -1.0, 0.0, 0.5, 1.0, 2.0, 3.0]), SHARES)
@example((0.0, 1.0), -3.0, 3.7450254222565056e-156)  # beyond the largest number
def test_powers(a: tuple[float, float], exponent: float, share: float) -> None:
    low, high = ia.arithmetic("^", a, (exponent, exponent))
    x = inside(share, a)
    if (x != 0 or exponent >= 0) and (x >= 0 or exponent.is_integer()):
        with np.errstate(over="ignore", divide="ignore"):
            assert low <= np.float64(x) ** exponent <= high


@pytest.mark.parametrize(
    ("a", "exponent", "bounds"),
    [
        ((-3.0, 2.0), 2.0, (0.0, 9.0)),
        ((-3.0, 2.0), 3.0, (-27.0, 8.0)),
        ((-3.0, -2.0), 2.0, (4.0, 9.0)),
        ((4.0, 9.0), 0.5, (2.0, 3.0)),
        ((2.0, 4.0), -1.0, (0.25, 0.5)),
        ((-1.0, 1.0), -1.0, ia.UNKNOWN),
        ((-1.0, 1.0), 0.5, ia.UNKNOWN),
        ((10.0, 1e200), 2.0, (100.0, math.inf)),
    ],
)
def test_powers_at_the_edges(a: Any, exponent: float, bounds: Any) -> None:
    assert ia.arithmetic("^", a, (exponent, exponent)) == bounds
    columns = (np.array([a[0]]), np.array([a[1]]))
    assert ia.arithmetic("^", columns, (exponent, exponent)) == bounds


def test_an_exponent_that_varies_tells_nothing() -> None:
    assert ia.arithmetic("^", (1.0, 2.0), (1.0, 2.0)) == ia.UNKNOWN


@given(INTERVALS, SHARES)
def test_absolute_values_and_squares(a: tuple[float, float], share: float) -> None:
    x = inside(share, a)
    low, high = ia.absolute(a)
    assert low <= abs(x) <= high
    assert (low == 0) == (a[0] <= 0 <= a[1])
    low, high = ia.square(a)
    assert low <= x * x <= high


@given(st.lists(INTERVALS, min_size=1, max_size=4), st.lists(SHARES, min_size=4, max_size=4))
def test_least_and_greatest(parts: list[tuple[float, float]], shares: list[float]) -> None:
    values = [inside(share, part) for share, part in zip(shares, parts, strict=False)]
    least, greatest = ia.of_function("min", parts), ia.of_function("max", parts)
    assert least[0] <= min(values) <= least[1]
    assert greatest[0] <= max(values) <= greatest[1]
    low, high = ia.hull(parts)
    assert low <= min(values)
    assert max(values) <= high


def test_infinite_ends_stand_for_bounds_that_are_not_known() -> None:
    unknown = ia.UNKNOWN
    assert ia.arithmetic("+", unknown, (1.0, 2.0)) == unknown
    assert ia.arithmetic("-", unknown, unknown) == unknown
    assert ia.arithmetic("*", (0.0, 1.0), (0.0, math.inf)) == (0.0, math.inf)
    assert ia.arithmetic("*", (0.0, 0.0), unknown) == (0.0, 0.0)
    assert ia.arithmetic("/", (1.0, math.inf), (2.0, math.inf)) == (0.0, math.inf)
    assert ia.absolute(unknown) == (0.0, math.inf)
    assert ia.of_function("min", [(1.0, 2.0), unknown]) == (-math.inf, 2.0)
    assert ia.hull([(1.0, 2.0), unknown]) == unknown


@given(st.lists(st.tuples(INTERVALS, INTERVALS), min_size=1, max_size=5), st.sampled_from("+-*/"))
def test_arrays_are_computed_row_by_row(rows: list[Any], sign: str) -> None:
    (a_low, a_high), (b_low, b_high) = np.array(rows).transpose(1, 2, 0)
    a, b = (a_low, a_high), (b_low, b_high)
    found = ia.arithmetic(sign, a, b)
    alone = [ia.arithmetic(sign, *row) for row in rows]
    assert [tuple(ends) for ends in zip(*found, strict=True)] == alone


def test_terms() -> None:
    known = {"x": (-1.0, 2.0), "y": (0.5, 4.0)}

    def of(text: str) -> Any:
        comparison = stl.parse(f"{text} > 0")
        assert isinstance(comparison, stl.Comparison)
        return ia.term_bounds(comparison.left, known)

    assert of("x * x") == (0.0, 4.0)
    assert of("x * y") == (-4.0, 8.0)
    assert of("-x + 1") == (-1.0, 2.0)
    assert of("x / y") == (-2.0, 4.0)
    assert of("abs(x) - max(x, y)") == (-4.0, 1.5)
    assert of("abs(z)") == (0.0, math.inf)
    assert of("x / (y - 1)") == ia.UNKNOWN


def test_terms_that_share_parts_are_looked_at_once() -> None:
    term: stl.Term = stl.Variable("x")
    for _ in range(200):
        term = stl.Arithmetic("+", term, term)
    assert ia.term_bounds(term, {"x": (0.0, 0.0)}) == (0.0, 0.0)
