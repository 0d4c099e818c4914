"""What lies at the edges: two points, points that coincide, closed and open, zero and equal ends.

Everything either gives finite numbers or says in a `GeometryError` why it cannot.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from roadlang.geometry import (
    Curve,
    GeometryError,
    Road,
    WidthProfile,
    clearance,
    displace,
    ease,
    fade,
    frechet,
    lp_norm,
    margin,
    network_of_polylines,
    offset,
    over,
    pointwise,
    quadrature,
    sample,
)

Points = list[tuple[float, float]]
coordinates = st.sampled_from([0.0, 1e-12, 1.0, 10.0, 50.0]) | st.floats(-100.0, 100.0)
lines = st.lists(st.tuples(coordinates, coordinates), min_size=1, max_size=6).flatmap(
    lambda points: st.sampled_from([points, [points[0], *points], [*points, points[0]]])
)
lengths = st.sampled_from([0.0, 5e-324, 1e-9, 1.0, 100.0]) | st.floats(0.0, 100.0)


@contextlib.contextmanager
def refusal() -> Iterator[None]:
    """Discards an example that geometry refuses."""
    try:
        yield
    except GeometryError:
        assume(False)


def curve_through(points: Points, closed: bool) -> Curve:
    with refusal():
        return Curve.through(points, closed)
    raise AssertionError


@given(lines, st.booleans())
@example([(0.0, 50.0), (50.0, 0.0)], False)  # its end is one rounding beyond its length
def test_a_curve_is_finite_wherever_it_is_asked_for(points: Points, closed: bool) -> None:
    curve = curve_through(points, closed)
    s = np.array([-1.0, 0.0, curve.length / 2, curve.length, curve.length + 1.0])
    for values in (curve.at(s), curve.heading(s), curve.curvature(s), curve.normal(s)):
        assert np.isfinite(values).all()
    assert curve.closed == closed
    places = curve.points[[0, -1]]
    along, aside = curve.project(places)
    np.testing.assert_allclose(aside, 0.0, atol=1e-6)
    assert ((along >= 0.0) & (along <= curve.length)).all()


@given(lines, st.booleans(), st.sampled_from([2, 3, 4, 51]))
def test_few_stations_are_enough_or_refused(points: Points, closed: bool, count: int) -> None:
    curve = curve_through(points, closed)
    s = curve.stations(count=count)
    assert len(s) == count
    with refusal():
        batch = displace(curve, s, np.linspace(0.0, 0.5, count) * np.array([[0.0], [1.0]]))
        again = displace(batch, s, np.zeros((1, count, 2)))
        for made in (batch, again):
            assert np.isfinite(made.points).all()
            assert np.isfinite(made.heading).all()
            assert np.isfinite(made.curvature).all()
            assert made.folded.shape == (2,)


@given(lines, st.booleans())
def test_a_road_and_its_copy_are_nowhere_apart(points: Points, closed: bool) -> None:
    curve = curve_through(points, closed)
    batch = sample(curve, curve.stations(count=12))
    assert (pointwise(batch, batch) == 0.0).all()
    assert frechet(batch, batch) == 0.0
    assert lp_norm(pointwise(batch, batch), quadrature(batch), 2.0) == 0.0
    assert (clearance(batch) >= 0.0).all()
    corner, opposite = batch.points[0].min(axis=0), batch.points[0].max(axis=0)
    assert (margin(batch, corner, opposite) >= 0.0).all()
    assert margin(batch, opposite, corner).min() == margin(batch, corner, opposite).min() == 0.0
    assert quadrature(batch).sum() == pytest.approx(curve.length)


@given(lines, st.booleans(), st.sampled_from([-3.0, -0.0, 0.0, 1e-12, 3.0, 1e3]))
def test_edges_are_as_many_points_as_stations(points: Points, closed: bool, aside: float) -> None:
    curve = curve_through(points, closed)
    s = curve.stations(count=20)
    line = offset(curve, aside, s)
    assert line.shape == (20, 2)
    assert np.isfinite(line).all()
    if aside == 0.0:
        np.testing.assert_allclose(line, curve.at(s), atol=1e-9)
    left, right = Road(curve, WidthProfile.constant(7.0), lanes=1).edges(s)
    assert np.isfinite(left).all()
    assert np.isfinite(right).all()


@given(lengths, lengths, lengths, st.sampled_from([None, 100.0]))
def test_windows_are_between_zero_and_one(
    start: float, stop: float, taper: float, period: float | None
) -> None:
    s = np.array([0.0, 5e-324, 1e-9, 0.5, 1.0, 50.0, 99.0, 100.0 if period is None else 99.5])
    with refusal():
        window = over(s, start, stop, taper, period)
        assert ((window >= 0.0) & (window <= 1.0)).all()
        if taper == 0.0 and start <= stop:
            np.testing.assert_array_equal(window, (s >= start) & (s <= stop))
    with refusal():
        faded = fade(s, 100.0, taper)
        assert faded[0] == 0.0
        assert ((faded >= 0.0) & (faded <= 1.0)).all()


@given(st.sampled_from([-np.inf, -0.0, 0.0, 5e-324, 0.5, 1.0, np.inf]) | st.floats(-2.0, 2.0))
def test_ease_is_zero_before_and_one_after(t: float) -> None:
    value = float(ease(t))
    assert 0.0 <= value <= 1.0
    assert value == 0.0 or t > 0.0
    assert value == 1.0 or t < 1.0


@given(lines, st.booleans(), lengths, lengths)
def test_part_of_a_curve_ends_where_it_was_cut(
    points: Points, closed: bool, start: float, stop: float
) -> None:
    curve = curve_through(points, closed)
    with refusal():
        part = curve.between(start, stop)
        np.testing.assert_allclose(part.at(0.0), curve.at(min(start, curve.length)), atol=1e-6)
        np.testing.assert_allclose(
            part.at(part.length), curve.at(stop if closed else min(stop, curve.length)), atol=1e-6
        )
        assert 0.0 < part.length <= curve.length * (1.0 + 1e-9)


@given(st.lists(lines, max_size=4), st.sampled_from([0.0, 1e-6, 1.0, 1e3]))
def test_networks_of_any_lines_are_joined_or_refused(several: list[Points], near: float) -> None:
    with refusal():
        network = network_of_polylines(several, tolerance=near)
        assert len(network.edges) == len(several)
        assert sum(network.degree(node.id) for node in network.nodes) == 2 * len(several)
        if several:
            assert np.isfinite(network.bounds).all()
            assert network.longest().length <= network.length * (1.0 + 1e-9)
