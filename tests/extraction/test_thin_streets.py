"""Streets of two or three pixels on rendered maps: all of them are smoothed edge."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang_standard.extraction.colors.mixed_pixels import slopes, with_thin_lines
from roadlang_standard.extraction.maps.map_lines import (
    short_parts,
    with_line_colors,
    without_outlines,
)
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import flat_colors, map_tone, map_tones
from roadlang_standard.extraction.maps.road_tones import road_tones
from roadlang_standard.extraction.masks.mask_parts import parts_touching

_FINER = 8
LAND, STREET, MAIN, HOUSE = (236, 240, 245), (200, 204, 210), (255, 255, 255), (222, 228, 232)


def grid(width: float, turn: float = 0.15, houses: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """A map (400, 400, 3) of thin streets and two main roads, and its center lines (400, 400).

    Streets and outlines of houses have one color, as in styles that show little else.
    """
    canvas = np.full((400 * _FINER, 400 * _FINER, 3), LAND, np.uint8)
    lines = np.zeros((400, 400), np.uint8)
    cos, sin = np.cos(turn), np.sin(turn)

    def at(x: float, y: float) -> tuple[float, float]:
        return 200 + cos * x - sin * y, 200 + sin * x + cos * y

    def stroke(
        a: tuple[float, float], b: tuple[float, float], color: tuple[int, ...], wide: float
    ) -> None:
        ends = [tuple(round((v + 0.5) * _FINER) for v in at(*end)) for end in (a, b)]
        cv2.line(canvas, ends[0], ends[1], color, round(wide * _FINER), cv2.LINE_AA)
        cv2.line(lines, *[tuple(round(v) for v in at(*end)) for end in (a, b)], 1)

    for place in range(-280, 281, 56):
        stroke((place, -300), (place, 300), STREET, width)
        stroke((-300, place), (300, place), STREET, width)
    if houses:
        for x, y in ((x, y) for x in range(-252, 253, 28) for y in range(-252, 253, 56)):
            corners = [at(x + dx, y + dy) for dx, dy in ((-6, -5), (6, -5), (6, 5), (-6, 5))]
            shape = [np.round((np.array(corners) + 0.5) * _FINER).astype(np.int32)]
            if x % 56:
                cv2.fillPoly(canvas, shape, HOUSE, cv2.LINE_AA)
                cv2.polylines(canvas, shape, True, STREET, _FINER, cv2.LINE_AA)
    for place in (-56, 112):
        stroke((place, -300), (place, 300), MAIN, 7)
    image = cv2.resize(canvas, (400, 400), interpolation=cv2.INTER_AREA)
    return image, lines > 0


def scores(image: np.ndarray, lines: np.ndarray) -> tuple[float, float]:
    """Shares of what is found that is street, and of the streets that is found, within 3 pixels."""
    found = roads_of_map(image)
    assert found is not None
    seen = np.zeros(lines.shape, np.uint8)
    for road in found.roads:
        cv2.polylines(seen, [np.round(road.points).astype(np.int32)], False, 1)
    away = [
        cv2.distanceTransform(1 - mask.astype(np.uint8), cv2.DIST_L2, 5) for mask in (lines, seen)
    ]
    return float((away[0][seen > 0] <= 3).mean()), float((away[1][lines] <= 3).mean())


def test_streets_of_two_and_a_half_pixels_are_found_among_outlines_of_their_color() -> None:
    right, found = scores(*grid(2.5))
    assert right > 0.95
    assert found > 0.95


def test_a_color_that_is_nowhere_even_is_found_along_lines() -> None:
    image, _ = grid(2.5, houses=False)
    known = flat_colors(image)
    colors = with_line_colors(image, known)
    assert not any(np.abs(color - STREET).max() <= 3 for color in known)
    assert any(np.abs(color - STREET).max() <= 3 for color in colors[len(known) :])


def smoothed(wide: int) -> tuple[np.ndarray, np.ndarray, list[np.ndarray]]:
    """A dark band with smoothed edges; labels of what has its color or that of the land exactly."""
    image = np.full((40, 60, 3), 240, np.uint8)
    image[10 : 10 + wide] = 40
    image[9] = image[10 + wide] = 120
    colors = [np.full(3, 240.0), np.full(3, 40.0)]
    labels = np.where(image[..., 0] == 240, 0, np.where(image[..., 0] == 40, 1, -1))
    return image, labels.astype(np.int16), colors


def test_a_mixed_pixel_belongs_to_the_thin_line_that_it_is_most_like() -> None:
    image, labels, colors = smoothed(2)
    assert (with_thin_lines(image, labels, colors)[8:13, 30] == [0, 1, 1, 1, 1]).all()


def test_what_is_wide_keeps_to_its_own_color() -> None:
    """A casing of one pixel still parts a river from a road of the same color."""
    image, labels, colors = smoothed(20)
    assert (with_thin_lines(image, labels, colors)[9] == -1).all()


def test_a_mixed_pixel_is_of_no_third_color_that_it_has_by_chance() -> None:
    image, labels, colors = smoothed(2)
    labels[9] = 2
    assert slopes(image)[9].all()
    assert (with_thin_lines(image, labels, [*colors, np.full(3, 120.0)])[9] == 1).all()


def test_outlines_between_two_colors_are_no_streets_but_lines_on_land_are() -> None:
    land, inside, outline, street = (np.zeros((200, 200), bool) for _ in range(4))
    inside[60:140, 20:90] = True
    cv2.rectangle(drawn := np.zeros((200, 200), np.uint8), (19, 59), (90, 140), 1)
    outline |= drawn > 0
    street[:, 150:152] = True
    land |= ~(inside | outline | street)
    for lines, kept in ((outline, 0), (street, 400)):
        (_, _, tone) = without_outlines(
            [
                map_tone(np.full(3, 240.0), land),
                map_tone(np.full(3, 220.0), inside),
                map_tone(np.full(3, 100.0), lines),
            ]
        )
        assert tone.mask.sum() == kept


def test_a_thin_line_across_the_map_is_no_road_where_roads_are_wider() -> None:
    """A railway is one line; thin streets are many."""
    image = np.full((300, 300, 3), 240, np.uint8)
    image[::60] = image[1::60] = image[2::60] = image[3::60] = 120
    image[:, 100:108] = image[:, 200:208] = 120
    image[:, 150:152] = 200
    found = road_tones(map_tones(image, [np.full(3, gray) for gray in (240.0, 120.0, 200.0)]), 300)
    assert [tone.color[0] for tone in found] == [120]


def test_casings_are_no_roads() -> None:
    masks = {gray: np.zeros((300, 300), bool) for gray in (240, 255, 180)}
    for row in (80, 200):
        masks[180][row - 1 : row + 9] = True
        masks[180][row : row + 8] = False
        masks[255][row : row + 8] = True
    masks[240] = ~(masks[255] | masks[180])
    tones = [map_tone(np.full(3, float(gray)), mask) for gray, mask in masks.items()]
    assert [tone.color[0] for tone in road_tones(tones, 300)] == [255]


def test_a_short_street_near_others_belongs_to_them_and_a_house_does_not() -> None:
    mask = np.zeros((100, 100), np.uint8)
    cv2.line(mask, (10, 10), (10, 30), 1, 2)
    cv2.rectangle(mask, (40, 10), (52, 22), 1, 2)
    cv2.line(mask, (80, 80), (80, 98), 1, 2)
    tone = map_tone(np.zeros(3), mask > 0)
    near = np.zeros((100, 100), bool)
    near[:40] = True
    found = short_parts([tone], [tone], near)
    assert found[20, 10]
    assert found.sum() == parts_touching(mask > 0, near)[:, :30].sum()
