"""The spline against scipy's, which is slow to import."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang.geometry.curves.spline import interpolate


@pytest.mark.parametrize("closed", [False, True])
@settings(max_examples=30, deadline=None)
@given(steps=st.lists(st.floats(0.1, 5.0), min_size=3, max_size=20), seed=st.integers(0, 999))
def test_it_is_the_not_a_knot_or_the_periodic_spline(
    closed: bool, steps: list[float], seed: int
) -> None:
    from scipy.interpolate import CubicSpline

    knots = np.concatenate([[0.0], np.cumsum(steps)])
    points = np.random.default_rng(seed).normal(size=(len(knots), 2))
    u = np.linspace(0.0, knots[-1], 200)
    if closed:
        points[-1] = points[0]
        expected = CubicSpline(knots, points, bc_type="periodic")
        spline = interpolate(knots, points[:-1], closed=True)
    else:
        expected = CubicSpline(knots, points)
        spline = interpolate(knots, points, closed=False)
    size = np.abs(expected(u)).max()
    np.testing.assert_allclose(spline.position(u), expected(u), atol=1e-10 * size)
    first, second, _ = spline.derivatives(u)
    np.testing.assert_allclose(first, expected(u, 1), atol=1e-8 * size)
    np.testing.assert_allclose(second, expected(u, 2), atol=1e-7 * size)
