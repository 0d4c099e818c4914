"""Rendered maps: which colors are roads, and roads beneath names."""

from __future__ import annotations

from functools import cache

import cv2
import numpy as np
import pytest

from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.maps import tone_shape
from roadlang_standard.extraction.maps.map_letters import letters_of_map
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import (
    EXACT,
    LOSSY,
    MapTone,
    flat_colors,
    map_tone,
    map_tones,
    tolerance_of,
)
from roadlang_standard.extraction.maps.map_water import without_water
from roadlang_standard.extraction.maps.road_tones import road_tones
from roadlang_standard.extraction.maps.tone_shape import _shape
from roadlang_standard.extraction.networks.found_network import FoundNetwork
from roadlang_standard.extraction.picture_kinds.exact_colors import has_exact_colors
from tests.extraction.drawn_maps import (
    DARK,
    INK,
    LIGHT,
    PALE,
    STREETS,
    MapStyle,
    as_jpeg,
    crowded,
    drawn_map,
    found_streets,
    known_tone,
    on_streets,
)

STYLES = pytest.mark.parametrize("style", [LIGHT, PALE, DARK], ids=["light", "pale", "dark"])


def points(found: FoundNetwork) -> np.ndarray:
    return np.vstack([road.points for road in found.roads])


def roads_among(image: np.ndarray) -> list[MapTone]:
    """The tones of a map that are roads."""
    return road_tones(without_water(map_tones(image, flat_colors(image))), 360)


@cache
def roads_in(style: MapStyle) -> FoundNetwork:
    """What is found in a map, for several tests."""
    found = roads_of_map(drawn_map(style))
    assert found is not None
    return found


@STYLES
def test_the_streets_of_a_map_are_found_and_nothing_else(style: MapStyle) -> None:
    found = roads_in(style)
    assert on_streets(points(found)).mean() > 0.95
    assert found_streets(points(found)).mean() > 0.95


@pytest.mark.parametrize("style", [LIGHT, PALE], ids=["light", "pale"])
def test_the_streets_of_a_map_are_one_network(style: MapStyle) -> None:
    found = roads_in(style)
    meeting = [node for road in found.roads for node in (road.start, road.end)]
    assert sorted(meeting.count(node) for node in set(meeting)) == [1, 1, 1, 1, 1, 3, 3, 3, 4]


@STYLES
def test_roads_are_the_colors_of_streets_not_of_water_buildings_or_land(style: MapStyle) -> None:
    found = roads_among(drawn_map(style))
    colors = {tuple(int(x) for x in tone.color[::-1]) for tone in found}
    assert colors == {style.street, style.main}


@pytest.mark.parametrize("river", [30, 40, 60])
def test_a_river_in_the_color_of_the_roads_is_no_road(river: int) -> None:
    found = roads_of_map(drawn_map(INK, river=river))
    assert found is not None
    assert on_streets(points(found)).mean() > 0.95
    assert found_streets(points(found)).mean() > 0.95


def test_a_wide_road_that_casings_part_from_the_others_is_no_water() -> None:
    mask = np.zeros((200, 300), bool)
    mask[60:66] = mask[140:146] = mask[:, 80:86] = mask[:, 220:226] = True
    mask[98:108], mask[96:98], mask[108:110] = True, False, False
    (_, roads) = without_water([map_tone(np.full(3, 255.0), ~mask), map_tone(np.zeros(3), mask)])
    assert (roads.mask == mask).all()


def test_the_land_is_never_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    measured: list[float] = []

    def shape(mask: np.ndarray) -> object:
        measured.append(float(mask.mean()))
        return _shape(mask)

    monkeypatch.setattr(tone_shape, "_shape", shape)
    assert roads_of_map(drawn_map(LIGHT)) is not None
    assert max(measured) < 0.5


def test_buildings_are_no_roads_where_there_are_more_of_them_than_of_streets() -> None:
    mask = np.zeros((300, 300), bool)
    land, streets, buildings = ~mask, mask.copy(), mask.copy()
    streets[100:107] = True
    buildings[200:290:30, 20:280] = True

    def tone(gray: float, where: np.ndarray, length: float, ribbons: float, even: float) -> MapTone:
        shape = (length, ribbons, 7.0, 1.2, even, 12.0, even, even * length)
        return known_tone(np.full(3, gray), where, *shape)

    tones = [tone(14, land, 9000, 1.0, 0.4), tone(44, streets, 1500, 0.96, 0.9)]
    found = road_tones([*tones, tone(24, buildings, 3400, 0.74, 0.56)], 300)
    assert [one.color[0] for one in found] == [44]


def test_widths_are_those_of_each_class_of_road() -> None:
    found = roads_of_map(drawn_map(LIGHT, names=False))
    assert found is not None
    widths = sorted(float(np.median(road.widths)) for road in found.roads)
    assert widths[0] == pytest.approx(8, abs=1.2)
    assert widths[-1] == pytest.approx(14, abs=1.2)


def test_names_are_seen_and_edges_of_streets_are_no_names() -> None:
    named, plain = (letters_of_map(drawn_map(LIGHT, names), 8.0) for names in (True, False))
    assert named[265:276, 395:445].mean() > 0.8
    assert plain.mean() < 0.01


def test_a_road_that_is_nearly_filled_by_its_name_keeps_its_middle() -> None:
    """Letters leave of it strips thinner than a road, on one side more than on the other."""
    image = drawn_map(LIGHT, names=False)
    plain = roads_of_map(image)
    rows, columns = np.nonzero((image == LIGHT.main[::-1]).all(axis=2))
    at = int(np.median(rows[columns > 300]))
    cv2.putText(image, "NORTH ROAD", (310, at + 4), 0, 0.5, (30, 30, 30), 1, cv2.LINE_AA)
    named = roads_of_map(image)
    assert plain is not None
    assert named is not None
    off = np.linalg.norm(points(named)[:, None] - points(plain)[None], axis=2).min(axis=1)
    assert off.max() < 2.0


def test_a_map_twice_as_large_or_saved_as_jpeg_has_the_same_streets() -> None:
    image = drawn_map(LIGHT)
    large = roads_of_map(cv2.resize(image, None, fx=2, fy=2, interpolation=cv2.INTER_CUBIC))
    saved = roads_of_map(as_jpeg(image, 90))
    assert large is not None
    assert saved is not None
    assert found_streets((points(large) + 0.5) / 2 - 0.5).mean() > 0.95
    assert found_streets(points(saved)).mean() > 0.95


@pytest.mark.parametrize("quality", [70, 85])
@STYLES
def test_a_map_full_of_houses_that_was_saved_as_jpeg_is_read_as_a_map(
    style: MapStyle, quality: int
) -> None:
    """It has texture nearly everywhere, as a photo, and no color exactly, as paper."""
    image = as_jpeg(crowded(drawn_map(style), style), quality)
    assert Auto().extract(Picture(image, 0.5)).remarks[0] == "read as a rendered map"
    found = roads_of_map(image)
    assert found is not None
    assert on_streets(points(found)).mean() > 0.95
    assert found_streets(points(found)).mean() > 0.95


def test_noise_of_jpeg_is_no_tone_of_its_own() -> None:
    """A wide road of a strong color, whose blue JPEG leaves in two shades."""
    image = np.full((200, 300, 3), 245, np.uint8)
    image[::25, :, :] = 255
    image[80:94] = 109, 214, 253
    image[80:94:3, ::2, 0] += 10
    noisy = map_tones(
        image, [np.array(c, float) for c in ((245,) * 3, (109, 214, 253), (119, 214, 253))], LOSSY
    )
    assert [tone.color[0] for tone in noisy] == [245, 109]
    assert noisy[1].mask[80:94].all()
    alone = map_tones(image, [np.array([119.0, 214.0, 253.0])], LOSSY)
    assert len(alone) == 1


def test_lossless_pictures_are_told_from_jpeg() -> None:
    image = drawn_map(LIGHT)
    assert tolerance_of(image) is EXACT
    assert tolerance_of(as_jpeg(image, 50)) is LOSSY
    assert tolerance_of(as_jpeg(image, 95)) is LOSSY


def test_paper_in_even_light_has_no_exact_colors() -> None:
    """Three shades of a sheet are no three colors of a map: they are in other places."""
    sheet = np.full((300, 400, 3), 240, np.uint8)
    sheet[:, 130:260], sheet[:, 260:] = 232, 224
    assert not has_exact_colors(sheet)
    map_like = np.full((300, 400, 3), 240, np.uint8)
    map_like[::50] = map_like[1::50] = map_like[2::50] = map_like[3::50] = 232
    map_like[20::50, 10:380] = map_like[21::50, 10:380] = map_like[22::50, 10:380] = 224
    assert has_exact_colors(map_like)


def test_remnants_of_a_park_between_streets_are_no_roads() -> None:
    """A large park is no river among roads of its color, which its strips along a street are."""
    image = drawn_map(LIGHT)
    beside = np.zeros(image.shape[:2], np.uint8)
    street = np.array(STREETS[1]).round().astype(np.int32)
    cv2.polylines(beside, [street], False, 1, 34)
    land = (image == LIGHT.land[::-1]).all(axis=2)
    image[land & (beside > 0)] = LIGHT.park[::-1]
    image[300:350, 360:460] = LIGHT.park[::-1]
    assert LIGHT.park not in {
        tuple(int(x) for x in tone.color[::-1]) for tone in roads_among(image)
    }


def test_auto_says_that_a_picture_is_a_rendered_map() -> None:
    found = Auto().extract(Picture(drawn_map(PALE), 0.5))
    assert found.remarks[0] == "read as a rendered map"


def test_a_picture_of_few_colors_or_without_streets_is_no_map() -> None:
    plain = np.full((200, 200, 3), 240, np.uint8)
    assert roads_of_map(plain) is None
    for k in range(6):
        plain[20 + 25 * k : 40 + 25 * k, 30:60] = 40 * k
    assert roads_of_map(plain) is None


def test_what_keeps_its_width_is_a_ribbon_and_a_block_of_land_is_none() -> None:
    street, block = np.zeros((120, 300), bool), np.zeros((120, 300), bool)
    street[40:50], street[80:85] = True, True
    cv2.fillPoly(
        canvas := block.astype(np.uint8), [np.array([[10, 10], [280, 55], [200, 110], [30, 90]])], 1
    )
    streets, land = map_tone(np.zeros(3), street), map_tone(np.zeros(3), canvas > 0)
    assert streets.steady > 0.9
    assert land.steady < 0.2
