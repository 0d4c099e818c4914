"""Roads drawn on paper and photographed."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.curves.edges import normals
from roadlang_standard.extraction.drawings.open_edges import with_closed_ends
from roadlang_standard.extraction.paper.even_ground import has_even_ground
from roadlang_standard.extraction.paper.grain import without_grain
from roadlang_standard.extraction.paper.paper import roads_on_paper, sheet_of
from roadlang_standard.extraction.paper.ruling import without_ruling
from roadlang_standard.extraction.paper.sheet_outline import sheet_outline
from tests.extraction.paper_drawings import (
    drawn,
    on_desk,
    overexposed,
    photographed,
    ruled,
    sheet,
    wave,
)
from training.rendering.aerial import render_aerial

VILLAGE = Path(__file__).parents[2] / "examples" / "village.jpg"


def distances(points: np.ndarray, line: np.ndarray) -> np.ndarray:
    return np.asarray(np.hypot(*(points[:, None] - line[None]).transpose(2, 0, 1)).min(axis=1))


def assert_one_road_along(image: np.ndarray, line: np.ndarray) -> None:
    found = roads_on_paper(image)
    assert found is not None
    (road,) = found.roads
    assert np.quantile(distances(road.points, line), 0.95) < 3
    assert np.quantile(distances(line, road.points), 0.95) < 3


def assert_no_road(image: np.ndarray) -> None:
    found = roads_on_paper(image)
    assert found is not None
    assert found.roads == ()
    assert found.remarks == ("no line on the paper is long enough to be a road",)


@pytest.mark.parametrize("pen", [2, 3, 12])
def test_a_line_in_uneven_light_is_a_road(pen: int) -> None:
    assert_one_road_along(photographed(drawn(sheet(), wave(), pen)), wave())


@pytest.mark.parametrize("squared", [False, True])
def test_printed_lines_of_the_paper_are_no_roads(squared: bool) -> None:
    assert_one_road_along(photographed(drawn(ruled(sheet(), squared), wave())), wave())
    assert_no_road(photographed(ruled(sheet(), squared)))


def test_two_lines_side_by_side_are_the_edges_of_one_road_with_open_ends() -> None:
    aside = 14 * normals(wave())
    image = photographed(drawn(drawn(sheet(), wave() + aside), wave() - aside))
    assert_one_road_along(image, wave())
    found = roads_on_paper(image)
    assert found is not None
    assert np.median(found.roads[0].widths) == pytest.approx(28, abs=3)


@pytest.mark.parametrize("desk", [(45, 45, 50), (85, 135, 185)], ids=["dark", "wood"])
def test_a_sheet_on_a_desk_is_read_without_its_rim(desk: tuple[int, int, int]) -> None:
    image, homography = on_desk(photographed(drawn(ruled(sheet()), wave())), desk)
    line = cv2.perspectiveTransform(wave()[None].astype(np.float32), homography)[0]
    assert_one_road_along(image, line)
    assert_no_road(on_desk(photographed(sheet()), desk)[0])


def test_a_sheet_that_the_picture_cuts_off_is_read() -> None:
    image, homography = on_desk(photographed(drawn(sheet(), wave())), (45, 45, 50))
    line = cv2.perspectiveTransform(wave()[None].astype(np.float32), homography)[0]
    assert_one_road_along(image[:300], line)


def test_letters_are_no_roads() -> None:
    image = sheet()
    for row in range(40, 340, 30):
        place, font = (30, row), cv2.FONT_HERSHEY_SIMPLEX
        cv2.putText(image, "some words, not roads", place, font, 0.6, (40, 40, 40), 1, cv2.LINE_AA)
    assert_no_road(photographed(image))


def test_photos_from_above_and_drawings_made_on_a_screen_are_no_sheets() -> None:
    photo = render_aerial("curve", 901, 256).image
    assert sheet_outline(photo) is None
    assert sheet_of(photo) is None
    assert sheet_of(drawn(sheet(), wave())) is None


def test_paper_has_even_ground_and_a_photo_from_above_has_none() -> None:
    """So most photos are not searched for a sheet."""
    squared = photographed(drawn(ruled(sheet(), squared=True), wave(), 12))
    assert has_even_ground(squared)
    assert has_even_ground(on_desk(squared, (85, 135, 185))[0])
    assert not has_even_ground(cv2.imread(str(VILLAGE)))


def test_a_small_sheet_on_a_textured_desk_has_even_ground() -> None:
    """A sixth of the picture."""
    desk = np.random.default_rng(5).normal(110, 40, (360, 480, 3)).clip(0, 255).astype(np.uint8)
    assert not has_even_ground(desk)
    desk[90:230, 120:310] = photographed(drawn(sheet(), wave()))[90:230, 120:310]
    assert has_even_ground(desk)


def test_only_what_is_darker_than_a_printed_line_stays_upon_it() -> None:
    ink = np.zeros((100, 200), np.float32)
    ink[10::15] = 0.3
    ink[:, 98:103] = 0.8
    cleaned = without_ruling(ink, 0.1)
    assert cleaned[:, 98:103].min() == pytest.approx(0.8)
    assert not cleaned[:, :98].any()
    assert not cleaned[:, 103:].any()


def test_the_faint_margin_of_ruled_paper_is_printed() -> None:
    ink = np.zeros((100, 200), np.float32)
    ink[:, 30:32] = 0.35
    assert (without_ruling(ink, 0.1) == ink).all()
    ink[10::15] = 0.15
    assert not without_ruling(ink, 0.1).any()


@pytest.mark.parametrize(("dark", "length"), [(0.45, 100), (0.3, 70)])
def test_a_margin_is_about_as_faint_as_the_lines_and_as_long_as_the_sheet(
    dark: float, length: int
) -> None:
    ink = np.zeros((100, 200), np.float32)
    ink[10::15] = 0.1
    ink[:length, 30:32] = dark
    cleaned = without_ruling(ink, 0.08)
    assert cleaned[:length, 30:32].min() == pytest.approx(dark)
    assert not cleaned[:, 40:].any()


def test_few_straight_lines_are_not_printed() -> None:
    ink = np.zeros((100, 200), np.float32)
    ink[20::30] = 0.3
    assert (without_ruling(ink, 0.1) == ink).all()


@pytest.mark.parametrize("paper", [sheet(), ruled(sheet()), ruled(sheet(), squared=True)])
def test_straight_streets_as_dark_as_other_ink_are_not_printed(paper: np.ndarray) -> None:
    """Six each way, as even as printed lines: 6 x 7 pieces each way."""
    town = paper
    for x in range(60, 440, 70):
        town = drawn(town, np.array([[x, 30.0], [x + 6, 330.0]]))
    for y in range(50, 320, 50):
        town = drawn(town, np.array([[40.0, y], [445.0, y - 8]]))
    found = roads_on_paper(photographed(town))
    assert found is not None
    assert len(found.roads) == 2 * 6 * 7
    assert found.confidence > 0.9


def test_ends_are_closed_only_between_lines_that_run_the_same_way_abreast() -> None:
    ink = np.zeros((100, 200), bool)
    ink[40:43, 20:180] = True
    assert with_closed_ends(ink, 3.0) is None
    ink[60:63, 20:180] = True
    closed = with_closed_ends(ink, 3.0)
    assert closed is not None
    assert closed[40:63, 21].all()
    assert closed[40:63, 178].all()
    assert not closed[50, 40:160].any()


def test_auto_says_that_a_picture_is_a_drawing_on_paper() -> None:
    found = Auto().extract(Picture(photographed(drawn(sheet(), wave())), 0.5))
    assert found.remarks[0] == "read as a drawing on paper"
    length = np.hypot(*np.diff(wave(), axis=0).T).sum()
    assert found.network.edges[0].length == pytest.approx(0.5 * length, rel=0.02)


def test_a_scan_with_little_noise_is_a_drawing_on_paper() -> None:
    """Most of it is nearly white, as of a drawing made on a screen, but nothing is even."""
    page = cv2.resize(drawn(sheet(), wave(), 3), None, fx=1.5, fy=1.5)
    noise = np.random.default_rng(2).normal(0, 3, (*page.shape[:2], 1))
    scan = np.clip(page.astype(float) + 12 + noise, 0, 255).astype(np.uint8)
    found = Auto().extract(Picture(scan, 1.0))
    assert found.remarks[0] == "read as a drawing on paper"
    assert len(found.network.edges) == 1


@pytest.mark.parametrize("pen", [(90, 190, 60), (70, 40, 30)], ids=["pale", "dark"])
@pytest.mark.parametrize("lines", [False, True], ids=["plain", "ruled"])
def test_an_overexposed_sheet_is_a_drawing_on_paper(pen: tuple[int, ...], lines: bool) -> None:
    """Much of it is pure white, as on a screen, but the shade of a hand has the camera's noise."""
    image = overexposed(drawn(ruled(sheet()) if lines else sheet(), wave(), 6, pen))
    assert (image == 255).all(axis=2).mean() > 0.25
    found = Auto().extract(Picture(image, 0.5))
    assert found.remarks[0] == "read as a drawing on paper"
    assert len(found.network.edges) == 1


def test_a_crayon_that_leaves_grain_is_one_stroke() -> None:
    """Paper shows through wax; the holes are no blocks between streets."""
    grain = cv2.GaussianBlur(np.random.default_rng(4).normal(0, 1, (360, 480)), (0, 0), 1.5)
    crayon = drawn(sheet(), wave(), pen=18)
    crayon[grain < -1.1 * grain.std()] = sheet()[0, 0]
    assert_one_road_along(photographed(cv2.GaussianBlur(crayon, (0, 0), 0.8)), wave())


def test_thick_strokes_are_ink_where_they_cross_too() -> None:
    """The crossing is broader than what the light is seen beside, and on a slant."""
    across = np.column_stack([np.full(200, 240.0), np.linspace(30, 330, 200)])
    image = drawn(drawn(sheet(), wave(), 30), across, 30)
    found = roads_on_paper(photographed(image))
    assert found is not None
    assert len(found.roads) == 4
    assert found.mask[150:210, 238:242].mean() > 0.9


def test_grain_that_cuts_a_stroke_is_closed() -> None:
    grain = cv2.GaussianBlur(np.random.default_rng(4).normal(0, 1, (360, 480)), (0, 0), 1.5)
    crayon = drawn(sheet(), wave(), pen=16)
    crayon[grain < -0.7 * grain.std()] = sheet()[0, 0]
    found = roads_on_paper(photographed(cv2.GaussianBlur(crayon, (0, 0), 0.8)))
    assert found is not None
    (road,) = found.roads
    assert road.confidence > 0.95
    assert np.quantile(distances(wave()[8:-8], road.points), 0.95) < 3


def test_words_are_not_closed_as_grain_is() -> None:
    words = sheet()
    for row in range(60, 340, 40):
        cv2.putText(words, "lanes and words", (20, row), 3, 1.2, (60, 40, 40), 4, cv2.LINE_AA)
    ink = np.asarray(words.min(axis=2) < 128)
    assert without_grain(ink) is ink


def test_the_outline_of_a_sheet_is_the_one_beside_which_the_desk_is_seen() -> None:
    """At darker levels the outline is a pixel aside, where the picture is too narrow for a desk."""
    desk = np.full((360, 480, 3), (90, 105, 125), np.uint8)
    cv2.rectangle(desk, (4, 4), (475, 355), (225, 230, 232), -1)
    outline = sheet_outline(cv2.GaussianBlur(desk, (0, 0), 0.8))
    assert outline is not None
    assert not outline[:4].any()
    assert outline[20:340, 20:460].all()
