"""The nearest point of a curve."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.geometry.geometry_shapes import circle, curves, line, wave


def test_left_is_positive() -> None:
    s, offset = line().project([(30.0, 4.0), (50.0, -3.0)])
    np.testing.assert_allclose(s, [30.0, 50.0])
    np.testing.assert_allclose(offset, [4.0, -3.0])


def test_one_point_gives_numbers_without_a_shape() -> None:
    s, offset = line().project((30.0, 4.0))
    assert s.shape == offset.shape == ()


def test_beyond_an_end_the_offset_is_measured_across_the_tangent() -> None:
    s, offset = line(100.0).project((103.0, 4.0))
    assert s == pytest.approx(100.0)
    assert offset == pytest.approx(4.0)


def test_inside_a_ring_the_seam_is_no_end() -> None:
    s, offset = circle().project([(9.0, 1e-9), (9.0, -1e-9)])
    np.testing.assert_allclose(offset, 1.0, atol=1e-5)
    assert s[0] == pytest.approx(0.0, abs=1e-6)
    assert s[1] == pytest.approx(circle().length, rel=1e-6)


@given(st.lists(st.floats(0.02, 0.98), min_size=1, max_size=9), st.floats(-6.0, 6.0))
def test_station_and_offset_come_back(shares: list[float], offset: float) -> None:
    curve = wave()
    s = np.array(shares) * curve.length
    points = curve.at(s) + offset * curve.normal(s)
    found, lateral = curve.project(points)
    np.testing.assert_allclose(found, s, atol=1e-6)
    np.testing.assert_allclose(lateral, offset, atol=1e-9)


@given(curves(), st.tuples(st.floats(-100, 100), st.floats(-100, 100)))
def test_no_sample_of_the_curve_is_nearer_than_the_projection(curve: Any, target: Any) -> None:
    s, _ = curve.project(target)
    gap = np.linalg.norm(curve.at(s) - target)
    samples = curve.at(np.linspace(0.0, curve.length, 4000))
    assert gap <= np.linalg.norm(samples - target, axis=1).min() + 1e-9
