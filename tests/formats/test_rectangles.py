"""The smallest rectangles around outlines."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from roadlang_formats.rectangles import smallest_rectangle


@pytest.mark.parametrize("seed", range(20))
def test_no_rectangle_around_an_outline_is_smaller(seed: int) -> None:
    """Also around stars, none of whose sides lies along it."""
    rng = np.random.default_rng(seed)
    angle = np.sort(rng.uniform(0.0, 2.0 * math.pi, 12))
    away = rng.uniform(2.0, 9.0, 12)
    corners = np.column_stack([away * np.cos(angle), away * np.sin(angle)])
    x, y, length, width, heading = smallest_rectangle(corners)
    expected = shapely.MultiPoint(corners).minimum_rotated_rectangle
    assert length * width == pytest.approx(expected.area)
    turned = (corners - (x, y)) @ np.array(
        [[math.cos(heading), -math.sin(heading)], [math.sin(heading), math.cos(heading)]]
    )
    assert (np.abs(turned) <= np.array([length, width]) / 2.0 + 1e-9).all()


@pytest.mark.parametrize("corners", [[(3.0, 4.0)] * 4, [(0.0, 0.0), (5.0, 0.0), (2.0, 0.0)]])
def test_an_outline_without_area_has_one(corners: list[tuple[float, float]]) -> None:
    *_, length, width, _ = smallest_rectangle(np.array(corners))
    assert length * width == 0.0
