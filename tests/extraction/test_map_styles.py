"""Maps of styles whose colors are known: roads are told by color where few are long enough."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps.map_contrast import Stretch
from roadlang_standard.extraction.maps.map_lines import without_barbs
from roadlang_standard.extraction.maps.map_styles import STYLES, gray_style_of, style_of
from roadlang_standard.extraction.maps.map_styles import MapStyle as KnownStyle
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import EXACT, LOSSY, flat_colors, map_tone
from roadlang_standard.extraction.picture_kinds.exact_colors import has_exact_colors
from tests.extraction.drawn_maps import CARTO, LIGHT, MapStyle, as_jpeg, crowded, drawn_map

SIDE, FINER = 256, 4


def crop(style: MapStyle) -> np.ndarray:
    """A corner of a map (256, 256, 3): the end of a street, a piece of a main road, and houses."""
    canvas = np.full((SIDE * FINER, SIDE * FINER, 3), style.land, np.uint8)
    for x, y in ((x, y) for x in range(20, 230, 44) for y in (90, 130)):
        at, to = ((value * FINER, other * FINER) for value, other in ((x, y), (x + 24, y + 18)))
        cv2.rectangle(canvas, at, to, style.building, -1)
    for line, color in (
        (((180, 260), (150, 180)), style.street),
        (((-9, 60), (60, -9)), style.main),
    ):
        ends = [(x * FINER, y * FINER) for x, y in line]
        for wide, ink in ((13, style.casing), (11, color)):
            cv2.line(canvas, *ends, ink, wide * FINER)
    image = cv2.resize(canvas, (SIDE, SIDE), interpolation=cv2.INTER_AREA)
    return np.ascontiguousarray(image[..., ::-1])


@pytest.mark.parametrize(("style", "roads"), [(CARTO, 2), (LIGHT, 0)])
def test_a_small_crop_of_a_known_style_has_its_roads(style: MapStyle, roads: int) -> None:
    """None is half as long as the picture is wide, which roads of unknown colors must be."""
    found = roads_of_map(crop(style))
    assert (0 if found is None else len(found.roads)) == roads


@pytest.mark.parametrize(("style", "is_known"), [(CARTO, True), (LIGHT, False)])
@pytest.mark.parametrize("quality", [None, 80])
def test_a_style_is_known_by_its_colors(
    style: MapStyle, is_known: bool, quality: int | None
) -> None:
    image = drawn_map(style, names=False)
    image = image if quality is None else as_jpeg(image, quality)
    tolerance = EXACT if quality is None else LOSSY
    assert (style_of(image, flat_colors(image, tolerance), tolerance) is not None) is is_known


def test_a_drawing_on_ground_of_a_color_of_a_style_is_none_of_it() -> None:
    """Most of the picture has the style's colors, not one of many."""
    image = drawn_map(CARTO, names=False)
    image[:, 150:] = np.where(image[:, 150:] == CARTO.land[::-1], (90, 140, 180), image[:, 150:])
    assert style_of(image, flat_colors(image), EXACT) is None


def test_a_jpeg_full_of_small_houses_in_known_colors_is_a_map() -> None:
    small = cv2.resize(crowded(drawn_map(CARTO), CARTO), None, fx=0.4, fy=0.4)
    assert has_exact_colors(as_jpeg(small, 80))


def test_dashes_in_the_color_of_roads_are_none() -> None:
    mask = np.zeros((100, 100), bool)
    mask[20:26] = True
    mask[60:63, ::8] = mask[60:63, 1::8] = mask[60:63, 2::8] = mask[60:63, 3::8] = True
    (road,) = STYLES[0].roads_among([map_tone(np.full(3, 255.0), mask)], EXACT)
    assert road.mask[22].all()
    assert not road.mask[61].any()


def test_a_style_gets_the_contrast_that_its_map_gets() -> None:
    style = KnownStyle.of("#f2f3f0 #eaeae5", "#ffffff #e2e2e2")
    land = style.ground[0]
    stretched = style.stretched(Stretch(land, land - 48, 3.0))
    assert stretched.is_road(np.array([150.0, 144.0, 147.0]), EXACT)
    assert not style.is_road(np.array([150.0, 144.0, 147.0]), EXACT)


def test_a_jpeg_of_a_known_style_has_all_of_its_colors() -> None:
    """JPEG takes two similar ones for one."""
    style = KnownStyle.of("#f2f3f0 #eaeae5", "#ffffff #e2e2e2")
    seen = [style.ground[0], np.array([60.0, 60.0, 60.0])]
    assert len(style.with_its_own(seen, LOSSY)) == 5
    assert len(style.with_its_own(seen, EXACT)) == 4


def test_in_a_jpeg_colors_between_a_road_and_land_are_noise() -> None:
    """So is what is darker than both, as outlines are."""
    land, road = np.full(3, 195.0), np.full(3, 141.0)
    style = KnownStyle(np.array([land]), np.array([road]), contrast=3.0)
    for level, is_road in ((141, True), (147, True), (165, False), (168, False), (132, False)):
        assert style.is_road(np.full(3, float(level)), LOSSY) is is_road, level
    assert style.is_road(np.full(3, 143.0), EXACT)


@pytest.mark.parametrize(
    ("grays", "is_known"),
    [((245, 250, 227), True), ((245, 60, 10), False), ((230, 250, 227), False)],
)
def test_a_gray_style_is_known_by_its_land_and_one_more_gray(
    grays: tuple[int, int, int], is_known: bool
) -> None:
    land, street, main = grays
    image = np.full((200, 200, 3), land, np.uint8)
    image[90:98], image[:, 40:48] = street, main
    assert (gray_style_of(image, flat_colors(image)) is not None) is is_known


@pytest.mark.parametrize(("land", "street", "outline"), [(12, 23, 27), (245, 250, 238)])
def test_the_streets_of_a_gray_map_stored_as_jpeg_are_found(
    land: int, street: int, outline: int
) -> None:
    """They differ from the land by a few gray levels, and the noise of JPEG by nearly as many."""
    image = np.full((480, 480, 3), land, np.uint8)
    for at in range(60, 480, 120):
        for line in (((at, 0), (at + 40, 479)), ((0, at + 40), (479, at))):
            cv2.line(image, *line, (outline,) * 3, 6, cv2.LINE_AA)
            cv2.line(image, *line, (street,) * 3, 4, cv2.LINE_AA)
    for x, y in ((x, y) for x in range(84, 440, 40) for y in range(20, 460, 40)):
        if (image[y : y + 12, x : x + 16] == land).all():
            cv2.rectangle(image, (x, y), (x + 15, y + 11), (outline,) * 3, 1)
    found = roads_of_map(as_jpeg(image, 80))
    assert found is not None
    length = sum(road.length for road in found.roads)
    assert length == pytest.approx(8 * 481, rel=0.06)
    assert len(found.roads) < 60


def test_a_narrow_street_of_a_jpeg_has_no_barbs() -> None:
    street = np.zeros((40, 60), bool)
    street[18:21] = True
    frayed = street.copy()
    frayed[10:18, 30] = frayed[21:30, 40] = True
    clean = without_barbs(frayed)
    assert clean[street].all()
    assert not clean[:17].any()
    assert not clean[22:].any()
