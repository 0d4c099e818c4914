"""Colors of roads on maps: seen without names, lossless or frayed by JPEG."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps.map_letters import letters_of_map, without_letters
from roadlang_standard.extraction.maps.map_tones import MapTone
from roadlang_standard.extraction.maps.road_tones import road_tones
from roadlang_standard.extraction.picture_kinds.exact_colors import has_exact_colors
from tests.extraction.drawn_maps import LIGHT, drawn_map, known_tone


def named_road() -> tuple[np.ndarray, np.ndarray]:
    """A road of 26 pixels with its name on it, and where the road is."""
    image = np.full((120, 400, 3), (233, 239, 242), np.uint8)
    image[50:76] = (255, 255, 255)
    cv2.putText(image, "Harbor Street", (90, 69), 0, 0.6, (40, 40, 40), 1, cv2.LINE_AA)
    road = np.zeros(image.shape[:2], bool)
    road[50:76] = True
    return image, road


def test_a_name_on_a_wide_road_takes_the_color_of_the_road() -> None:
    image, road = named_road()
    dark = (image < 200).all(axis=2)
    assert (dark & road).sum() > 200
    plain = without_letters(image, letters_of_map(image, 6.0))
    assert (plain[road] == 255).all(axis=1).mean() > 0.99
    assert (plain[~road] == image[~road]).all()


def test_a_picture_without_names_stays_as_it_is() -> None:
    image, _ = named_road()
    image[50:76] = 255
    assert without_letters(image, letters_of_map(image, 6.0)) is image


def patchwork() -> np.ndarray:
    """A map without a color that is everywhere: its land is of six uses, side by side."""
    image = drawn_map(LIGHT)
    land = (image == LIGHT.land[::-1]).all(axis=2)
    uses = np.array(
        [(200, 230, 210), (190, 220, 235), (225, 215, 205),
         (210, 240, 240), (235, 225, 215), (215, 235, 200)], np.uint8,
    )  # fmt: skip
    rows, columns = np.indices(land.shape)
    use = (rows // 60 * 3 + columns // 80) % len(uses)
    image[land] = uses[use[land]]
    return image


def test_a_lossless_map_is_told_by_colors_that_are_exactly_the_same() -> None:
    """A light that falls off to the side takes that away, and so does a camera's noise."""
    image = patchwork()
    assert has_exact_colors(image)
    fall = np.linspace(1.0, 0.7, image.shape[1])[None, :, None]
    noise = np.random.default_rng(0).normal(0, 4, image.shape)
    assert not has_exact_colors(np.clip(image * fall + noise, 0, 255).astype(np.uint8))


def test_a_map_of_several_lands_saved_as_jpeg_is_told_by_what_is_still() -> None:
    """Far from edges JPEG leaves the few colors; paper, lit unevenly, has the shades between."""
    image = drawn_map(LIGHT)
    land = (image == LIGHT.land[::-1]).all(axis=2)
    image[land & (np.arange(480) > 230)] = (238, 238, 221)
    coded = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, 80])[1]
    saved = cv2.imdecode(coded, cv2.IMREAD_COLOR)
    assert has_exact_colors(saved)
    fall = np.linspace(1.0, 0.7, saved.shape[1])[None, :, None]
    assert not has_exact_colors(np.clip(saved * fall, 0, 255).astype(np.uint8))


@pytest.mark.parametrize(("even", "found"), [(0.7, [250, 120]), (0.4, [120])])
def test_minor_roads_frayed_by_jpeg_are_roads_by_their_usual_width(
    even: float, found: list[int]
) -> None:
    """Their width changes from pixel to pixel, but is nearly the same in all."""
    land, minor, main = (np.zeros((300, 300), bool) for _ in range(3))
    minor[100:105] = minor[200:205] = True
    main[:, 150:158] = True
    land[:] = ~(minor | main)
    tones = [
        known_tone(np.full(3, 240.0), land, 9000, 0.98, 15.0, 2.0, 0.5, 60.0, 0.03, 800.0),
        known_tone(np.full(3, 250.0), minor, 600, 0.98, 4.5, 1.4, even, 10.0, 0.16, 100.0),
        known_tone(np.array([60.0, 120.0, 180.0]), main, 300, 1.0, 8.0, 1.1, 0.9, 9.0, 0.8, 240.0),
    ]
    taken = {int(tone.color.mean()) for tone in road_tones(tones, 300)}
    assert taken == set(found)


def ribbon(rows: slice, color: tuple[int, int, int], **shape: float) -> MapTone:
    """A tone of a map (300, 300), a strip of some rows; `shape` says how it is uneven."""
    mask = np.zeros((300, 300), bool)
    mask[rows] = True
    width = float(mask[:, 0].sum())
    known = {"ribbons": 1.0, "spread": 1.0, "even": 0.9, "steady": 0.8} | shape
    return known_tone(
        np.array(color, float), mask, 300, known["ribbons"], width, known["spread"],
        known["even"], width, known["steady"], 300 * known["steady"], width,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("color", "found"), [((156, 178, 249), True), ((217, 218, 242), False)], ids=["orange", "pink"]
)
def test_carriageways_and_ramps_of_a_warm_color_are_main_roads(
    color: tuple[int, int, int], found: bool
) -> None:
    """They part and meet, so that their width varies as that of land does, which is paler."""
    land = ribbon(slice(0, 300), (240, 240, 240), steady=0.0)
    streets = ribbon(slice(100, 106), (255, 255, 255))
    ramps = ribbon(slice(106, 120), color, spread=2.8, even=0.5, steady=0.2)
    taken = [tuple(tone.color) for tone in road_tones([land, streets, ramps], 300)]
    assert (color in taken) is found


def test_outlines_of_one_pixel_are_no_streets() -> None:
    """Casings have the color of outlines of houses, which together are as long as the streets."""
    land = ribbon(slice(0, 300), (240, 240, 240), steady=0.0)
    streets, outline = ribbon(slice(100, 106), (255, 255, 255)), ribbon(slice(109, 110), (9, 9, 9))
    outline.mask[109, 100:], outline.mask[110:, 99] = False, True
    assert road_tones([land, streets, outline], 300) == [streets]


def rest(tone: MapTone) -> MapTone:
    return replace(tone, rest=True)


def shades(tones: list[MapTone]) -> list[int]:
    return [int(tone.color[0]) for tone in road_tones(tones, 300)]


def test_strips_left_of_gray_land_are_no_roads_where_others_are_long() -> None:
    """If they are far longer, they are streets in the color of rivers."""
    land = ribbon(slice(0, 300), (240, 240, 240), steady=0.0)
    strip = rest(ribbon(slice(106, 120), (180, 180, 180)))
    assert shades([land, ribbon(slice(100, 106), (255, 255, 255)), strip]) == [255]
    assert shades([land, ribbon(slice(100, 106), (255, 255, 255), even=0.8), strip]) == [255]
    assert shades([land, ribbon(slice(100, 106), (255, 255, 255), even=0.6), strip]) == [180, 255]


def test_hair_lines_left_of_gray_land_are_its_edges() -> None:
    land = ribbon(slice(0, 300), (240, 240, 240), steady=0.0)
    streets = ribbon(slice(100, 106), (255, 255, 255), steady=0.6)
    hair = ribbon(slice(110, 111), (180, 180, 180))
    assert shades([land, streets, hair]) == [180, 255]
    assert shades([land, streets, rest(hair)]) == [255]
