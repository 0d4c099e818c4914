"""Pictures without roads: nothing is found, or what is found is said to be doubtful."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.doubts.drawn_confidence import with_doubts
from roadlang_standard.extraction.drawings.drawing import has_edge_lines
from roadlang_standard.extraction.drawings.thresholding import ContourSteps, roads_by_contour
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad
from roadlang_standard.extraction.paper.paper import roads_on_paper, sheet_of
from roadlang_standard.extraction.photos.aerial import Request
from roadlang_standard.extraction.photos.classical import roads_by_ribbons
from roadlang_standard.extraction.photos.crosscheck import checked_roads
from roadlang_standard.extraction.photos.road_net import road_net
from roadlang_standard.extraction.picture_kinds.picture_kind import PHOTO, picture_kind

from .paper_drawings import drawn, photographed, sheet, wave


def _written() -> np.ndarray:
    """A page of joined letters: each word is one stroke, a tenth of the page or more long."""
    page = sheet()
    for row in range(30, 340, 30):
        for start in range(20, 420, 90):
            x = np.linspace(start, start + 70, 80)
            page = drawn(page, np.column_stack([x, row + 7 * np.sin(x / 3)]), 2)
    return photographed(page)


def test_words_on_paper_are_no_sure_roads() -> None:
    found = roads_on_paper(_written())
    assert found is not None
    assert all(road.confidence < 0.5 for road in found.roads)
    line = roads_on_paper(photographed(drawn(sheet(), wave())))
    assert line is not None
    assert line.confidence > 0.9


def test_a_sheet_has_one_color() -> None:
    beach = photographed(drawn(sheet(), wave()))
    assert sheet_of(beach) is not None
    beach[:, 300:] = (110, 80, 40)
    assert sheet_of(beach) is None


def test_the_sky_is_no_sheet_but_paper_in_its_light_is() -> None:
    white = drawn(sheet(), wave())
    for blueness, is_sheet in ((0.1, True), (0.2, True), (0.32, False)):
        tinted = photographed((white * (1.0, 1 - 0.5 * blueness, 1 - blueness)).astype(np.uint8))
        assert (sheet_of(tinted) is not None) is is_sheet


def test_shades_without_texture_are_a_photo() -> None:
    y, x = np.mgrid[:300, :400]
    sky = np.dstack([200 + y / 10, 120 + x / 8, 60 + y / 6]).astype(np.uint8)
    sky[220:, 100:180] = (40, 60, 70)
    assert picture_kind(sky).name == PHOTO
    banded = np.full_like(sky, (210, 150, 80))
    banded[140:160] = (40, 60, 70)
    assert picture_kind(banded).name != PHOTO


def test_sand_and_sea_are_a_photo_and_a_drawing_stored_as_jpeg_is_none() -> None:
    rng = np.random.default_rng(1)
    dunes = cv2.GaussianBlur(rng.normal(0, 1, (300, 400)), (0, 0), 25)
    shades = 6 * dunes / dunes.std() + rng.normal(0, 2.4, dunes.shape)
    beach = np.array([120, 160, 175]) + shades[..., None]
    beach[:, 250:] += np.array([-20, -80, -130])
    beach[:, 244:250] = 245
    assert picture_kind(np.clip(beach, 0, 255).astype(np.uint8)).name == PHOTO
    plan = np.full((300, 400, 3), (230, 240, 242), np.uint8)
    cv2.circle(plan, (200, 150), 90, (150, 170, 250), 14, cv2.LINE_AA)
    cv2.rectangle(plan, (20, 200), (110, 280), (160, 210, 180), -1)
    stored = cv2.imdecode(cv2.imencode(".jpg", plan, [cv2.IMWRITE_JPEG_QUALITY, 85])[1], 1)
    assert picture_kind(stored).name != PHOTO


def test_the_ribbons_of_a_busy_picture_are_not_traced() -> None:
    shades = 120 + 3 * (np.arange(200) % 7) // 2
    rows = np.repeat(shades[:, None], 200, axis=1).astype(np.uint8)
    for left in range(20, 200, 33):
        rows[:, left : left + 7] = 200
    field = cv2.merge([rows] * 3)
    assert len(roads_by_ribbons(field).roads) >= 5
    assert not roads_by_ribbons(field, longest=4).roads


def _network(*roads: FoundRoad) -> FoundNetwork:
    return FoundNetwork(np.zeros((9, 2)), roads, np.zeros((100, 200), bool))


def _road(
    start: int, end: int, x: tuple[float, float], y: float = 50, wide: float = 4
) -> FoundRoad:
    points = np.column_stack([np.linspace(*x, 50), np.full(50, y)])
    return FoundRoad(start, end, points, np.full(50, wide))


def _sure(*roads: FoundRoad) -> list[float]:
    return [road.confidence for road in with_doubts(_network(*roads)).roads]


def test_many_short_lines_are_words_also_where_they_leave_the_picture() -> None:
    words = [_road(2 * k, 2 * k + 1, (20, 45), 10.0 + 9 * k) for k in range(8)]
    at_rim = _road(20, 21, (0, 25), 95)
    assert max(_sure(*words, at_rim)) < 0.5
    assert _sure(words[0], at_rim) == [0.4167, 1.0]


def test_confidence_of_drawn_roads_by_length() -> None:
    assert _sure(_road(0, 1, (20, 80))) == [1.0]
    assert _sure(_road(0, 1, (20, 50))) == [0.5]
    # Two that meet are believed together, however they are numbered; a third one alone is not.
    joined = (_road(0, 1, (20, 50)), _road(5, 6, (120, 135)), _road(2, 1, (50, 80)))
    assert _sure(*joined) == [1.0, 0.25, 1.0]
    # How long a road is that leaves the picture, nobody knows.
    assert _sure(_road(0, 1, (0, 30)), _road(2, 3, (180, 199), 20)) == [1.0, 1.0]
    assert _sure(_road(0, 1, (170, 195), wide=6)) == [1.0]
    assert _sure(_road(0, 1, (170, 194), wide=3)) == [0.4]


def test_a_blot_is_no_sure_road() -> None:
    assert _sure(_road(0, 1, (20, 80), wide=40)) == [0.5]
    # The rule is for what hangs together: the blot beside a road does not make the road doubtful.
    assert _sure(_road(0, 1, (20, 80), wide=40), _road(2, 3, (20, 80), 10)) == [0.5, 1.0]


def _texture(sigma: float, seed: int) -> np.ndarray:
    """Smooth noise (300, 400) of standard deviation 1."""
    noise = np.random.default_rng(seed).normal(0, 1, (300, 400))
    smooth = cv2.GaussianBlur(noise, (0, 0), sigma)
    return np.asarray(smooth / smooth.std())


def test_roof_tiles_of_nearly_one_color_are_a_photo() -> None:
    """Their colors lie near a few, everywhere alike, but they are nowhere without texture."""
    y, x = np.mgrid[:300, :400]
    grain = np.random.default_rng(2).normal(0, 2, (300, 400, 1))
    rows = 30 * np.abs(np.sin(x / 9)) - 40 * (y % 16 < 3) + 6 * _texture(10, 4)
    tiles = np.array([60, 80, 160]) + rows[..., None] + grain
    assert picture_kind(np.clip(tiles, 0, 255).astype(np.uint8)).name == PHOTO


def test_lines_of_text_are_no_edges_of_roads() -> None:
    """Closed where they have gaps, they become blots with even spaces between them."""
    words = "road scenario vehicle extraction network curve the and of driver lane speed with"
    rng = np.random.default_rng(11)
    page = np.full((480, 480, 3), 255, np.uint8)
    for row in range(40, 460, 22):
        line = " ".join(rng.choice([*words.split(), "without", "testing"], 10))[:62]
        cv2.putText(page, line, (20, row), cv2.FONT_HERSHEY_SIMPLEX, 0.4, (20, 20, 20), 1, 16)
    assert not has_edge_lines(page[..., 0] < 128)


def _found(page: np.ndarray) -> FoundNetwork:
    return roads_by_contour(page, ContourSteps())


def _page(height: int = 480, width: int = 480) -> np.ndarray:
    return np.full((height, width, 3), 255, np.uint8)


def test_a_chessboard_is_no_sure_road() -> None:
    """Ways through its fields explain less of it than roads of an even width do."""
    page = _page()
    for row in range(8):
        for column in range(row % 2, 8, 2):
            page[60 * row : 60 * row + 60, 60 * column : 60 * column + 60] = 40
    assert all(road.confidence < 0.5 for road in _found(page).roads)


@pytest.mark.parametrize("thick", [2, 8])
def test_a_frame_with_a_wall_is_no_sure_road_but_a_round_ring_is(thick: int) -> None:
    page, ring = _page(), _page()
    cv2.rectangle(page, (70, 90), (400, 380), (0, 0, 0), thick)
    cv2.line(page, (240, 90), (240, 300), (0, 0, 0), thick)
    cv2.circle(ring, (240, 240), 140, (0, 0, 0), thick, cv2.LINE_AA)
    cv2.line(ring, (240, 100), (240, 300), (0, 0, 0), thick)
    assert all(road.confidence < 0.5 for road in _found(page).roads)
    assert all(road.confidence > 0.9 for road in _found(ring).roads)


def test_streets_of_straight_lines_are_sure_though_they_cross_at_right_angles() -> None:
    page = _page()
    for place in (120, 240, 360):
        cv2.line(page, (place, 0), (place, 480), (0, 0, 0), 4)
        cv2.line(page, (0, place), (480, place), (0, 0, 0), 4)
    assert all(road.confidence > 0.9 for road in _found(page).roads)


def test_the_bar_of_a_window_and_a_scribble_are_no_sure_roads() -> None:
    bar, scribble = _page(), _page()
    bar[:20] = 90
    x = np.linspace(200, 272, 400)
    wave = np.column_stack([x, 240 + 18 * np.sin(x / 2.4)]).astype(np.int32)
    cv2.polylines(scribble, [wave], False, (0, 0, 0), 2, cv2.LINE_AA)
    for page in (bar, scribble):
        assert all(road.confidence < 0.5 for road in _found(page).roads)
    below = np.roll(bar, 30, axis=0)
    assert [round(road.confidence, 2) for road in _found(below).roads] == [1.0]


def test_a_shore_beside_dark_water_is_a_photo() -> None:
    """Water is even and has one color on half of the picture, as the ground of a drawing has."""
    shore = np.full((300, 400, 3), (17, 28, 18), float)
    land = 80 + 26 * _texture(1.2, 5) + 12 * _texture(8, 6)
    shore[:, 220:] = land[:, 220:, None] * np.array([0.75, 1.0, 0.95])
    shore += np.random.default_rng(7).normal(0, 0.5, shore.shape)
    assert picture_kind(np.clip(shore, 0, 255).astype(np.uint8)).name == PHOTO
    filled = shore.copy()
    filled[:, 220:] = (60, 80, 76)
    assert picture_kind(np.clip(filled, 0, 255).astype(np.uint8)).name != PHOTO


def test_the_frame_of_a_screen_is_no_road() -> None:
    image = np.full((480, 640, 3), (190, 195, 200), np.uint8)
    image[330:] = (140, 110, 90)
    cv2.rectangle(image, (180, 120), (470, 340), (62, 60, 60), -1)
    cv2.rectangle(image, (195, 135), (455, 325), (100, 150, 190), -1)
    noise = np.random.default_rng(1).normal(0, 4, image.shape)
    photo = np.clip(cv2.GaussianBlur(image, (0, 0), 1) + noise, 0, 255).astype(np.uint8)
    found = checked_roads(photo, Request(), road_net())
    assert found.confidence < 0.5
