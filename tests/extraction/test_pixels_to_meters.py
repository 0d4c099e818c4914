"""Light of photos, legends, and the way from pixels to meters, by hand."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extraction.free_space import roads_of_free_space
from roadlang_standard.extraction.legends.legend import LegendObject, read_colors, read_text
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad
from roadlang_standard.extraction.photos.exposure import even_exposure
from roadlang_standard.extraction.photos.scale import resized
from roadlang_standard.extraction.pixels_to_meters import extraction
from tests.extraction.graph_drawings import dense, surface

EVERYTHING = slice(None)


def band(top: int, bottom: int, height: int = 100, width: int = 200) -> np.ndarray:
    """A road across the picture between two rows."""
    return surface(height, width, (slice(top, bottom), EVERYTHING))


# Photos


def test_a_photo_has_one_mean_and_deviation_wherever_one_looks() -> None:
    noise = np.random.default_rng(2).normal(0, 20, (800, 800))
    light = np.where(np.arange(800) < 400, 70, 150)
    photo = np.clip(light + noise, 0, 255).astype(np.uint8)[..., None].repeat(3, axis=2)
    even = even_exposure(photo).astype(float)
    for part in (even[300:500, 50:150], even[300:500, 650:750]):
        assert part.mean() == pytest.approx(115, abs=4)
        assert part.std() == pytest.approx(50, rel=0.12)


def test_contrast_is_raised_at_most_fourfold() -> None:
    faint = 100 + np.random.default_rng(2).integers(-2, 3, (200, 200))
    photo = faint.astype(np.uint8)[..., None].repeat(3, axis=2)
    assert even_exposure(photo).std() == pytest.approx(4 * photo.std(), rel=0.1)


def test_a_margin_without_data_is_gray() -> None:
    photo = np.random.default_rng(2).integers(60, 180, (300, 300, 3), dtype=np.uint8)
    photo[:, :90] = 0
    assert (even_exposure(photo)[:, 5:80] == 115).all()


def test_a_picture_is_resized_by_a_factor() -> None:
    image = np.zeros((40, 100, 3), np.uint8)
    assert resized(image, 0.5).shape == (20, 50, 3)
    assert resized(image, 1) is image
    assert resized(image, 0.001).shape == (1, 1, 3)


# From pixels to meters


def road_of(points: np.ndarray, confidence: float = 1.0, linked: float = 0.0) -> FoundRoad:
    return FoundRoad(0, 1, points, np.full(len(points), 4.0), 0.5, confidence, linked)


def network(*roads: FoundRoad) -> FoundNetwork:
    ends = roads[0].points[[0, -1]]
    return FoundNetwork(ends, roads, np.zeros((20, 60), bool), "by hand", ("seen",))


def test_roads_of_a_smaller_picture_are_moved_to_the_larger_one() -> None:
    """Pixel centers: 0 becomes 0.5 and 10 becomes 20.5 in a picture twice as large."""
    small = network(road_of(dense((0, 3), (10, 3)), 0.7, 0.2))
    large = small.scaled(2.0, (40, 120))
    (road,) = large.roads
    assert road.points[[0, -1]].tolist() == large.nodes.tolist() == [[0.5, 6.5], [20.5, 6.5]]
    assert (road.widths[0], road.width_error, road.confidence, road.linked) == (8, 1, 0.7, 0.2)
    assert large.mask.shape == (40, 120)
    assert (large.method, large.remarks) == ("by hand", ("seen",))


def test_the_confidence_of_a_network_is_the_mean_over_its_length() -> None:
    """30 px of 0.9 and 10 px of 0.5."""
    found = network(road_of(dense((0, 3), (30, 3)), 0.9), road_of(dense((0, 3), (10, 3)), 0.5))
    assert found.confidence == pytest.approx(0.8)


def test_a_road_in_meters_has_its_origin_at_the_lower_left() -> None:
    """20 rows of half a meter: row 3 lies 3.5 px below the top, 8.25 m above the bottom."""
    picture = Picture(np.zeros((20, 60, 3), np.uint8), 0.5)
    result = extraction(picture, network(road_of(dense((10, 3), (40, 3)))))
    (edge,) = result.network.edges
    ends = edge.curve.at([0.0, edge.curve.length])
    assert ends.ravel() == pytest.approx([5.25, 8.25, 20.25, 8.25])
    assert edge.curve.length == pytest.approx(15)
    assert edge.width.at([0.0, 7.0]) == pytest.approx(2.0)
    assert result.width_errors == (0.25,)
    assert result.remarks == ("seen",)


def test_a_thing_in_meters_is_turned_as_y_runs_up() -> None:
    picture = Picture(np.zeros((20, 60, 3), np.uint8), 0.5)
    thing = LegendObject("house", 9.5, 4.5, 10.0, 6.0, 0.3)
    (house,) = extraction(picture, network(road_of(dense((10, 3), (40, 3)))), [thing]).objects
    assert (house.x, house.y, house.length, house.width, house.heading) == pytest.approx(
        (5.0, 7.5, 5.0, 3.0, -0.3)
    )


def test_up_to_five_doubtful_roads_are_remarked_on_longest_first() -> None:
    picture = Picture(np.zeros((20, 60, 3), np.uint8), 0.5)
    roads = [road_of(dense((0, 3), (10 + i, 3)), 0.4) for i in range(7)]
    sure = road_of(dense((0, 3), (50, 3)), 0.5)
    remarks = extraction(picture, network(sure, *roads), remarks=["read"]).remarks
    assert remarks[:2] == ("read", "seen")
    assert remarks[2] == "a road of 16 px at (8px, 3px) is only 40% sure"
    assert len(remarks) == 8
    assert remarks[-1] == "2 more roads are less than 50% sure"


def test_doubtful_stretches_of_sure_roads_are_remarked_on() -> None:
    picture = Picture(np.zeros((20, 160, 3), np.uint8), 0.5)
    along = np.full(76, 0.9)
    along[20:41], along[60:75] = 0.3, 0.2
    road = replace(road_of(dense((0, 3), (150, 3)), 0.7), confidences=along)
    points = np.column_stack([np.linspace(0, 150, 76), np.full(76, 3.0)])
    road = replace(road, points=points, widths=np.full(76, 4.0))
    result = extraction(picture, network(road, replace(road, confidences=None)))
    assert result.remarks == ("seen", "a stretch of 40 px at (60px, 3px) is only 30% sure")
    assert result.confidences[0] == pytest.approx(along)
    assert result.confidences[1] == pytest.approx([0.7])


def test_free_space_is_read_in_meters_and_noise_by_its_size() -> None:
    """A corridor of 20 cells of 5 cm and a hole of 6 x 6 cells in it: 0.3 m."""
    free = band(40, 60) > 0
    free[47:53, 90:96] = False
    smooth_one = roads_of_free_space(free, 0.05, None, 0.35)
    (edge,) = smooth_one.network.edges
    assert float(edge.width.at(5.0)) == pytest.approx(1.0, abs=0.05)
    assert len(roads_of_free_space(free, 0.05, None, 0.25).network.edges) > 1
    (fixed,) = roads_of_free_space(free, 0.05, 0.8, 0.35).network.edges
    assert fixed.width.at(5.0) == pytest.approx(0.8)


# Legends


def test_typed_roads_are_a_cell_wide_or_as_thick_as_said() -> None:
    for thickness in (1.0, 2.5):
        (road,) = read_text(("###",), {"#": "road"}, thickness)[0].roads
        assert set(road.widths) == {thickness}


def test_short_rows_are_filled_with_nothing() -> None:
    found, things = read_text(("###", "T", ""), {"#": "road", "T": "tree", " ": "sea"})
    assert len(found.roads) == 1
    assert [(thing.kind, thing.x, thing.y) for thing in things] == [
        ("tree", 0, 1), ("sea", 1, 1), ("sea", 2, 1), ("sea", 0, 2), ("sea", 1, 2), ("sea", 2, 2)
    ]  # fmt: skip


@pytest.mark.parametrize(("away", "count"), [(59, 1), (60, 0)])
def test_a_color_far_from_the_legend_is_nothing(away: int, count: int) -> None:
    image = np.zeros((40, 60, 3), np.uint8)
    image[18:22] = 255 - away
    found, _ = read_colors(image, {"white": "road", "#ff0000": "house"})
    assert len(found.roads) == count


def test_a_turned_house_keeps_its_sides_and_its_heading() -> None:
    """30 degrees clockwise, for y runs down."""
    image = np.zeros((120, 120, 3), np.uint8)
    corners = cv2.boxPoints(((60.0, 50.0), (40.0, 20.0), 30.0))
    cv2.fillConvexPoly(image, np.round(corners).astype(np.int32), (0, 0, 255))
    image[110:116] = 255
    _, (house,) = read_colors(image, {"white": "road", "red": "house"})
    assert (house.x, house.y) == pytest.approx((60, 50), abs=0.6)
    assert (house.length, house.width) == pytest.approx((41, 21), abs=1.6)
    assert np.degrees(house.heading) == pytest.approx(30, abs=2)


def test_things_are_listed_from_the_top_down_and_from_the_left() -> None:
    image = np.zeros((60, 60, 3), np.uint8)
    image[55:59] = 255
    for x, y in ((40, 10), (10, 30), (10, 10)):
        image[y : y + 4, x : x + 4] = (0, 0, 255)
    _, things = read_colors(image, {"white": "road", "red": "house"})
    assert [(thing.x, thing.y) for thing in things] == [(11.5, 11.5), (41.5, 11.5), (11.5, 31.5)]
