"""Interval arithmetic holds whatever value is drawn."""

from __future__ import annotations

import operator

from hypothesis import given
from hypothesis import strategies as st

from roadlang.semantics.types import bounds

numbers = st.floats(-100, 100, allow_nan=False)
intervals = st.tuples(numbers, numbers).map(lambda ends: (min(ends), max(ends)))
shares = st.floats(0, 1)
OPERATORS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}


def inside(share: float, ends: tuple[float, float]) -> float:
    return min(max(ends[0] + share * (ends[1] - ends[0]), ends[0]), ends[1])


@given(st.sampled_from(sorted(OPERATORS)), intervals, intervals, shares, shares)
def test_the_result_lies_within_the_bounds(
    sign: str, a: tuple[float, float], b: tuple[float, float], s: float, t: float
) -> None:
    found = bounds.arithmetic(sign, a, b)
    if found is None:
        assert sign == "/"
        assert b[0] <= 0 <= b[1]
        return
    value = OPERATORS[sign](inside(s, a), inside(t, b))
    slack = 1e-9 * (1 + abs(value))
    assert found[0] - slack <= value <= found[1] + slack


@given(intervals, shares)
def test_absolute_values(a: tuple[float, float], s: float) -> None:
    low, high = bounds.absolute(a)
    assert low <= abs(inside(s, a)) <= high


@given(st.lists(intervals, min_size=2, max_size=4), st.lists(shares, min_size=4, max_size=4))
def test_least_and_greatest(parts: list[tuple[float, float]], drawn: list[float]) -> None:
    values = [inside(share, part) for share, part in zip(drawn, parts, strict=False)]
    least, greatest = bounds.least(list(parts)), bounds.greatest(list(parts))
    assert least is not None
    assert greatest is not None
    assert least[0] <= min(values) <= least[1]
    assert greatest[0] <= max(values) <= greatest[1]


def test_what_is_not_known_stays_unknown() -> None:
    assert bounds.arithmetic("+", None, (1, 2)) is None
    assert bounds.arithmetic("/", (1, 2), (-1, 1)) is None
    assert bounds.hull([(1, 2), None]) is None
    assert bounds.least([(1, 2), None]) == (float("-inf"), 2)
