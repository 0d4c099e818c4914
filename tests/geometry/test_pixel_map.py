"""Pixels of one picture in those of another."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry.earth.pixel_map import PixelMap
from roadlang.ir.picture import Picture

AT = st.floats(-1e4, 1e4)


@given(st.floats(-math.pi, math.pi), st.floats(1e-3, 1e3), AT, AT, AT, AT)
def test_points_come_back(by: float, size: float, x: float, y: float, p: float, q: float) -> None:
    c, s = size * math.cos(by), size * math.sin(by)
    there = PixelMap((c, s, x, -s, c, y), 100, 100)
    point = np.array([p, q])
    assert there.undo(there.apply(point)) == pytest.approx(point, abs=1e-6)
    assert there.factor == pytest.approx(size)
    assert math.cos(there.turn - by) == pytest.approx(1.0)


@given(AT, AT, st.sampled_from([0.1, 1.0, 30.0]))
def test_a_turned_picture_has_its_right_in_the_north(x: float, y: float, scale: float) -> None:
    """90 degrees to the left: its upper left pixel is the lower left one of the upright picture."""
    upright = PixelMap((0.0, 1.0, 0.0, -1.0, 0.0, 99.0), 60, 100)
    picture = Picture(np.zeros((60, 100, 3), np.uint8), scale, north_up=upright)
    point = np.array([[x, y]])
    world = picture.to_world(point)
    assert world == pytest.approx((point[:, ::-1] + 0.5) * scale, abs=1e-6)
    assert picture.to_pixels(world) == pytest.approx(point, abs=1e-6)
