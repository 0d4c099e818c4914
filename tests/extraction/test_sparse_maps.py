"""Maps with few roads, whose classes do not meet in the picture, and faint ones stored as JPEG."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps.map_contrast import with_contrast
from roadlang_standard.extraction.maps.map_halos import are_written_alike
from roadlang_standard.extraction.maps.map_tones import LOSSY, without_jpeg_noise
from roadlang_standard.extraction.maps.road_tones import road_tones
from tests.extraction.drawn_maps import LIGHT, as_jpeg, drawn_map, shaped
from tests.extraction.test_dark_maps import FAINT
from tests.extraction.test_map_casings import SIDE, STREETS, lines, tones
from tests.extraction.test_thin_streets import grid, scores


@pytest.mark.parametrize(("name", "is_road"), [("xc8bea0", True), ("x9ebdff", False)])
def test_two_classes_of_roads_may_meet_beyond_the_picture(name: str, is_road: bool) -> None:
    """A brook, as even as they are, is none."""
    street = lines(9, STREETS[0], ((-9, 40), (409, 30)))
    park = np.zeros((SIDE, SIDE), bool)
    park[150:250, 150:350] = True
    seen = tones(xaaaaaa=street, xc8facc=park, **{name: lines(9, STREETS[1])})
    assert (len(road_tones(seen, SIDE)) == 2) is is_road
    assert len(road_tones([seen[0], seen[1], seen[3]], SIDE)) == 1, "lettering"


@pytest.mark.parametrize(("steady", "is_road"), [(0.6, False), (0.9, True)])
def test_a_wide_blue_river_is_no_road_where_main_roads_are_yellow(
    steady: float, is_road: bool
) -> None:
    """A blue motorway keeps its width better."""
    street = lines(9, *STREETS)
    seen = tones(xffeeaa=street, x9ebdff=lines(21, ((250, -9), (260, 409))) & ~street)
    seen[2] = shaped(seen[2], steady=steady, even=0.9, ribbons=1.0)
    assert (len(road_tones(seen, SIDE)) == 2) is is_road


def test_specks_at_the_edge_of_a_main_road_make_no_casing_of_streets() -> None:
    main = lines(11, *STREETS[:2])
    street = lines(3, *STREETS[2:], ((200, -9), (240, 409)), ((300, -9), (310, 409))) & ~main
    specks = lines(13, *STREETS[:2]) & ~main
    specks[:, ::6] = specks[:, 1::6] = False
    seen = tones(xffffff=main, xc8c8d0=street | specks)
    assert len(road_tones(seen, SIDE)) == 2


def test_streets_whose_color_outlines_the_main_roads_are_streets() -> None:
    main = lines(9, *STREETS[:2])
    outline = lines(13, *STREETS[:2]) & ~main
    street = lines(3, *STREETS[2:], ((300, -9), (310, 409)))
    alone = road_tones(tones(x1e1e1e=main, x2d2d2d=outline), SIDE)
    park = lines(40, ((200, 350), (380, 350)))
    seen = tones(x1e1e1e=main, x2d2d2d=outline | (street & ~main), x142814=park & ~street)
    assert [len(alone), len(road_tones(seen, SIDE))] == [1, 2]


def test_ink_as_dark_as_the_roads_has_no_outlines_in_their_color() -> None:
    image = np.full((60, 200, 3), 235, np.uint8)
    cv2.putText(image, "Mill Lane", (10, 40), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (0, 0, 0), 1)
    letters = np.ones(image.shape[:2], bool)
    land = np.full(3, 235.0)
    assert are_written_alike(image, letters, land, np.zeros(3))
    assert not are_written_alike(image, letters, land, np.full(3, 255.0))


def test_contrast_of_a_jpeg_is_raised_where_all_of_the_map_is_faint() -> None:
    faint = without_jpeg_noise(as_jpeg(drawn_map(FAINT, names=False), 80))
    assert with_contrast(faint, LOSSY) is not faint
    park = cv2.add(faint, np.full_like(faint, (0, 20, 0)))
    assert with_contrast(park, LOSSY) is park
    light = without_jpeg_noise(as_jpeg(drawn_map(LIGHT, names=False), 80))
    assert with_contrast(light, LOSSY) is light


def test_a_jpeg_has_flat_areas_again_and_its_streets_keep_their_color() -> None:
    plain = drawn_map(FAINT, names=False)
    even = without_jpeg_noise(as_jpeg(plain, 80))
    for color in (FAINT.land, FAINT.street):
        seen = (plain == color).all(axis=2).astype(np.uint8)
        inside = cv2.erode(seen, np.ones((3, 3), np.uint8)) > 0
        assert np.abs(even[inside].astype(int) - color[0]).mean() < 1.0


@pytest.mark.parametrize("quality", [80, 95])
def test_thin_streets_of_a_map_stored_as_jpeg_are_found(quality: int) -> None:
    image, center = grid(3.5)
    assert min(scores(as_jpeg(image, quality), center)) > 0.9
