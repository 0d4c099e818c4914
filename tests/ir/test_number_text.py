"""Lists of numbers have the text that Python's `json` gives them."""

from __future__ import annotations

import json
import math
import sys

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from roadlang.ir.number_text import floats_text, is_floats

FINITE = st.floats(allow_nan=False, allow_infinity=False)
EDGES = [
    0.0, -0.0, 1.0, 1e-4, 9.999999999999999e-05, -1e-5, 1.5e-6, 1e-7, 1e15, 1e16,
    123456789012345680.0, 5e-324, sys.float_info.min, sys.float_info.max, 10.00001, -0.00001234,
]  # fmt: skip


@given(st.lists(FINITE, min_size=1))
@example(EDGES)
def test_finite_numbers_are_written_as_python_writes_them(values: list[float]) -> None:
    assert f"[{floats_text(values)}]" == json.dumps(values)
    assert f"[{floats_text(values, ',')}]" == json.dumps(values, separators=(",", ":"))


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_not_finite_is_null(value: float) -> None:
    assert floats_text([1.0, value, 1e-05]) == "1.0, null, 1e-05"


def test_numbers_of_other_types_are_not_floats() -> None:
    assert is_floats((1.0, math.nan))
    assert not is_floats((1.0, 2))
    assert not is_floats((1.0, True))
    assert not is_floats(())
