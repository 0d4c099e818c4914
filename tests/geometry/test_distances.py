"""Distances between curves, of a curve to itself, and to other roads."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import (
    CurveBatch,
    CurveFrame,
    GeometryError,
    clearance,
    crossings,
    displace,
    frechet,
    lp_norm,
    margin,
    pointwise,
    quadrature,
    sample,
)
from tests.geometry.geometry_shapes import circle, curves, hairpin, line, self_intersects, wave


def lp_distance(a: CurveBatch, b: CurveBatch, p: float) -> Any:
    """The paper's d_p."""
    return lp_norm(pointwise(a, b), quadrature(a), p)


def sup_distance(a: CurveBatch, b: CurveBatch) -> Any:
    return pointwise(a, b).max(axis=1)


METRICS = {
    "d1": lambda a, b: lp_distance(a, b, 1.0),
    "d2": lambda a, b: lp_distance(a, b, 2.0),
    "sup": sup_distance,
    "frechet": frechet,
}


def three(seed: Any) -> Any:
    rng = np.random.default_rng(seed)
    s = np.linspace(0.0, 30.0, 16)
    return (CurveBatch(s, np.cumsum(rng.normal(size=(4, 16, 2)), axis=1)) for _ in range(3))


@pytest.mark.parametrize("metric", METRICS.values(), ids=METRICS)
@given(seed=st.integers(0, 10_000))
def test_they_are_metrics(metric: Any, seed: int) -> None:
    a, b, c = three(seed)
    assert (metric(a, a) == 0.0).all()
    assert (metric(a, b) > 0.0).all()
    np.testing.assert_allclose(metric(a, b), metric(b, a))
    assert (metric(a, c) <= metric(a, b) + metric(b, c) + 1e-9).all()


def test_parallel_lines() -> None:
    road = line(100.0)
    s = road.stations(count=51)
    beside = displace(road, s, np.array([[3.0], [-4.0]]) * np.ones((2, 51)))
    root = sample(road, s)
    np.testing.assert_allclose(pointwise(beside, root), [[3.0] * 51, [4.0] * 51])
    np.testing.assert_allclose(lp_distance(beside, root, 1), [300.0, 400.0])
    np.testing.assert_allclose(lp_distance(beside, root, 2), [30.0, 40.0])
    np.testing.assert_allclose(sup_distance(beside, root), [3.0, 4.0])
    np.testing.assert_allclose(frechet(beside, root), [3.0, 4.0])


def test_on_a_ring_the_integral_goes_all_the_way_round() -> None:
    ring = circle(radius=10.0)
    s = ring.stations(count=37)
    out = displace(ring, s, np.full((1, 37), -2.0))
    np.testing.assert_allclose(lp_distance(out, sample(ring, s), 1), 2.0 * ring.length)


def test_lp_approaches_sup_as_p_grows_and_does_not_overflow() -> None:
    road = wave()
    s = road.stations(count=200)
    a = displace(road, s, 1e3 * np.sin(s / 30))
    root = sample(road, s)
    assert lp_distance(a, root, 500.0) == pytest.approx(sup_distance(a, root), rel=0.02)


def test_the_trapezoid_is_exact_for_a_displacement_that_grows_evenly() -> None:
    road = line(90.0)
    s = np.concatenate([[0.0, 1.0], np.linspace(7.0, 90.0, 9)])
    a = displace(road, s, s / 10)
    np.testing.assert_allclose(lp_distance(a, sample(road, s), 1), 90.0**2 / 20)


@given(curves(), st.integers(0, 99))
def test_displacements_of_one_root_are_compared_number_by_number(curve: Any, seed: int) -> None:
    s = curve.stations(count=30)
    moves = np.random.default_rng(seed).normal(size=(2, 3, 30))
    a, b = (displace(curve, s, move) for move in moves)
    points = CurveBatch(s, a.points, curve.closed), CurveBatch(s, b.points, curve.closed)
    np.testing.assert_allclose(pointwise(a, b), pointwise(*points), atol=1e-9)


def exhaustive_frechet(p: Any, q: Any) -> Any:
    """Eiter and Mannila's recursion, as printed."""
    gap = np.linalg.norm(p[:, None] - q[None], axis=-1)
    table = np.full(gap.shape, np.inf)
    for i in range(len(p)):
        for j in range(len(q)):
            before = [
                table[a, b]
                for a, b in ((i - 1, j), (i, j - 1), (i - 1, j - 1))
                if a >= 0 and b >= 0
            ]
            table[i, j] = max(gap[i, j], min(before)) if before else gap[i, j]
    return table[-1, -1]


@given(st.integers(0, 10_000), st.integers(3, 12), st.integers(3, 12))
def test_frechet_is_the_recursion_of_eiter_and_mannila(seed: int, rows: int, columns: int) -> None:
    rng = np.random.default_rng(seed)
    p, q = rng.normal(size=(3, rows, 2)), rng.normal(size=(3, columns, 2))
    a, b = CurveBatch(np.arange(rows), p), CurveBatch(np.arange(columns), q)
    expected = [exhaustive_frechet(*pair) for pair in zip(p, q, strict=True)]
    np.testing.assert_allclose(frechet(a, b), expected)


def test_margin_is_negative_outside_the_box() -> None:
    road = line(100.0)
    batch = sample(road, [0.0, 10.0, 50.0, 95.0, 100.0])
    expected = [[-5.0, 5.0, 20.0, 0.0, -5.0]]
    np.testing.assert_allclose(margin(batch, (95.0, 20.0), (5.0, -20.0)), expected)


@given(curves())
def test_a_gentle_curve_is_nowhere_near_itself(curve: Any) -> None:
    if curve.closed:
        s = curve.stations(count=100)
        assert (clearance(sample(curve, s)) > 15.0).all()
    else:
        bent = line(curve.length)
        assert np.isinf(clearance(sample(bent, bent.stations(count=50)))).all()


def test_a_ring_is_nowhere_near_itself() -> None:
    ring = circle()
    assert np.isinf(clearance(sample(ring, ring.stations(count=80)))).all()


def test_the_legs_of_a_hairpin_are_its_width_apart() -> None:
    road = hairpin(radius=5.0, leg=40.0)
    s = road.stations(count=301)
    gaps = clearance(sample(road, s))[0]
    np.testing.assert_allclose(gaps[s < 35.0], 10.0, atol=1e-3)
    assert np.isinf(gaps[150])


def test_at_a_crossing_the_clearance_is_zero() -> None:
    loop = CurveBatch(np.arange(5.0), [[(0, 0), (40, 0), (40, 30), (13, 30), (13, -20)]])
    assert self_intersects(loop)[0]
    np.testing.assert_array_equal(clearance(loop)[0][[0, 1, 3, 4]], 0.0)


def test_clearance_to_another_road() -> None:
    road, beside = line(100.0), line(100.0)
    s = road.stations(count=41)
    other = displace(beside, s, np.array([[7.0], [30.0]]) * np.ones((2, 41)))
    here = displace(road, s, np.zeros((2, 41)))
    np.testing.assert_allclose(clearance(here, [other]), [[7.0] * 41, [30.0] * 41])


def test_roads_that_meet_at_a_junction_are_not_near_each_other_there() -> None:
    s = np.linspace(0.0, 50.0, 26)
    east = CurveBatch(s, np.stack([s, 0 * s], axis=-1)[None])
    north = CurveBatch(s, np.stack([0 * s, s], axis=-1)[None])
    assert np.isinf(clearance(east, [north])).all()
    apart = CurveBatch(s, np.stack([0 * s + 1.0, s - 20.0], axis=-1)[None])
    assert clearance(east, [apart]).min() == 0.0


@pytest.mark.parametrize(("mine", "theirs"), [(1, 1), (1, -1), (-1, 1), (-1, -1)])
@pytest.mark.parametrize("beyond", [0.0, 1e-9])
def test_at_whichever_ends_roads_meet_they_do_not_cross_there(
    mine: int, theirs: int, beyond: float
) -> None:
    """Also where one is a rounding error longer, so that their last steps do cross."""
    s = np.linspace(0.0, 50.0, 26)
    east = CurveBatch(s, np.stack([s - beyond, 0 * s], axis=-1)[None, ::mine])
    north = CurveBatch(s, np.stack([0 * s, s - beyond], axis=-1)[None, ::theirs])
    assert len(crossings(east, north)[0]) == 1
    assert np.isinf(clearance(east, [north])).all()
    past = CurveBatch(s, np.stack([0 * s, s - 3.0], axis=-1)[None, ::theirs])
    touched = np.flatnonzero(clearance(east, [past])[0] == 0.0)
    assert touched.tolist() == ([0, 1] if mine == 1 else [24, 25])


@given(st.integers(0, 10_000), st.booleans(), st.integers(10, 60))
def test_crossings_are_those_of_an_exhaustive_search(seed: int, closed: bool, count: int) -> None:
    rng = np.random.default_rng(seed)
    points = np.cumsum(rng.normal((0.6, 0.0), size=(3, count, 2)), axis=1)
    batch = CurveBatch(np.arange(count), points, closed)
    expected = [exhaustive_crossing(row, closed) for row in points]
    np.testing.assert_array_equal(self_intersects(batch), expected)


def exhaustive_crossing(points: Any, closed: Any) -> bool:
    def side(a: Any, b: Any, c: Any) -> Any:
        return np.sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))

    ring = np.concatenate([points, points[:1]]) if closed else points
    steps = [(ring[i], ring[i + 1]) for i in range(len(ring) - 1)]
    for i, (p, q) in enumerate(steps):
        for j in range(i + 2, len(steps)):
            if closed and i == 0 and j == len(steps) - 1:
                continue
            r, t = steps[j]
            if side(p, q, r) != side(p, q, t) and side(r, t, p) != side(r, t, q):
                return True
    return False


def test_crossings_of_two_curves_name_their_steps() -> None:
    s = np.arange(11.0)
    east = CurveBatch(s, np.stack([s, 0 * s], axis=-1)[None])
    north = CurveBatch(s, np.stack([0 * s + 3.5, s - 6.2], axis=-1)[None])
    assert [index.tolist() for index in crossings(east, north)] == [[0], [3], [6]]


def test_a_straight_road_does_not_cross_itself() -> None:
    for curve in (line(100.0), wave(), circle()):
        assert not self_intersects(sample(curve, curve.stations(count=200))).any()


def test_what_cannot_be_compared_is_refused() -> None:
    s = np.linspace(0.0, 10.0, 11)
    a = displace(line(), s, np.zeros((2, 11)))
    b = displace(line(), s, np.zeros((3, 11)))
    c = sample(wave(), s[:5])
    calls: tuple[Callable[[], object], ...] = (
        lambda: pointwise(CurveBatch(s, a.points), b),
        lambda: pointwise(a, c),
        lambda: frechet(a, b),
        lambda: margin(a, (0.0, 0.0), (1.0, 1.0, 1.0)),
    )
    for call in calls:
        with pytest.raises(GeometryError):
            call()


def test_what_cannot_be_compared_is_said_in_the_order_of_the_arguments() -> None:
    road = line(100.0)
    s = road.stations(count=11)
    two, three = (sample(road, s).points.repeat(count, axis=0) for count in (2, 3))
    one, other = CurveBatch(s, two, closed=False), CurveBatch(s, three, closed=False)
    with pytest.raises(GeometryError, match="2 variants cannot be compared with 3"):
        pointwise(one, other)
    with pytest.raises(GeometryError, match="3 variants cannot be compared with 2"):
        pointwise(other, one)
    with pytest.raises(GeometryError, match="only at the same stations"):
        pointwise(one, sample(road, s[:-1]))


def test_a_norm_does_not_depend_on_the_rows_beside_it() -> None:
    random = np.random.Generator(np.random.Philox(key=1))
    values, weights = random.random((33, 451)), random.random(451)
    together = lp_norm(values, weights, 2.0)
    alone = [lp_norm(row[None, :], weights, 2.0)[0] for row in values]
    assert together.tolist() == alone


def test_displacements_are_compared_number_by_number_along_the_same_frame_only() -> None:
    base = line(length=30.0)
    stations = np.linspace(0.0, 30.0, 16)
    frame = CurveFrame.of(base, stations)
    assert frame.same_as(frame)
    assert frame.same_as(CurveFrame.of(base, stations.copy()))
    assert not frame.same_as(CurveFrame.of(base, stations[:-1]))
    assert not frame.same_as(CurveFrame.of(base, stations**2 / 30.0))
    assert not frame.same_as(CurveFrame.of(line(length=30.0), stations))
