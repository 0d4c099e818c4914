"""Maps of little contrast: pale streets on light land, names that stand out, and what is no map."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps.map_contrast import with_contrast
from roadlang_standard.extraction.maps.map_letters import LARGER, letters_of_map
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import EXACT, LOSSY, Tolerance
from roadlang_standard.extraction.maps.road_tones import road_tones
from roadlang_standard.extraction.picture_kinds.exact_colors import has_exact_colors
from tests.extraction.drawn_maps import (
    LIGHT,
    MapStyle,
    as_jpeg,
    drawn_map,
    found_streets,
    on_streets,
    shaped,
)
from tests.extraction.test_map_casings import SIDE, STREETS, lines, tones

GRAY = MapStyle(
    (245, 245, 245), (254, 254, 254), (237, 237, 237), (227, 227, 227), (237, 237, 237),
    (239, 239, 239), (236, 236, 236), (60, 60, 60), (245, 245, 245),
)  # fmt: skip


def test_names_do_not_hide_that_a_map_is_faint() -> None:
    image = np.full((300, 400, 3), GRAY.land, np.uint8)
    cv2.line(image, (0, 150), (399, 170), GRAY.street, 2, cv2.LINE_AA)
    for x, y in ((20, 30), (200, 40), (30, 230), (160, 210), (250, 280)):
        cv2.putText(image, "Forest", (x, y), cv2.FONT_HERSHEY_SIMPLEX, 0.4, GRAY.letters, 1)
    assert with_contrast(image) is image
    assert with_contrast(image, letters=letters_of_map(image, LARGER)) is not image


def test_white_streets_get_more_contrast_on_light_land() -> None:
    plain = drawn_map(GRAY, names=False)
    raised = with_contrast(plain).astype(int)
    land = raised[(plain == GRAY.land).all(axis=2)]
    street = raised[(plain == GRAY.street).all(axis=2)]
    assert street.min() - land.max() > 20


def test_a_pale_park_does_not_make_streets_pale() -> None:
    red, green, blue = (value - 8 for value in LIGHT.land)
    style = replace(LIGHT, park=(red, green, blue))
    image = drawn_map(style, names=False)
    cv2.rectangle(image, (0, 120), (110, 235), style.park[::-1], -1)
    cv2.rectangle(image, (150, 110), (320, 235), style.park[::-1], -1)
    assert with_contrast(image) is image


def test_white_streets_on_light_land_are_found_in_a_jpeg() -> None:
    found = roads_of_map(as_jpeg(drawn_map(GRAY), 80))
    assert found is not None
    points = np.vstack([road.points for road in found.roads])
    assert found_streets(points).mean() > 0.9
    assert on_streets(points).mean() > 0.7


def test_land_of_one_color_is_exact_even_where_it_covers_less_than_half() -> None:
    image = np.full((300, 400, 3), 242, np.uint8)
    image[:90], image[230:] = 245, 236
    cv2.line(image, (0, 150), (399, 170), (251, 251, 251), 6, cv2.LINE_AA)
    noise = np.random.default_rng(1).normal(0, 1.5, image.shape[:2])[..., None]
    sheet = np.clip(image + noise, 0, 255).round().astype(np.uint8)
    assert has_exact_colors(image)
    assert not has_exact_colors(sheet)


@pytest.mark.parametrize(("steady", "is_road"), [(0.1, True), (0.05, False)])
def test_main_roads_whose_width_varies_are_yellow(steady: float, is_road: bool) -> None:
    """A strip of sand is as yellow, but hardly anywhere even."""
    seen = tones(xffffff=lines(9, *STREETS[:2]), xf6fabf=lines(13, *STREETS[2:]))
    seen[2] = shaped(seen[2], steady=steady, even=0.6, ribbons=1.0, spread=1.6)
    assert (len(road_tones(seen, SIDE)) == 2) is is_road


def test_a_few_faint_pixels_beside_a_broad_road_are_no_faint_map() -> None:
    image = np.full((300, 400, 3), 30, np.uint8)
    cv2.line(image, (0, 250), (400, 40), (90, 90, 90), 40)
    image[10:200:40, 20] = 40
    assert with_contrast(image) is image


@pytest.mark.parametrize("land", [(245, 245, 245), (225, 235, 245)])
@pytest.mark.parametrize("line", [(237, 237, 237), (160, 160, 160)])
def test_a_jpeg_gets_more_contrast_only_on_gray_land_and_if_all_of_it_is_faint(
    land: tuple[int, int, int], line: tuple[int, int, int]
) -> None:
    """Other maps do where most of what is thin is faint."""
    image = np.full((300, 400, 3), land, np.uint8)
    for row in range(20, 280, 40):
        cv2.line(image, (0, row), (399, row), tuple(value - 10 for value in land), 3)
    cv2.line(image, (20, 0), (20, 299), line, 3)
    cv2.line(image, (60, 0), (60, 299), line, 3)
    assert with_contrast(image, EXACT) is not image
    is_raised = with_contrast(image, LOSSY) is not image
    assert is_raised is (land == (245, 245, 245) and line == (237, 237, 237))


@pytest.mark.parametrize(
    ("land", "hue", "off", "is_raised"),
    [(245, 0, 22, True), (245, 0, 30, False), (245, 20, 22, False), (12, 0, 22, False)],
)
@pytest.mark.parametrize("tolerance", [EXACT, LOSSY])
def test_a_light_gray_map_is_faint_with_streets_that_others_show_clearly(
    tolerance: Tolerance, land: int, hue: int, off: int, is_raised: bool
) -> None:
    image = np.full((300, 400, 3), land, np.uint8)
    street = land - off if land > off else land + off
    for y in (60, 150, 240):
        cv2.line(image, (0, y), (399, y + 20), (street, street + hue, street), 5)
    cv2.line(image, (50, 0), (90, 250), (land - 40,) * 3 if land > 40 else (land + 40,) * 3, 5)
    assert (with_contrast(image, tolerance) is not image) is is_raised
