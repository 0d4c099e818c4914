"""Rectangles on the ground, against corners and sides computed one by one."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import Footprints, close_pairs, distance_between, separation

Point = tuple[float, float]
Box = tuple[float, float, float, float, float]

BOXES = st.tuples(
    st.floats(-12, 12),
    st.floats(-12, 12),
    st.floats(-math.pi, math.pi) | st.sampled_from([0.0, math.pi / 2, math.pi, math.pi / 4]),
    st.floats(0.1, 9),
    st.floats(0.1, 3),
)


def footprints(boxes: list[Box]) -> Footprints:
    return Footprints(*np.array(boxes, dtype=float).reshape(-1, 5).T)


def corners(box: Box) -> list[Point]:
    x, y, heading, length, width = box
    signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
    along, left = (math.cos(heading), math.sin(heading)), (-math.sin(heading), math.cos(heading))
    return [
        (
            x + i * length / 2 * along[0] + j * width / 2 * left[0],
            y + i * length / 2 * along[1] + j * width / 2 * left[1],
        )
        for i, j in signs
    ]


def contains(box: Box, point: Point) -> bool:
    x, y, heading, length, width = box
    dx, dy = point[0] - x, point[1] - y
    along = dx * math.cos(heading) + dy * math.sin(heading)
    across = dy * math.cos(heading) - dx * math.sin(heading)
    return abs(along) <= length / 2 and abs(across) <= width / 2


def segment_distance(a: tuple[Point, Point], b: tuple[Point, Point]) -> float:
    def cross(o: Point, p: Point, q: Point) -> float:
        return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0])

    def to_segment(p: Point, s: tuple[Point, Point]) -> float:
        (x0, y0), (x1, y1) = s
        size = (x1 - x0) ** 2 + (y1 - y0) ** 2
        t = min(1.0, max(0.0, ((p[0] - x0) * (x1 - x0) + (p[1] - y0) * (y1 - y0)) / size))
        return math.hypot(p[0] - x0 - t * (x1 - x0), p[1] - y0 - t * (y1 - y0))

    crossing = (cross(*a, b[0]) > 0) != (cross(*a, b[1]) > 0) and (cross(*b, a[0]) > 0) != (
        cross(*b, a[1]) > 0
    )
    if crossing:
        return 0.0
    return min(to_segment(a[0], b), to_segment(a[1], b), to_segment(b[0], a), to_segment(b[1], a))


def true_distance(a: Box, b: Box) -> float:
    if contains(a, b[:2]) or contains(b, a[:2]):
        return 0.0
    sides_a, sides_b = (
        [(points[i], points[(i + 1) % 4]) for i in range(4)] for points in (corners(a), corners(b))
    )
    return min(segment_distance(s, t) for s in sides_a for t in sides_b)


@given(BOXES, BOXES)
def test_the_distance_is_that_of_the_sides(a: Box, b: Box) -> None:
    found = float(distance_between(footprints([a]), footprints([b]))[0])
    expected = true_distance(a, b)
    assert max(found, 0.0) == pytest.approx(expected, abs=1e-6)


@given(BOXES, BOXES)
def test_the_separation_has_the_sign_of_the_distance_and_is_never_greater(a: Box, b: Box) -> None:
    gap = float(separation(footprints([a]), footprints([b]))[0])
    assert gap == pytest.approx(float(separation(footprints([b]), footprints([a]))[0]), abs=1e-9)
    assert max(gap, 0.0) <= true_distance(a, b) + 1e-9


@pytest.mark.parametrize(
    ("b", "gap"),
    [
        ((5.0, 0.0, 0.0, 4.0, 2.0), 1.0),
        ((4.0, 0.0, 0.0, 4.0, 2.0), 0.0),
        ((3.0, 0.0, 0.0, 4.0, 2.0), -1.0),
        ((0.0, 2.5, 0.0, 4.0, 2.0), 0.5),
        ((4.0, 0.0, math.pi / 2, 4.0, 2.0), 1.0),
        ((0.0, 0.0, 1.0, 4.0, 2.0), None),
    ],
)
def test_a_car_four_meters_long_and_two_wide(b: Box, gap: float | None) -> None:
    car = footprints([(0.0, 0.0, 0.0, 4.0, 2.0)])
    found = float(separation(car, footprints([b]))[0])
    assert found < -1.0 if gap is None else found == pytest.approx(gap)


@given(st.lists(BOXES, max_size=12), st.lists(BOXES, max_size=12), st.floats(0, 3))
def test_close_pairs_are_those_of_all_pairs(a: list[Box], b: list[Box], margin: float) -> None:
    first, second = footprints(a), footprints(b)
    found = set(zip(*(part.tolist() for part in close_pairs(first, second, margin)), strict=True))
    for i, box in enumerate(a):
        for j, other in enumerate(b):
            radii = (math.hypot(*box[3:]) + math.hypot(*other[3:])) / 2
            apart = math.hypot(box[0] - other[0], box[1] - other[1]) - radii - margin
            if abs(apart) > 1e-9:
                assert ((i, j) in found) == (apart < 0)


@given(st.lists(st.tuples(BOXES, st.integers(0, 2)), max_size=20))
def test_groups_do_not_meet(items: list[tuple[Box, int]]) -> None:
    boxes = footprints([box for box, _ in items])
    groups = np.array([group for _, group in items], dtype=np.int64)
    i, j = close_pairs(boxes, boxes, 0.5, groups, groups)
    assert (groups[i] == groups[j]).all()
    apart = [close_pairs(boxes.take(groups == g), boxes.take(groups == g), 0.5) for g in range(3)]
    assert len(i) == sum(len(pairs) for pairs, _ in apart)


def test_one_pair_gives_the_bytes_of_the_same_pair_among_many() -> None:
    random = np.random.default_rng(1)
    low, high = [-30, -30, -3, 0.3, 0.3], [30, 30, 3, 9, 3]
    boxes = footprints([tuple(row) for row in random.uniform(low, high, (1000, 5))])
    others = boxes.take(np.arange(1000)[::-1])
    together = separation(boxes, others)
    alone = [separation(boxes.take([k]), others.take([k]))[0] for k in range(0, 1000, 37)]
    assert together[::37].tolist() == alone
