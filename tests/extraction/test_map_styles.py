"""Maps of styles whose colors are known: roads are told by color where few are long enough."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.exact_colors import has_exact_colors
from roadlang_standard.extraction.map_contrast import Stretch
from roadlang_standard.extraction.map_styles import STYLES, style_of
from roadlang_standard.extraction.map_styles import MapStyle as KnownStyle
from roadlang_standard.extraction.map_tiles import roads_of_map
from roadlang_standard.extraction.map_tones import EXACT, LOSSY, flat_colors, map_tone
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
