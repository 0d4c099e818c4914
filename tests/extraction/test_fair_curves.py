"""Drawn strokes become straight roads, round corners and even arcs, whatever the pen."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.drawings.__main__ import compared
from benchmarks.drawings.strokes import Pen, drawn, strokes_of
from roadlang.geometry import Curve
from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.curves.even_points import even_points
from roadlang_standard.extraction.curves.fair_lines import SeenOffsets
from roadlang_standard.extraction.curves.fairing import Rough, faired
from roadlang_standard.extraction.curves.junction_points import Passing, meeting_point
from roadlang_standard.extraction.curves.smoothing import stations
from roadlang_standard.extraction.graphs.tracing import trace
from tests.extraction.graph_drawings import dense

PENS = [Pen(1, False), Pen(3, True), Pen(20, False)]


def differences(shape: str, seed: int, pen: Pen) -> list[tuple[float, float, float]]:
    """Of each stroke: pixels off it, greatest curvature, and that of the stroke, in 1/px."""
    strokes = strokes_of(shape, seed, pen)
    picture = Picture(drawn(strokes, pen), 1.0)
    network = Auto().extract(picture).network
    found = []
    for stroke in strokes:
        away, curvature = compared(stroke, network, picture, 1.5 * pen.width + 3)
        assert not np.isnan(away).any()
        found.append((away.max(), curvature.max(), stroke.curvature[stroke.inner].max()))
    return found


@pytest.mark.parametrize(
    ("shape", "pen"),
    [("crossing", PENS[0]), ("crossing", PENS[2]), ("T", PENS[0]), ("grid", PENS[1])],
    ids=str,
)
def test_straight_strokes_are_straight_through_crossings_and_side_roads(
    shape: str, pen: Pen
) -> None:
    for away, curvature, _ in differences(shape, 11, pen):
        assert away < 0.5
        assert curvature < 0.005


@pytest.mark.parametrize("pen", PENS, ids=str)
def test_the_ring_of_a_drawn_roundabout_is_a_circle_all_round(pen: Pen) -> None:
    ring, *arms = differences("roundabout", 11, pen)
    assert ring[0] < 0.5
    assert ring[1] == pytest.approx(ring[2], rel=0.1)
    assert max(curvature for _, curvature, _ in arms) < 0.01


@pytest.mark.parametrize("pen", PENS, ids=str)
def test_a_line_drawn_by_hand_stays_as_smooth_as_it_was_drawn(pen: Pen) -> None:
    """A polygon would have its whole turn at a few places: several times the curvature."""
    ((away, curvature, truth),) = differences("by hand", 11, pen)
    assert away < 0.7
    assert curvature < 1.3 * truth


def test_roads_that_cross_at_an_acute_angle_meet_in_one_node() -> None:
    pen, size = Pen(9, True), 260
    strokes = strokes_of("crossing", 11, pen)
    middle, ahead = strokes[0].points.mean(axis=0), np.array([0.0, 1.0])
    skew = np.radians(25.0)
    second = np.array([np.sin(skew), np.cos(skew)])
    s = np.linspace(-95, 95, 381)[:, None]
    lines = [
        type(strokes[0])(middle + s * way, np.zeros(381), np.ones(381, bool))
        for way in (ahead, second)
    ]
    network = Auto().extract(Picture(drawn(lines, pen), 1.0)).network
    assert sorted(network.degree(node.id) for node in network.nodes) == [1, 1, 1, 1, 4]
    (place,) = [node.position for node in network.nodes if network.degree(node.id) == 4]
    assert place == pytest.approx((middle[0] + 0.5, size - 0.5 - middle[1]), abs=0.5)


def test_a_ring_is_whole_where_its_junction_is_a_knot_of_pixels() -> None:
    """The first step from a junction pixel must not run into the next branch's first pixel."""
    rows = (
        "#......",
        ".#.....",
        "..##...",
        "..#.#..",
        ".#...##",
        "#......",
    )
    graph = trace(np.array([[c == "#" for c in row] for row in rows]))
    assert sorted(graph.degree().values()) == [1, 1, 1, 3]


def test_within_the_tolerance_a_staircase_is_nearly_a_line() -> None:
    """Pixels of a stroke that rises by one in 75: steps of 1 px, and a quarter is left."""
    points = dense((0, 0), (300, 0))
    steps = np.floor(np.arange(301) / 75) - np.arange(301) / 75 + 0.5
    seen = SeenOffsets(steps, np.ones(301), np.full(301, 0.5))
    (line,) = faired([Rough(points, seen)])
    slope = np.polyfit(line[:, 0], line[:, 1], 1)
    assert np.abs(line[:, 1] - np.polyval(slope, line[:, 0])).max() < 1 / 4


def test_a_curve_passes_through_its_pins() -> None:
    points = dense((0, 0), (200, 0))
    seen = SeenOffsets(
        np.zeros(201), np.ones(201), np.full(201, 0.5), ((0, 0.0), (100, 0.8), (200, 0.0))
    )
    (line,) = faired([Rough(points, seen)])
    assert line[100, 1] == pytest.approx(0.8, abs=1e-3)


def test_a_line_becomes_the_same_whatever_lines_it_is_solved_with() -> None:
    """They are solved in one system, and more of them than go into one."""
    rng = np.random.default_rng(4)
    lines = []
    for count in (5, 40, 300, 9, 2000, 3000):
        points = dense((0, 0), (count, 0.2 * count))
        size = len(points)
        seen = SeenOffsets(rng.normal(0, 0.6, size), rng.random(size), np.full(size, 0.5))
        lines.append(Rough(points, seen))
    turn = np.linspace(0, 2 * np.pi, 201)
    ring = 32 * np.column_stack([np.cos(turn), np.sin(turn)])
    seen = SeenOffsets(rng.normal(0, 0.6, 201), np.ones(201), np.full(201, 0.5), ((0, 0.3),))
    lines.insert(3, Rough(ring, seen, closed=True))
    alone = [faired([line])[0] for line in lines]
    for one, together in zip(alone, faired(lines), strict=True):
        assert np.array_equal(one, together)


def test_a_closed_line_becomes_the_same_wherever_it_begins() -> None:
    """Only a part of a long one is repeated at its ends."""
    count, half = 3000, 1500
    turn = np.linspace(0, 2 * np.pi, count + 1)
    ring = (480 + 60 * np.cos(3 * turn))[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
    ring = even_points(ring, closed=True, step=float(stations(ring)[-1]) / count)
    noise = np.random.default_rng(4).normal(0, 0.6, count)
    noise = np.append(noise, noise[0])
    ones, tolerance = np.ones(count + 1), np.full(count + 1, 0.5)

    def begun_at(first: int) -> Rough:
        turned = (np.arange(count + 1) + first) % count
        seen = SeenOffsets(noise[turned], ones, tolerance, ((-first % count, 0.3),))
        return Rough(ring[turned], seen, closed=True)

    one, other = faired([begun_at(0), begun_at(half)])
    assert np.abs(one[half:] - other[: half + 1]).max() < 1e-5


def test_what_is_not_seen_between_two_lines_is_one_arc() -> None:
    """A right angle whose corner of 60 px is not seen: no bend is tighter than need be."""
    corner = np.vstack([dense((0, 0), (150, 0)), dense((150, 0), (150, 150))[1:]])
    unseen = np.abs(np.arange(301) - 150) < 30
    smooth = even_points(np.vstack([corner[:120], [[141.0, 9.0]], corner[181:]]))
    for _ in range(4):
        near = np.hypot(*(smooth[:, None] - corner[None]).transpose(2, 0, 1)).argmin(axis=1)
        line = Curve.through(smooth[::4])
        normal = line.normal(line.stations(count=len(smooth)))
        offset = ((corner[near] - smooth) * normal).sum(axis=1)
        seen = SeenOffsets(offset, np.where(unseen[near], 1e-6, 1.0), np.full(len(smooth), 0.5))
        (fair,) = faired([Rough(smooth, seen)])
        smooth = even_points(fair)
    tightest = np.abs(Curve.through(smooth[::3]).curvature(np.arange(5, 280, 1.0))).max()
    assert 20 < 1 / tightest < 40


def test_a_side_road_meets_the_road_that_goes_through_on_it() -> None:
    road = Passing(dense((0, 0), (100, 0)), through=True)
    side = Passing(dense((52, 40), (50, 4)), through=False)
    assert meeting_point(np.array([49.0, 1.0]), [road, side], 10.0) == pytest.approx(
        [50 - 4 / 18, 0], abs=0.01
    )


def test_a_meeting_is_not_farther_than_its_limit() -> None:
    """Two roads that are nearly parallel cross far away."""
    roads = [Passing(dense((0, 0), (100, 0)), True), Passing(dense((0, 3), (100, 2)), True)]
    place = meeting_point(np.array([50.0, 1.0]), roads, 5.0)
    assert np.hypot(*(place - [50, 1])) == pytest.approx(5.0)


def test_a_short_road_between_two_parallel_ones_stays() -> None:
    """An H: the roads at both ends of the short one are straight, but do not cross."""
    image = np.full((120, 200, 3), 230, np.uint8)
    image[31:39] = image[61:69] = image[31:69, 96:104] = 60
    network = Auto().extract(Picture(image, 1.0)).network
    assert sorted(network.degree(node.id) for node in network.nodes) == [1, 1, 1, 1, 3, 3]


@pytest.mark.parametrize("limit", [1.0, 2.0, 50.0])
def test_two_side_roads_that_disagree_both_meet_the_road_that_goes_through(limit: float) -> None:
    """Their own lines cross beside it; they end there, so it has the say."""
    road = Passing(dense((0, 0), (100, 0)), through=True)
    sides = [Passing(dense((48, 40), (48, 4)), False), Passing(dense((56, -40), (56, -4)), False)]
    guess = np.array([51.0, 1.0])
    place = meeting_point(guess, [road, *sides], limit)
    straight = np.array([1.0, -1.0]) * min(1.0, limit / np.sqrt(2.0))
    assert place == pytest.approx(guess + straight, abs=0.01)
    assert meeting_point(guess, [*sides[::-1], road], limit) == pytest.approx(place)
