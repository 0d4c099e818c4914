"""Dark maps of little contrast are neither masks nor photos, and their streets are found."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps.map_contrast import with_contrast
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import map_tone
from roadlang_standard.extraction.maps.road_tones import road_tones
from roadlang_standard.extraction.picture_kinds.exact_colors import has_exact_colors
from roadlang_standard.extraction.picture_kinds.picture_kind import MASK, picture_kind
from tests.extraction.drawn_maps import (
    LIGHT,
    MapStyle,
    as_jpeg,
    drawn_map,
    found_streets,
    on_streets,
)
from tests.extraction.test_thin_streets import LAND, grid, scores

FAINT = MapStyle(
    (12, 12, 12), (23, 23, 23), (9, 9, 9), (27, 27, 27), (18, 18, 20),
    (14, 14, 14), (10, 10, 10), (140, 140, 140), (12, 12, 12),
)  # fmt: skip
"""Nearly black, with names alone in gray."""


def test_a_dark_map_is_no_mask_and_white_roads_on_black_are_one() -> None:
    image = drawn_map(FAINT)
    assert picture_kind(image).unless_edges != MASK
    white = np.where((image == FAINT.street).all(axis=2), 255, 0).astype(np.uint8)
    assert picture_kind(np.dstack([white] * 3)).unless_edges == MASK


def test_white_land_among_black_woods_has_names_and_is_no_mask() -> None:
    image = np.zeros((360, 480, 3), np.uint8)
    image[120:240] = 255
    assert picture_kind(image).unless_edges == MASK
    for x in range(20, 460, 12):
        image[180:190, x : x + 8] = 0
    assert picture_kind(image).unless_edges == MASK, "holes between roads"
    image[120:240] = 255
    cv2.putText(image, "Sandgasse", (180, 200), 0, 0.6, (0, 0, 0), 1, cv2.LINE_AA)
    assert picture_kind(image).unless_edges != MASK


def test_indices_of_a_mask_are_a_mask() -> None:
    image = drawn_map(FAINT)
    index = (image == FAINT.street).all(axis=2).astype(np.uint8)
    assert picture_kind(np.dstack([index] * 3)).unless_edges == MASK


@pytest.mark.parametrize(("land", "exact"), [(12, True), (0, False)])
def test_a_picture_is_exact_where_half_of_it_is_one_color_and_no_margin(
    land: int, exact: bool
) -> None:
    photo = np.random.default_rng(0).normal(60, 20, (300, 400, 3)).clip(0, 255).astype(np.uint8)
    photo[:180] = land
    assert has_exact_colors(photo) is exact


def test_thin_streets_of_a_faint_map_are_found() -> None:
    """Nowhere do they differ from the land by more than eleven gray levels; at the border some of
    them are cut as on a map of full contrast."""
    image, lines = grid(2.5)
    faint = 30 + (image.astype(float) - LAND) * 0.3
    assert min(scores(faint.round().astype(np.uint8), lines)) > 0.85


def test_a_river_of_full_contrast_leaves_the_streets_of_a_map_faint() -> None:
    """It is raised all the same: what is broad says nothing about lines."""
    plain = drawn_map(FAINT, names=False)
    river = drawn_map(replace(FAINT, water=(90, 90, 110)), names=False)
    land = (plain == FAINT.land).all(axis=2) & (river == FAINT.land).all(axis=2)
    street = (river == FAINT.street).all(axis=2)
    raised = with_contrast(river)
    assert (raised[land] == 12).all()
    assert raised[street].min() > 40


def test_a_wide_river_tinted_blue_is_no_road_where_streets_are_gray() -> None:
    land = np.zeros((400, 400), bool)
    masks = [land.copy() for _ in range(3)]
    masks[0][::40, :] = masks[0][1::40, :] = masks[0][2::40, :] = masks[0][:, 197:203] = True
    masks[1][101:113, :] = True
    masks[1] &= ~masks[0]
    masks[2] = ~masks[0] & ~masks[1]
    colors = ((45.0, 45.0, 45.0), (63.0, 57.0, 57.0), (12.0, 12.0, 12.0))
    street, river, ground = (
        map_tone(np.array(color), mask) for color, mask in zip(colors, masks, strict=True)
    )
    assert [tone.color[0] for tone in road_tones([street, river, ground], 400)] == [45.0]
    gray = map_tone(np.array((60.0, 60.0, 60.0)), masks[1])
    assert len(road_tones([street, gray, ground], 400)) == 2


def test_streets_of_a_faint_map_that_was_saved_as_jpeg_are_found() -> None:
    found = roads_of_map(as_jpeg(drawn_map(FAINT), 80))
    assert found is not None
    points = np.vstack([road.points for road in found.roads])
    assert found_streets(points).mean() > 0.9
    assert on_streets(points).mean() > 0.7


def test_contrast_is_raised_where_there_is_little_and_the_land_stays() -> None:
    faint, light = drawn_map(FAINT), drawn_map(LIGHT)
    assert with_contrast(light) is light
    raised = with_contrast(faint)
    land = (faint == FAINT.land).all(axis=2)
    assert (raised[land] == 12).all()
    assert raised[(faint == FAINT.street).all(axis=2)].min() > 40
