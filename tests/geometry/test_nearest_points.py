"""The nearest other part of a road: what a look at every pair finds, from a look at few of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import Curve
from roadlang.geometry.batches import nearest_points
from roadlang.geometry.batches.nearest_points import AlongOneLine, AlongTwoLines
from tests.geometry.geometry_shapes import curves

ratios = st.sampled_from([0.5, 2.0, 4.0])


def along(points: np.ndarray, closed: bool) -> AlongOneLine:
    steps = np.hypot(*np.diff(points, axis=0, append=points[:1]).T)
    places = np.concatenate([[0.0], np.cumsum(steps)])
    return AlongOneLine(places[:-1], float(places[-1]) if closed else None)


def of_all_pairs(points: Any, line: Any, way: Any, ratio: float) -> Any:
    every = np.arange(len(points)), np.arange(len(line))
    near = np.hypot(*(points[:, None] - line[None]).T).T
    near[way.between(*every) <= ratio * near] = np.inf
    return near.min(axis=1)


def found(points: Any, line: Any, way: Any, ratio: float) -> Any:
    index, counted = nearest_points.nearest_points(points, line, way, ratio)
    return np.where(counted, np.hypot(*(points - line[index]).T), np.inf)


@given(curves(), st.sampled_from([0.25, 1.0]), ratios)
def test_a_road_and_itself(curve: Curve, spacing: float, ratio: float) -> None:
    points = curve.at(curve.stations(spacing=spacing))
    way = along(points, curve.closed)
    expected = of_all_pairs(points, points, way, ratio)
    np.testing.assert_allclose(found(points, points, way, ratio), expected, rtol=1e-12)


@given(curves(), curves(), ratios, st.booleans())
def test_two_roads_with_and_without_a_shared_end(
    here: Curve, there: Curve, ratio: float, meet: bool
) -> None:
    points, line = (curve.at(curve.stations(spacing=0.5)) for curve in (here, there))
    ends = [(along(points, False).places, along(line, False).places)] if meet else []
    if meet:
        line = line - line[0] + points[0]
    way = AlongTwoLines(ends)
    expected = of_all_pairs(points, line, way, ratio)
    np.testing.assert_allclose(found(points, line, way, ratio), expected, rtol=1e-12, atol=1e-9)


@pytest.mark.parametrize(("is_spiral", "share"), [(False, 0.02), (True, 0.3)])
def test_of_a_long_road_few_pairs_are_looked_at(
    is_spiral: bool, share: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    angle = np.linspace(0.0, 60.0 * np.pi, 20_001)
    points = np.stack([50.0 * angle, 8.0 * np.sin(angle)], axis=1)
    if is_spiral:
        points = angle[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    pairs = 0
    distances = nearest_points._distances

    def counted(first: Any, second: Any) -> Any:
        nonlocal pairs
        pairs += len(first) * len(second)
        return distances(first, second)

    monkeypatch.setattr(nearest_points, "_distances", counted)
    nearest_points.nearest_points(points, points, along(points, False), 2.0)
    assert pairs < share * len(points) ** 2
