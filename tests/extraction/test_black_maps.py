"""Maps of two colors: houses and water have the color of streets, which names interrupt."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roadlang.geometry import Booleans
from roadlang_standard.extraction.maps.map_contrast import without_strong_contrast
from roadlang_standard.extraction.maps.map_letters import LARGER, letters_of_map, without_letters
from roadlang_standard.extraction.maps.map_lines import without_outlines
from roadlang_standard.extraction.maps.map_or_drawing import _is_marked, are_named
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import (
    LOSSY,
    flat_colors,
    map_tone,
    without_jpeg_noise,
)
from roadlang_standard.extraction.maps.map_water import _constant, masks_without_water
from roadlang_standard.extraction.maps.map_water import without_water as without_water_of
from tests.extraction.drawn_maps import as_jpeg

_SIDE = 420
_WHITE, _BLACK = np.full(3, 255.0), np.zeros(3)


def streets(width: int = 6) -> np.ndarray:
    """Five streets (420, 420) of a town."""
    drawn = np.zeros((_SIDE, _SIDE), np.uint8)
    for ends in (((0, 60), (419, 90)), ((0, 210), (419, 230)), ((0, 350), (419, 340))):
        cv2.line(drawn, *ends, 1, width)
    for ends in (((80, 0), (100, 419)), ((300, 0), (320, 419))):
        cv2.line(drawn, *ends, 1, width)
    return drawn


def river() -> np.ndarray:
    """A river (420, 420) of 14 to 24 pixels."""
    drawn = np.zeros((_SIDE, _SIDE), np.uint8)
    for y in range(0, _SIDE, 2):
        middle, wide = 200 + round(30 * np.sin(y / 60)), round(19 + 5 * np.sin(y / 35))
        drawn[y : y + 2, middle - wide // 2 : middle + wide // 2] = 1
    return drawn


def without_water(black: np.ndarray) -> Booleans:
    mask = black > 0
    (_, dry) = masks_without_water([_WHITE, _BLACK], [~mask, mask])
    return dry


def test_a_river_and_houses_that_streets_lead_into_are_no_streets() -> None:
    black, houses = streets(), np.zeros((_SIDE, _SIDE), np.uint8)
    for x, y in ((110, 110), (130, 240), (330, 110), (250, 240), (20, 80)):
        houses[y : y + 30, x : x + 40] = 1
        houses[y - 30 : y, x + 20 : x + 24] = 1  # a drive
    others = (river() | houses) & ~cv2.dilate(black, np.ones((3, 3), np.uint8))
    dry = without_water(black | river() | houses)
    assert (dry & (others > 0)).sum() < 0.2 * others.sum()
    away = cv2.dilate(river() | houses, np.ones((15, 15), np.uint8)) == 0
    assert dry[(black > 0) & away].mean() > 0.99


def test_a_wide_road_that_streets_join_is_no_water() -> None:
    black = streets()
    cv2.line(black, (0, 150), (419, 165), 1, 20)
    assert without_water(black).sum() > 0.98 * black.sum()


def test_where_all_lines_meet_none_has_one_width() -> None:
    none = np.zeros((20, 20), bool)
    assert not _constant(none, np.ones((20, 20), np.float32)).any()


def town(second: int = 0, houses: bool = True) -> np.ndarray:
    """A map (420, 420, 3) in black on white with names; some of the streets are of a second gray
    level."""
    drawn = streets()
    near = cv2.dilate(drawn, np.ones((9, 9), np.uint8))
    for x, y in ((x, y) for x in range(6, 380, 44) for y in range(6, 390, 34)):
        if houses and not near[y : y + 20, x : x + 28].any():
            drawn[y : y + 20, x : x + 28] = 1
    image = np.dstack([np.where(drawn > 0, 0, 255).astype(np.uint8)] * 3)
    image[:, 280:][drawn[:, 280:] > 0] = second
    for text, place in (
        ("Mill Lane", (160, 223)),
        ("Oak Road", (170, 350)),
        ("High St", (170, 77)),
    ):
        for thick, color in ((6, (255, 255, 255)), (1, (0, 0, 0))):
            cv2.putText(
                image, text, place, cv2.FONT_HERSHEY_SIMPLEX, 0.45, color, thick, cv2.LINE_AA
            )
    return image


def assert_is_map(image: np.ndarray) -> None:
    found = roads_of_map(image, is_plan=lambda: True)
    assert found is not None
    lines = np.ones((_SIDE, _SIDE), np.uint8)
    for road in found.roads:
        cv2.polylines(lines, [np.round(road.points).astype(np.int32)], False, 0)
    middle = streets(1) > 0
    assert (cv2.distanceTransform(lines, cv2.DIST_L2, 5)[middle] <= 3).mean() > 0.95
    far = cv2.distanceTransform((~middle).astype(np.uint8), cv2.DIST_L2, 5)
    assert (far[lines == 0] <= 3).mean() > 0.95


def test_black_streets_are_found_among_black_houses_and_below_their_names() -> None:
    """Gaps beside houses are no markings, and names that interrupt streets make no drawing."""
    assert_is_map(town())


def test_names_interrupt_streets_of_two_colors() -> None:
    assert_is_map(town(second=40, houses=False))


def test_black_streets_of_a_jpeg_have_one_color_with_less_contrast() -> None:
    noisy = without_jpeg_noise(as_jpeg(town(second=15), 80))
    letters = letters_of_map(noisy, LARGER)
    even = without_strong_contrast(noisy, letters)
    number = [len(flat_colors(without_letters(one, letters), LOSSY)) for one in (noisy, even)]
    assert number == [3, 2]
    dark = np.clip(noisy.astype(int) + 30, 0, 255).astype(np.uint8)
    assert without_strong_contrast(dark, letters).min() > 100
    pale = np.clip(noisy.astype(int) + 100, 0, 255).astype(np.uint8)
    assert without_strong_contrast(pale, letters) is pale
    assert without_strong_contrast(np.zeros_like(noisy), letters).max() == 0
    assert_is_map(as_jpeg(town(second=15), 80))


def test_a_gap_between_a_house_and_a_river_is_no_paint_on_a_road() -> None:
    river = np.zeros((_SIDE, _SIDE), bool)
    river[100:126], river[111:115, 4:-4] = True, False
    river[126:, 200:206] = True
    paint = cv2.dilate(streets(), np.ones((19, 19), np.uint8)) > 0
    paint[75:79, 100:300] = paint[219:223, 110:310] = paint[343:347, 110:310] = False
    marked = [_is_marked(map_tone(_BLACK, mask)) for mask in (river, paint)]
    assert marked == [False, True]


def test_a_road_of_uneven_width_is_marked_by_what_is_painted_on_it() -> None:
    rows, columns = np.indices((_SIDE, _SIDE))
    road = np.abs(rows - 200) < np.where(columns // 60 % 2, 14, 30)
    middle = (np.abs(rows - 200) < 3) & (columns % 40 < 20)
    assert map_tone(_BLACK, road).even < 0.9
    assert _is_marked(map_tone(_BLACK, road & ~middle))
    assert not _is_marked(map_tone(_BLACK, road))


def test_streets_of_any_of_their_colors_are_interrupted_by_names() -> None:
    whole, interrupted, letters = (np.zeros((_SIDE, _SIDE), np.uint8) for _ in range(3))
    whole[100:110], interrupted[300:310] = 1, 1
    cv2.putText(letters, "Mill Lane", (160, 309), cv2.FONT_HERSHEY_SIMPLEX, 0.45, 1, 1)
    letters = cv2.dilate(letters, np.ones((3, 7), np.uint8))  # a word hangs together
    interrupted[:, 155:227] = 0
    streets = [map_tone(color, one > 0) for color, one in ((_WHITE, whole), (_BLACK, interrupted))]
    assert are_named(streets, letters > 0)
    assert not are_named(streets[:1], letters > 0)


def test_what_is_left_of_gray_land_is_a_rest() -> None:
    """Land that is wide in one place may be as narrow as a street elsewhere."""
    land = streets()
    land[100:400, 110:290] = 1
    mask = land > 0
    tones = without_water_of([map_tone(_WHITE, ~mask), map_tone(np.full(3, 180.0), mask)])
    assert [tone.rest for tone in tones] == [False, True]
    mask = streets() > 0
    mask[150:210, 110:190] = True
    tones = without_water_of([map_tone(_WHITE, ~mask), map_tone(_BLACK, mask)])
    assert not tones[1].rest
    line = np.zeros((_SIDE, _SIDE), bool)
    line[200:203, 20:400] = line[20:23, 20:30] = True
    left = replace(map_tone(_BLACK, line), rest=True)
    assert without_outlines([map_tone(_WHITE, ~line), left])[1].rest


@pytest.mark.parametrize(("course", "is_rest"), [(60.0, True), (230.0, False)])
def test_a_river_with_its_course_drawn_darker_is_a_rest(course: float, is_rest: bool) -> None:
    """Houses between two roads are not darker than these; casings are beside them."""
    side, middle = np.zeros((_SIDE, _SIDE), np.uint8), np.zeros((_SIDE, _SIDE), np.uint8)
    cv2.line(side, (30, 0), (200, 419), 1, 17)
    cv2.line(middle, (30, 0), (200, 419), 1, 3)
    casing = cv2.dilate(streets(), np.ones((3, 3), np.uint8)) & ~side & ~streets()
    masks = {
        245.0: (side | casing | streets()) == 0,
        105.0: (side > 0) & (middle == 0),
        course: (middle | casing) > 0,
        140.0: (streets() & ~side) > 0,
    }
    tones = without_water_of([map_tone(np.full(3, gray), masks[gray]) for gray in masks])
    assert [tone.rest for tone in tones] == [False, is_rest, False, False]
