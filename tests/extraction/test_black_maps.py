"""Maps of two colors: houses and water have the color of streets, which names interrupt."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans
from roadlang_standard.extraction.map_tiles import roads_of_map
from roadlang_standard.extraction.map_water import _constant, masks_without_water

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


def test_black_streets_are_found_among_black_houses_and_below_their_names() -> None:
    """Gaps beside houses are no markings, and names that interrupt streets make no drawing."""
    drawn = streets()
    near = cv2.dilate(drawn, np.ones((9, 9), np.uint8))
    for x, y in ((x, y) for x in range(6, 380, 44) for y in range(6, 390, 34)):
        if not near[y : y + 20, x : x + 28].any():
            drawn[y : y + 20, x : x + 28] = 1
    image = np.dstack([np.where(drawn > 0, 0, 255).astype(np.uint8)] * 3)
    for text, place in (
        ("Mill Lane", (160, 223)),
        ("Oak Road", (170, 350)),
        ("High St", (170, 77)),
    ):
        for thick, color in ((6, (255, 255, 255)), (1, (0, 0, 0))):
            cv2.putText(
                image, text, place, cv2.FONT_HERSHEY_SIMPLEX, 0.45, color, thick, cv2.LINE_AA
            )
    found = roads_of_map(image, is_plan=lambda: True)
    assert found is not None
    lines = np.ones((_SIDE, _SIDE), np.uint8)
    for road in found.roads:
        cv2.polylines(lines, [np.round(road.points).astype(np.int32)], False, 0)
    middle = streets(1) > 0
    assert (cv2.distanceTransform(lines, cv2.DIST_L2, 5)[middle] <= 3).mean() > 0.95
    far = cv2.distanceTransform((~middle).astype(np.uint8), cv2.DIST_L2, 5)
    assert (far[lines == 0] <= 3).mean() > 0.95
