"""The map of a figure: its extent, scale bar, north arrow, marks of arc length, by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang_standard.svg import furniture
from roadlang_standard.svg.viewport import BoundingBox, Viewport, bounds, fitted, within
from tests.backends.handmade_scenes import actor, bend
from tests.backends.svg_shapes import (
    PAGE,
    numbers,
    of,
    points,
    straight,
    straight_ribbon,
    written,
)

FONT = 10.0


def extent(view: Viewport) -> list[float]:
    return [view.box.left, view.box.bottom, view.box.right, view.box.top]


def test_meters_become_pixels_with_y_down() -> None:
    view = Viewport(BoundingBox(-10.0, 20.0, 90.0, 70.0), 12.0, 35.0, 500.0, 250.0)
    assert view.pixels_per_meter == 5.0
    assert view.place([[-10.0, 70.0], [0.0, 20.0]]).tolist() == [[12.0, 35.0], [62.0, 285.0]]


def test_a_map_has_a_margin_of_6_percent_of_its_longer_side() -> None:
    view = fitted(BoundingBox(0.0, 0.0, 100.0, 50.0), 12.0, 35.0, 560.0)
    assert extent(view) == [-6.0, -6.0, 106.0, 56.0]
    assert (view.x, view.y, view.width, view.height) == (12.0, 35.0, 560.0, 310.0)


@pytest.mark.parametrize(
    ("width", "height", "shape"),
    [(10.0, 200.0, 1.05), (1000.0, 0.0, 1 / 3.2), (100.0, 100.0, 1.0), (0.0, 0.0, 12.4 / 22.4)],
)
def test_a_map_is_neither_too_tall_nor_too_wide(width: float, height: float, shape: float) -> None:
    view = fitted(BoundingBox(0.0, 0.0, width, height), 0.0, 0.0, 1000.0)
    assert view.height / view.width == pytest.approx(shape)
    assert view.box.height / view.box.width == pytest.approx(shape)
    assert (view.box.left + view.box.right) / 2 == pytest.approx(width / 2)
    assert (view.box.bottom + view.box.top) / 2 == pytest.approx(height / 2)


def test_what_is_smaller_than_20_meters_is_shown_with_what_lies_around() -> None:
    view = fitted(BoundingBox(5.0, 5.0, 6.0, 6.0), 0.0, 0.0, 1000.0)
    assert (view.box.width, view.box.height) == pytest.approx((22.4, 12.4))


@pytest.mark.parametrize(
    ("width", "height", "frame", "shown"),
    [
        (100.0, 50.0, (200.0, 200.0), (112.0, 112.0)),
        (50.0, 100.0, (400.0, 100.0), (448.0, 112.0)),
        (1.0, 1.0, (100.0, 100.0), (22.4, 22.4)),
    ],
)
def test_a_cell_of_a_sheet_keeps_its_shape_and_shows_everything(
    width: float, height: float, frame: tuple[float, float], shown: tuple[float, float]
) -> None:
    cell = Viewport(BoundingBox(0.0, 0.0, 1.0, 1.0), 7.0, 9.0, *frame)
    view = within(BoundingBox(0.0, 0.0, width, height), cell)
    assert (view.box.width, view.box.height) == pytest.approx(shown)
    assert (view.x, view.y, view.width, view.height) == (7.0, 9.0, *frame)
    assert (view.box.left + view.box.right) / 2 == pytest.approx(width / 2)
    assert (view.box.bottom + view.box.top) / 2 == pytest.approx(height / 2)


def test_a_scene_reaches_to_the_edges_of_roads_and_the_corners_of_agents() -> None:
    """A thing of 3 m x 4 m reaches 2.5 m from its center however it is turned."""
    alone = replace(bend(), roads=(straight(),), agents=(), objects=())
    box = bounds(alone)
    assert (box.left, box.bottom, box.right, box.top) == (-4.0, 21.0, 104.0, 29.0)
    car, tree = (
        actor(name, "car", 50, y, length=3.0, width=4.0) for name, y in (("a", 90), ("b", -9))
    )
    box = bounds(replace(alone, agents=(car,), objects=(tree,)))
    assert (box.left, box.bottom, box.right, box.top) == (-4.0, -11.5, 104.0, 92.5)


def test_the_widest_place_of_a_road_counts() -> None:
    widths = (8.0,) * 399 + (12.0,)
    box = bounds(replace(bend(), roads=(straight(width=widths),), agents=(), objects=()))
    assert (box.bottom, box.top) == (19.0, 31.0)


def test_a_scale_bar_has_two_halves_and_ends_at_the_right() -> None:
    """The page is 100 m wide: the greatest round length below 18 % is 10 m, 100 pixels."""
    drawn = furniture.scale_bar(PAGE, FONT, 900.0, 20.0)
    boxes = [numbers(box, "x", "y", "width", "height") for box in of(drawn, "rect")]
    assert boxes == [[800, 20, 50, 5], [850, 20, 50, 5], [800, 20, 100, 5]]
    assert written(drawn) == [("0", 800, 36.5), ("5", 850, 36.5), ("10 m", 900, 36.5)]


@pytest.mark.parametrize(
    ("meters", "labels"),
    [(10_000.0, ["0", "0.5", "1 km"]), (5000.0, ["0", "250", "500 m"]), (6.0, ["0", "0.5", "1 m"])],
)
def test_a_long_scale_bar_is_in_kilometers(meters: float, labels: list[str]) -> None:
    view = Viewport(BoundingBox(0.0, 0.0, meters, meters), 0.0, 0.0, 500.0, 500.0)
    assert [label for label, _, _ in written(furniture.scale_bar(view, FONT, 0, 0))] == labels


def test_the_north_arrow_points_up_and_its_east_half_is_dark() -> None:
    drawn = furniture.north_arrow(100.0, 200.0, FONT)
    light, dark = of(drawn, "polygon")
    assert light.get("fill") == "#ffffff"
    assert points(light) == [(100.0, 185.0), (100.0, 206.75), (93.8, 212.0)]
    assert points(dark) == [(100.0, 185.0), (100.0, 206.75), (106.2, 212.0)]
    assert written(drawn) == [("N", 100.0, 181.5)]


def test_the_world_is_noted_in_the_lower_right_corner() -> None:
    scene = replace(bend(), world={"friction": 0.5, "weather": "fog", "time_of_day": 3700})
    assert written(furniture.world_note(scene, PAGE, FONT)) == [
        ("fog · 01:02 · friction 0.50", 992, 492)
    ]
    assert furniture.world_note(replace(bend(), world={"wind": 3.0}), PAGE, FONT) == ""


def test_marks_of_arc_length_stand_every_round_length_at_the_right_edge() -> None:
    """95 pixels are 9.5 m: the greatest round length below is 5 m."""
    drawn = furniture.station_marks(straight_ribbon(), PAGE, FONT)
    ticks = [numbers(tick, "x1", "y1", "x2", "y2") for tick in of(drawn, "line")]
    assert np.asarray(ticks) == pytest.approx(
        np.array([[50 * i, 291.5, 50 * i, 296.0] for i in range(21)]), abs=0.02
    )
    labels = written(drawn)
    assert [label for label, _, _ in labels] == ["0 m", *map(str, range(5, 100, 5)), "100 m"]
    assert [(x, y) for _, x, y in labels][3] == pytest.approx((150, 307.8), abs=0.02)
    boxes = list(furniture.station_boxes(straight_ribbon(), PAGE, FONT))
    assert len(boxes) == 21
    # Two digits of 8 px at (150, 307.8); a line of text is 1.1 font sizes high.
    box = boxes[3]
    assert (box.left, box.right) == pytest.approx((145.76, 154.24), abs=0.02)
    assert (box.top, box.bottom) == pytest.approx((300.6, 309.4), abs=0.02)


def test_marks_of_arc_length_avoid_other_roads() -> None:
    """A road below covers the numbers from 40 m on: they stand above the road instead. Where
    another lies above, too, as many are covered there: those are left out."""
    below = np.array([(400.0, 300.0), (1100.0, 300.0), (1100.0, 330.0), (400.0, 330.0)])
    above = below - (0.0, 120.0)
    drawn = furniture.station_marks(straight_ribbon(), PAGE, FONT, [below])
    places = {label: y for label, _, y in written(drawn)}
    assert len(places) == 21
    assert places["20"] == places["60"] == pytest.approx(197.8, abs=0.02)
    between = furniture.station_marks(straight_ribbon(), PAGE, FONT, [below, above])
    assert [label for label, _, _ in written(between)] == ["0 m", *map(str, range(5, 40, 5))]
    boxes = furniture.station_boxes(straight_ribbon(), PAGE, FONT, [below, above])
    assert len(list(boxes)) == 8


def test_marks_count_from_the_root_of_a_road() -> None:
    """Half of the root is left: its marks begin at 50 m, at the start of the road."""
    straight_road = straight()
    root = tuple(50.0 + s / 2 for s in straight_road.stations)
    drawn = furniture.station_marks(straight_ribbon(reference_stations=root), PAGE, FONT)
    places = {label: x for label, x, _ in written(drawn)}
    assert places["60"] == pytest.approx(200, abs=0.1)
    assert places["100 m"] == pytest.approx(1000, abs=0.1)


def test_the_last_mark_of_a_ring_does_not_stand_on_its_first() -> None:
    angles = np.linspace(0.0, 2 * np.pi, 200, endpoint=False)
    from roadlang_standard.svg.ribbon import ribbon_of
    from tests.backends.handmade_scenes import through

    ring = through("ring", [(50 + 15 * np.cos(a), 25 + 15 * np.sin(a)) for a in angles])
    closed = replace(ring, closed=True, length=2 * np.pi * 15)
    labels = [label for label, _, _ in written(
        furniture.station_marks(ribbon_of(closed, PAGE), PAGE, FONT))]  # fmt: skip
    # 94.2 m around: 95 would stand beside 0; 90 is 4.2 m from it, more than 0.6 of 5 m.
    assert labels[0] == "0 m"
    assert labels[-1] == "90 m"


def test_the_rectangle_of_the_map_is_ground_frame_and_clip() -> None:
    view = Viewport(BoundingBox(0.0, 0.0, 10.0, 5.0), 3.0, 4.0, 100.0, 50.0)
    for drawn in (furniture.ground(view), furniture.frame(view), furniture.clip(view, "map")):
        (box,) = of(drawn, "rect")
        assert numbers(box, "x", "y", "width", "height") == [3, 4, 100, 50]
    assert of(furniture.clip(view, "map"), "clipPath")[0].get("id") == "map"
