"""Streets of maps with the color of houses and water, told from these by their shape."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans
from roadlang_standard.extraction.maps.map_tones import map_tone
from roadlang_standard.extraction.maps.shared_colors import with_streets_alone


def town(river: int) -> tuple[Booleans, Booleans]:
    """What has the color of streets in a town (400, 400), rows of houses and a river among it, and
    its streets."""
    streets = np.zeros((400, 400), np.uint8)
    for place in (60, 160, 260, 340):
        cv2.line(streets, (place, 0), (place + 20, 399), 1, 6)
        cv2.line(streets, (0, place), (399, place + 15), 1, 6)
    black = streets.copy()
    for x, y in ((x, y) for x in range(4, 380, 27) for y in range(4, 380, 25)):
        if not streets[max(0, y - 4) : y + 18, max(0, x - 4) : x + 24].any():
            black[y : y + 14, x : x + 20] = 1
    if river:
        black[170 : 170 + river] = 1
    return black > 0, streets > 0


def test_houses_and_a_river_are_not_among_the_streets_of_their_color() -> None:
    black, streets = town(river=80)
    land, alone = with_streets_alone(
        [map_tone(np.full(3, 255.0), ~black), map_tone(np.zeros(3), black)]
    )
    assert not land.shared
    assert alone.shared
    assert (streets & alone.mask).sum() > 0.8 * streets.sum()
    assert (alone.mask & ~streets).sum() < 0.02 * streets.sum()


def test_a_color_that_streets_have_alone_is_left_as_it_is() -> None:
    _, streets = town(river=0)
    tones = [map_tone(np.full(3, 255.0), ~streets), map_tone(np.zeros(3), streets)]
    assert with_streets_alone(tones)[1] is tones[1]


def test_rows_of_houses_are_no_streets() -> None:
    black, streets = town(river=0)
    houses = black & ~cv2.dilate(streets.astype(np.uint8), np.ones((3, 3), np.uint8)).astype(bool)
    tones = [map_tone(np.full(3, 255.0), ~houses), map_tone(np.zeros(3), houses)]
    assert not with_streets_alone(tones)[1].shared


def test_land_in_color_is_no_street() -> None:
    black, _ = town(river=80)
    tones = [map_tone(np.full(3, 255.0), ~black), map_tone(np.array([209.0, 214.0, 255.0]), black)]
    assert with_streets_alone(tones)[1] is tones[1]


def test_gray_land_among_whose_thin_pieces_one_is_long_is_no_street() -> None:
    land = np.zeros((400, 400), np.uint8)
    land[190:196] = 1
    for y in range(4, 170, 16):
        for x in range(4, 380, 40):
            land[y : y + 6, x : x + 30] = 1
    land[230:390, 20:380] = 1
    gray = land > 0
    tones = [map_tone(np.full(3, 250.0), ~gray), map_tone(np.full(3, 224.0), gray)]
    assert not with_streets_alone(tones)[1].shared


def test_strips_of_a_second_land_between_two_roads_are_no_streets() -> None:
    """Roads of another color line both sides of a strip; streets have land beside them."""
    drawn, land = np.zeros((400, 400), np.uint8), np.zeros((400, 400), np.uint8)
    for ends in (((0, 190), (399, 210)), ((190, 0), (210, 399))):
        cv2.line(drawn, *ends, 1, 6)
    for x, y in ((100, 90), (300, 100), (90, 300), (310, 310)):
        cv2.ellipse(land, (x, y), (80, 50), 30, 0, 360, 1, -1)
    near = cv2.dilate(drawn, np.ones((13, 13), np.uint8)) > 0
    other = (drawn > 0) | ((land > 0) & ~near)
    for roads, is_shared in ((near & ~other, False), (np.zeros_like(near), True)):
        masks = {195.0: ~other & ~roads, 204.0: other, 150.0: roads}
        seen = with_streets_alone([map_tone(np.full(3, gray), masks[gray]) for gray in masks])
        assert seen[1].shared is is_shared


def woods() -> tuple[Booleans, Booleans]:
    """Black woods with tongues over most of a map (400, 400), and streets on its land."""
    streets, black = np.zeros((400, 400), np.uint8), np.zeros((400, 400), np.uint8)
    for place in (300, 360):
        cv2.line(streets, (0, place), (399, place + 15), 1, 6)
    for place in (60, 160, 260, 340):
        cv2.line(streets, (place, 275), (place + 20, 399), 1, 6)
    black[:200] = 1
    for x in (50, 220):
        black[200:265, x : x + 16] = 1
    return (black | streets) > 0, streets > 0


def test_streets_are_found_on_the_land_among_black_woods_that_cover_more() -> None:
    black, streets = woods()
    assert black.mean() > 0.5
    for value, is_shared in ((0.0, True), (60.0, True), (190.0, False)):
        tones = [map_tone(np.full(3, 255.0), ~black), map_tone(np.full(3, value), black)]
        alone = with_streets_alone(tones)[1]
        assert alone.shared is is_shared
        if is_shared:
            assert (streets & alone.mask).sum() > 0.5 * streets.sum()
            assert (alone.mask & ~streets).sum() < 0.05 * streets.sum()
