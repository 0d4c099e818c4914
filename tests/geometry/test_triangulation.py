"""Triangles of polygons: all of the surface, none outside, also where corners turn inward."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.junctions.random_networks import random_network
from roadlang.geometry import triangulated
from roadlang.geometry.arrays import Floats
from roadlang.geometry.junctions.plan import plan_junctions


def area(ring: Floats) -> float:
    after = np.roll(ring, -1, axis=0)
    return float((ring[:, 0] * after[:, 1] - ring[:, 1] * after[:, 0]).sum()) / 2.0


def of_triangles(ring: Floats) -> list[float]:
    return [area(ring[list(corners)]) for corners in triangulated(ring)]


def test_a_square_is_two_triangles() -> None:
    assert len(triangulated([(0, 0), (1, 0), (1, 1), (0, 1)])) == 2


def test_a_corner_that_turns_inward_stays_outside() -> None:
    arrow = np.array([(0.0, 0.0), (2.0, 1.0), (0.0, 2.0), (1.0, 1.0)])
    assert sorted(of_triangles(arrow)) == pytest.approx([0.5, 0.5])


@given(st.lists(st.floats(0.2, 5.0), min_size=3, max_size=40))
def test_the_triangles_of_a_star_shape_fill_it(radii: list[float]) -> None:
    angles = np.linspace(0.0, 2.0 * np.pi, len(radii), endpoint=False)
    ring = np.array(radii)[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    parts = of_triangles(ring)
    assert sum(parts) == pytest.approx(area(ring))
    assert min(parts) > 0.0


@pytest.mark.parametrize("kind", ["star 20", "two junctions", "bent arms"])
def test_the_areas_of_junctions_are_filled(kind: str) -> None:
    drawn = random_network(kind, 2)
    for junction in plan_junctions(drawn.network, drawn.sections).junctions:
        ring = np.array(junction.area)
        assert sum(of_triangles(ring)) == pytest.approx(area(ring), rel=1e-6)
