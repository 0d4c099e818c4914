"""Colors of a map that are no streets, however even: casings, tracks in a yard, rivers, plants; and
the outlines of names."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps import map_roads
from roadlang_standard.extraction.maps.map_halos import without_halos
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import MapTone, map_tone
from roadlang_standard.extraction.maps.road_tones import road_tones
from roadlang_standard.extraction.picture_kinds.exact_colors import has_exact_colors
from tests.extraction.drawn_maps import shaped

SIDE = 400
STREETS = (((-9, 100), (409, 120)), ((-9, 300), (409, 280)), ((120, -9), (150, 409)))


def lines(width: int, *ends: tuple[tuple[int, int], tuple[int, int]]) -> np.ndarray:
    """(h, w) where straight lines of a width are."""
    canvas = np.zeros((SIDE, SIDE), np.uint8)
    for start, end in ends:
        cv2.line(canvas, start, end, 1, width)
    return canvas > 0


def houses(count: int) -> np.ndarray:
    """(h, w) the outlines of rows of houses."""
    canvas = np.zeros((SIDE, SIDE), np.uint8)
    for x in range(180, 180 + 36 * count, 36):
        for y in (20, 150, 200, 330):
            cv2.rectangle(canvas, (x, y), (x + 26, y + 36), 1, 3)
    return canvas > 0


def tones(**masks: np.ndarray) -> list[MapTone]:
    """Tones of land and what lies on it, by the hex digits of their red, green and blue."""
    land = ~np.logical_or.reduce([*masks.values()])
    found = [map_tone(np.full(3, 240.0), land)]
    for name, mask in masks.items():
        red, green, blue = bytes.fromhex(name[1:])
        found.append(map_tone(np.array([blue, green, red], float), mask))
    return found


def test_casings_are_no_streets_where_houses_have_their_color_too() -> None:
    street = lines(11, *STREETS)
    casing = (lines(15, *STREETS) & ~street) | houses(2)
    (found,) = road_tones(tones(xffffff=street, xdbdbdb=casing), SIDE)
    assert found.color[0] == 255


def test_two_thin_streets_close_together_are_streets() -> None:
    """What is between them is smoothed to a color between theirs and the land's."""
    between = lines(11, *STREETS[:2])
    streets = lines(23, *STREETS[:2]) & ~between
    found = road_tones(tones(x969696=streets, xc3c3c3=between), SIDE)
    assert 150 in [tone.color[0] for tone in found]


def test_tracks_in_a_yard_are_no_streets() -> None:
    """They are one pixel wide and more even than the streets."""
    street = lines(11, *STREETS)
    yard = lines(1, *(((20 * i, 130), (20 * i + 60, 270)) for i in range(1, 8))) & ~street
    (found,) = road_tones(tones(xffffff=street, xbbbbbb=yard), SIDE)
    assert found.color[0] == 255


def test_a_river_is_no_street_even_where_it_is_longer_than_those() -> None:
    streets = lines(6, *STREETS[:2]) | lines(16, ((250, -9), (260, 409)))
    water = lines(6, *(((20 + 40 * i, 130), (10 + 40 * i, 270)) for i in range(10))) & ~streets
    water |= lines(6, ((-9, 190), (409, 200))) & ~streets
    found = road_tones(tones(xfefefe=streets, xaad3df=water), SIDE)
    assert [tone.color[0] for tone in found] == [254]


def test_strips_of_plants_are_no_streets_even_where_they_keep_their_width_better() -> None:
    streets = lines(11, *STREETS) | lines(20, ((20, 110), (110, 115)), ((200, 290), (330, 285)))
    hedge = lines(5, ((-9, 180), (409, 190)), ((-9, 220), (409, 230))) & ~lines(31, *STREETS)
    found = road_tones(tones(xfefefe=streets, xaedb96=hedge), SIDE)
    assert [tone.color[0] for tone in found] == [254]


def test_of_plants_an_even_width_is_not_enough() -> None:
    """The edges of roads in JPEG files are so uneven that their width alone must do; so are those
    of woods, where trees are drawn on them."""
    street = lines(11, *STREETS)
    wide = lines(15, ((250, -9), (260, 409))) & ~street
    for name, is_road in (("xadd19e", False), ("xffffff", True)):
        found = tones(xfefefe=street, **{name: wide})
        found[2] = shaped(found[2], steady=0.02, even=0.7, spread=1.4, ribbons=1.0)
        assert (len(road_tones(found, SIDE)) == 2) is is_road


def test_main_roads_may_be_pale_yellow_and_uneven() -> None:
    street = lines(11, *STREETS)
    main = lines(15, ((250, -9), (260, 409))) & ~street
    found = tones(xffffff=street, xf7fabf=main)
    found[2] = shaped(found[2], steady=0.13, even=0.6, spread=1.6, ribbons=1.0)
    assert len(road_tones(found, SIDE)) == 2


def test_thin_streets_that_jpeg_broke_keep_their_width_well() -> None:
    street = lines(3, *STREETS)
    for steady, is_road in ((0.95, True), (0.8, False)):
        found = tones(xfffffd=street)
        found[1] = shaped(found[1], steady=steady, ribbons=0.65)
        assert bool(road_tones(found, SIDE)) is is_road


def test_what_names_hide_of_the_width_of_streets_is_known_with_their_smoothed_edges(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Streets that are found so are kept where they are not found without these edges."""
    image = np.full((SIDE, SIDE, 3), (226, 234, 242), np.uint8)
    image[:, 200:] = (200, 230, 214)
    for x in range(5, SIDE, 40):
        for y, color in ((20, (198, 208, 217)), (140, (206, 214, 255)), (340, (220, 221, 224))):
            image[y : y + 40, x : x + 30] = color
    for start, end in STREETS:
        cv2.line(image, start, end, (255, 255, 255), 14, cv2.LINE_AA)
    calls: list[list[MapTone]] = []
    monkeypatch.setattr(map_roads, "road_tones", _first_only(calls))
    found = roads_of_map(image)
    assert len(calls) == 2
    assert found is not None
    assert len(found.roads) >= 7


def _first_only(calls: list[list[MapTone]]) -> Callable[[list[MapTone], int], list[MapTone]]:
    def found(tones: list[MapTone], side: int) -> list[MapTone]:
        calls.append(tones)
        return road_tones(tones, side) if len(calls) == 1 else []

    return found


def test_outlines_of_a_name_on_land_are_no_street_but_what_is_within_one_on_a_street() -> None:
    mask = lines(21, ((-9, 100), (409, 100)))
    mask |= lines(3, ((60, 300), (75, 300)), ((85, 300), (100, 300)))
    letters = lines(11, ((200, 100), (260, 100))) | lines(15, ((55, 300), (105, 300)))
    mask[96:105, 200:260] = False
    mask[98:103, 220:226] = True
    kept = without_halos(mask, letters)
    assert not kept[280:].any()
    assert np.array_equal(kept[:200], mask[:200])


def test_a_map_with_the_sea_stored_as_jpeg_has_exact_colors() -> None:
    """The sea is most of it, but not in all of its parts; houses are."""
    rng = np.random.default_rng(3)
    image = np.repeat(rng.integers(120, 250, (640, 640, 1)).astype(np.uint8), 3, axis=2)
    image[:, :60] = (248, 244, 240)
    image[330:] = (200, 232, 216)
    for x in range(0, 640, 80):
        image[:330, x : x + 30] = image[330:, x : x + 20] = (226, 234, 242)
    stored = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, 80])[1]
    assert has_exact_colors(np.asarray(cv2.imdecode(stored, cv2.IMREAD_COLOR)))


def test_a_map_of_two_kinds_of_land_that_look_alike_stored_as_jpeg_has_exact_colors() -> None:
    rng = np.random.default_rng(4)
    image = np.repeat(rng.integers(120, 250, (640, 640, 1)).astype(np.uint8), 3, axis=2)
    image[:, :200] = (236, 242, 245)
    image[:300, 200:500] = (232, 238, 241)
    image[400:600, 300:500] = (200, 232, 216)
    stored = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, 80])[1]
    assert has_exact_colors(np.asarray(cv2.imdecode(stored, cv2.IMREAD_COLOR)))
