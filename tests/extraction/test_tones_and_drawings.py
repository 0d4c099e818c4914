"""The tones of drawings, and the roads that are drawn with them."""

from __future__ import annotations

import tracemalloc

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.colors.tones import away_from, flatness, layers, thinned, tones
from roadlang_standard.extraction.drawings.drawing import between_lines, likeness, roads_of_drawing
from roadlang_standard.extraction.drawings.surface_roads import roads_of_surface
from roadlang_standard.extraction.drawings.thresholding import ContourSteps, roads_by_contour
from roadlang_standard.extraction.picture_kinds.picture_kind import picture_kind
from tests.extraction.graph_drawings import surface
from tests.extraction.painted_roads import band, painted, two_lines

# Tones


PURE = [(blue, green, red) for blue in (250, 0) for green in (0, 250) for red in (0, 250)]


def plan(*shares: tuple[tuple[int, int, int], int]) -> np.ndarray:
    """Columns of colors, each of so many columns of a hundred."""
    columns = [color for color, count in shares for _ in range(count)]
    return np.array([columns] * 60, np.uint8)


def test_the_tones_of_a_drawing_by_their_shares() -> None:
    found = tones(plan(((255, 255, 255), 70), ((40, 40, 40), 25), ((0, 0, 250), 5)))
    assert found.colors.tolist() == [[255, 255, 255], [40, 40, 40], [0, 0, 250]]
    assert found.shares == pytest.approx([0.7, 0.25, 0.05])
    assert found.paper == 0
    assert found.covered == pytest.approx(1.0)


def test_the_paper_is_what_lies_at_the_rim() -> None:
    """60 % of the picture are dark, but all of its rim is white."""
    image = np.full((100, 100, 3), 255, np.uint8)
    image[11:89, 11:89] = 20
    assert tones(image).colors[tones(image).paper].tolist() == [255, 255, 255]


def test_rare_tones_are_left_out() -> None:
    found = tones(plan(((255, 255, 255), 99), ((0, 0, 0), 1)), least=0.02)
    assert len(found.colors) == 1
    assert len(tones(plan(((255, 255, 255), 99), ((0, 0, 0), 1)), most=1).colors) == 1


def test_the_worst_channel_says_how_far_a_color_is() -> None:
    image = np.array([[[10, 200, 30]]], np.uint8)
    assert away_from(image, np.array([20.0, 150.0, 30.4])).tolist() == [[50]]


def test_a_picture_is_thinned_to_about_so_many_pixels() -> None:
    assert thinned(np.zeros((100, 100, 3), np.uint8), 2500).shape == (50, 50, 3)
    assert thinned(np.zeros((100, 100, 3), np.uint8), 10_000).shape == (100, 100, 3)


def test_a_drawing_is_flat_but_for_its_edges() -> None:
    """At each of two edges, two columns of a hundred see both tones in their 3 x 3 pixels."""
    image = plan(((255, 255, 255), 40), ((0, 0, 0), 20), ((255, 255, 255), 40))
    assert flatness(image) == pytest.approx(0.96)
    left = np.zeros((60, 100), bool)
    left[:, :30] = True
    assert flatness(image, left) == 1.0
    noisy = np.random.default_rng(1).integers(0, 255, (60, 100, 3), dtype=np.uint8)
    assert flatness(noisy) < 0.01


def test_on_an_edge_between_tones_a_pixel_has_its_share() -> None:
    black, white = np.zeros(3), np.full(3, 255.0)
    image = np.array([[[0] * 3, [51] * 3, [204] * 3, [255] * 3]], np.uint8)
    assert layers(image, [black], white)[0][0] == pytest.approx([1, 0.8, 0.2, 0], abs=1e-6)


# Drawings


def test_a_road_drawn_by_two_lines_reaches_to_their_middles() -> None:
    """Lines of rows 30 to 32 and 60 to 62: from 31 to 61, 30 px wide about row 46."""
    ink = two_lines() > 0
    between = between_lines(ink)
    assert between is not None
    (road,) = roads_of_surface(between, "").roads
    assert road.points[:, 1] == pytest.approx(np.full(len(road.points), 46.0), abs=0.3)
    assert np.median(road.widths) == pytest.approx(30, abs=1.0)


def test_lines_with_gaps_are_closed() -> None:
    ink = two_lines() > 0
    ink[30:33, 100:105] = False
    assert between_lines(ink) is not None
    ink[30:33, 100:160] = False
    assert between_lines(ink) is None


def test_two_filled_roads_are_no_edge_lines() -> None:
    ink = np.zeros((100, 400), bool)
    ink[20:40], ink[60:80] = True, True
    assert between_lines(ink) is None


@pytest.mark.parametrize(("bulge", "is_road"), [(0, True), (15, True), (60, False)])
def test_a_block_between_filled_roads_that_draw_near_at_both_ends_is_no_road(
    bulge: int, is_road: bool
) -> None:
    x = np.linspace(50, 950, 200)
    away = 20 + bulge * np.exp(-(((x - 500) / 90) ** 2))
    ink = np.zeros((400, 1000), np.uint8)
    for y in (200 - away, 200 + away):
        cv2.polylines(ink, [np.column_stack([x, y]).round().astype(np.int32)], False, 1, 5)
    ink[:, 48:53] = ink[:, 948:953] = 0
    ink[180:221, 48:53] = ink[180:221, 948:953] = 1
    assert (between_lines(ink > 0) is not None) == is_road


def test_a_long_even_band_looks_more_like_a_road_than_a_blot() -> None:
    blot = np.zeros((100, 200), np.float32)
    cv2.circle(blot, (100, 50), 40, 1.0, -1)
    short = surface(100, 200, (slice(46, 54), slice(90, 110)))
    assert likeness(band(46, 54)) > 3 * likeness(blot)
    assert likeness(band(46, 54)) > 3 * likeness(short)
    assert likeness(np.zeros((100, 200), np.float32)) == 0.0


def test_a_filled_road_is_found_whatever_its_color() -> None:
    for road, ground in ((90, 230), (230, 90)):
        found = roads_of_drawing(painted(band(40, 60), road, ground))
        assert found.method == "filled road"
        assert found.roads[0].points[:, 1].mean() == pytest.approx(49.5, abs=0.3)
    assert roads_of_drawing(np.full((50, 50, 3), 9, np.uint8)).remarks == (
        "the picture has one color",
    )


@pytest.mark.parametrize(("road", "rows"), [("dark", 49.5), ("light", None), ("auto", 49.5)])
def test_the_side_of_the_threshold_that_is_road(road: str, rows: float | None) -> None:
    """A dark band on light ground: as the light side, the ground is taken for two roads."""
    found = roads_by_contour(painted(band(40, 60)), ContourSteps(road=road))
    if rows is None:
        assert len(found.roads) != 1
    else:
        assert found.roads[0].points[:, 1].mean() == pytest.approx(rows, abs=0.3)


def test_a_threshold_is_found_between_the_tones_or_given() -> None:
    image = painted(band(40, 60))
    assert 90 < 255 * roads_by_contour(image, ContourSteps()).scores["threshold"] < 230
    assert roads_by_contour(image, ContourSteps(threshold=0.5)).scores["threshold"] == 0.5
    one = roads_by_contour(image, ContourSteps(threshold=0.1))
    assert one.remarks == ("the picture has one tone",)


@pytest.mark.parametrize(
    ("image", "name"),
    [
        (painted(band(40, 60), 255, 0), "mask"),
        (painted(band(40, 60), 90, 230), "filled drawing"),
        (painted(two_lines(), 0, 255), "edge-line drawing"),
        (plan(((255, 255, 255), 40), ((0, 0, 250), 20), ((250, 0, 0), 20), ((0, 250, 0), 20)),
         "color map"),
        (plan(*zip(PURE, (40, 30, 9, 8, 5, 4, 2, 2), strict=True)), "color map"),
        (plan(*zip(PURE, (30, 10, 10, 10, 10, 10, 10, 10), strict=True)), "photo"),
        (np.random.default_rng(1).integers(0, 255, (100, 200, 3), dtype=np.uint8), "photo"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)  # fmt: skip
def test_kinds_of_pictures(image: np.ndarray, name: str) -> None:
    assert picture_kind(image).name == name
    assert picture_kind(image).drawn == (name != "photo")


def test_histograms_of_later_versions_of_opencv_have_one_axis(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Version 5 gives (256,) where version 4 gave (256, 1)."""
    usual = cv2.calcHist
    monkeypatch.setattr(cv2, "calcHist", lambda *given: usual(*given).ravel())
    found = roads_by_contour(painted(band(40, 60)), ContourSteps())
    assert len(found.roads) == 1


def test_a_ring_road_has_no_seam() -> None:
    """A circle of 60 px radius and 12 px width, all the way round."""
    y, x = np.mgrid[:200, :200]
    away = np.hypot(x - 100.0, y - 100.0)
    mask = np.clip(0.5 + 6.0 - np.abs(away - 60.0), 0, 1).astype(np.float32)
    (road,) = roads_of_surface(mask, "").roads
    assert road.closed
    assert np.hypot(*(road.points - 100.0).T) == pytest.approx(
        np.full(len(road.points), 60.0), abs=0.25
    )
    assert road.widths == pytest.approx(np.full(len(road.points), 12.0), abs=0.4)
    assert road.length == pytest.approx(2 * np.pi * 60, rel=0.003)


def test_a_large_drawing_needs_little_memory() -> None:
    """Of pixels there are millions: what is worked out for each is let go when it is done with."""
    image = np.full((1000, 1000, 3), 255, np.uint8)
    for place, pen in ((200, 16), (450, 9), (700, 12)):
        cv2.line(image, (0, place), (1000, place + 60), (50, 50, 50), pen, cv2.LINE_AA)
        cv2.line(image, (place, 0), (place - 50, 1000), (50, 50, 50), pen - 2, cv2.LINE_AA)
    roads_by_contour(image, ContourSteps())
    tracemalloc.start()
    try:
        roads_by_contour(image, ContourSteps())
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert most < 27 * 1000 * 1000
