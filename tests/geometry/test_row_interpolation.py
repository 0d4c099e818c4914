"""Interpolation in tables that differ from row to row gives the bits of `np.interp`."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry.numbers.row_interpolation import interpolated_in_rows


@pytest.mark.parametrize("length", [1, 2, 3, 64, 65])
@pytest.mark.parametrize("tables", [1, 5])
def test_every_row_is_interpolated_in_its_own_table(length: int, tables: int) -> None:
    rng = np.random.default_rng(length)
    axis = np.cumsum(rng.choice([0.0, 0.3, 1.7], (tables, length)), axis=1)
    column, shared = rng.normal(size=(tables, length)), rng.normal(size=(1, length))
    rows = rng.integers(5, size=400)
    knots = axis[np.minimum(rows, tables - 1), rng.integers(length, size=400)]
    at = np.where(rng.random(400) < 0.3, knots, rng.uniform(-1.0, axis.max() + 1.0, 400))
    found, of_shared = interpolated_in_rows(at, rows, axis, [column, shared])
    for row, place, value, other in zip(rows, at, found, of_shared, strict=True):
        table = min(row, tables - 1)
        assert value == np.interp(place, axis[table], column[table])
        assert other == np.interp(place, axis[table], shared[0])
