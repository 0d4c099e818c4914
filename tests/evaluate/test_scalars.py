"""Values of a single candidate are plain Python values."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.evaluate.kind_instance import scalar


@pytest.mark.parametrize(
    ("value", "plain"),
    [
        (np.array([[2.5]]), 2.5),
        (np.array([3]), 3),
        (np.array([["rain"]], dtype=object), "rain"),
        (np.float64(1.5), 1.5),
        (np.bool_(True), True),
        ("rain", "rain"),
        (None, None),
        ((np.array([[1.0]]), np.array([[2.0]])), (1.0, 2.0)),
        ([np.array([[1.0]]), "a"], (1.0, "a")),
        ({"a": np.array([[1.0]]), "b": (np.array([2.0]),)}, {"a": 1.0, "b": (2.0,)}),
    ],
)
def test_a_column_of_one_row_is_its_number(value: Any, plain: Any) -> None:
    found = scalar(value)
    assert found == plain
    assert type(found) is type(plain)
