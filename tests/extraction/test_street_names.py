"""Streets beneath the names that maps write along them."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.geometry import Booleans
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import MapTone, map_tone
from roadlang_standard.extraction.maps.road_tones import road_tones
from roadlang_standard.extraction.maps.street_names import streets_below_names
from tests.extraction.drawn_maps import as_jpeg, known_tone

WIDTH = 5.0
AT_END = slice(94, 106), slice(154, 240)


def blank() -> Booleans:
    return np.zeros((200, 300), bool)


def street_on_the_left() -> Booleans:
    """A street that ends where a name begins."""
    mask = blank()
    mask[98:103, 40:156] = True
    return mask


def name(where: tuple[slice, slice]) -> Booleans:
    letters = blank()
    letters[where] = True
    return letters


def test_a_street_goes_on_to_the_end_of_its_name() -> None:
    letters = name(AT_END)
    streets, named = streets_below_names(street_on_the_left(), letters, WIDTH)
    assert streets[99:102, 160:234].all()
    assert not streets[:, 244:].any()
    assert not streets[:94, 160:].any()
    assert (named == letters).all()


def test_a_name_on_a_street_that_is_wider_does_not_hide_it() -> None:
    mask = blank()
    mask[92:108, 40:156] = True
    streets, named = streets_below_names(mask, name(AT_END), 16.0)
    assert streets[99:102, 160:234].all()
    assert not named.any()


def test_the_street_is_drawn_where_it_leads_on_not_in_the_middle_of_the_letters() -> None:
    mask = blank()
    mask[95:100, 40:156] = mask[95:100, 238:] = True
    streets, _ = streets_below_names(mask, name(AT_END), WIDTH)
    rows, columns = np.nonzero(streets[:, 180:220])
    assert rows[columns == 20].mean() == pytest.approx(97, abs=0.6)


@pytest.mark.parametrize(
    "where",
    [
        (slice(94, 106), slice(160, 240)),  # beside a street that crosses
        (slice(80, 120), slice(154, 240)),  # in several lines
        (slice(97, 104), slice(154, 240)),  # dashes of a footpath
        (slice(94, 106), slice(154, 170)),  # a number
    ],
    ids=["beside", "lines", "dashes", "number"],
)
def test_no_street_is_below_other_words(where: tuple[slice, slice]) -> None:
    mask = street_on_the_left()
    if where[1].start == 160:
        mask = blank()
        mask[:, 153:158] = True
    streets, named = streets_below_names(mask, name(where), WIDTH)
    assert not streets.any()
    assert not named.any()


def test_a_name_may_bend_with_its_street() -> None:
    mask, letters = np.zeros((200, 300), np.uint8), np.zeros((200, 300), np.uint8)
    cv2.ellipse(letters, (150, 100), (60, 60), 0, -90, 0, 1, 12)
    cv2.line(mask, (40, 40), (152, 40), 1, 5)
    streets, _ = streets_below_names(mask > 0, letters > 0, WIDTH)
    rows, columns = np.nonzero(streets)
    off = np.abs(np.hypot(columns - 150, rows - 100) - 60)[columns > 152]
    assert off.max() < 6
    assert rows.max() > 92


def test_no_street_is_below_words_that_stand_beside_one_another() -> None:
    """Words that touch are no name that turns to both sides: the first of them alone is along the
    street."""
    letters = name(AT_END)
    letters[94:160, 190:202] = letters[148:160, 200:280] = True
    streets, _ = streets_below_names(street_on_the_left(), letters, WIDTH)
    assert streets[99:102, 160:234].all()
    assert not streets[106:].any()


def test_a_house_that_touches_a_name_hides_no_street() -> None:
    letters = name((slice(94, 106), slice(154, 260)))
    letters[106:132, 190:208] = True
    streets, named = streets_below_names(street_on_the_left(), letters, WIDTH)
    assert streets[100, 160:254].all()
    assert not streets[:92].any()
    assert not streets[112:].any()
    assert named[100, 160:254].all()
    assert not named[120:].any()


def test_two_lines_of_text_are_no_name_with_a_house_beside_it() -> None:
    letters = name((slice(90, 110), slice(154, 260)))
    letters[110:136, 190:208] = True
    streets, _ = streets_below_names(street_on_the_left(), letters, WIDTH)
    assert not streets.any()


def test_a_narrow_street_is_found_to_the_end_of_a_name_that_hides_it() -> None:
    image = np.full((360, 480, 3), 240, np.uint8)
    for line in ((40, 40, 440, 40), (40, 40, 40, 320), (40, 320, 440, 320), (40, 180, 330, 180)):
        cv2.line(image, line[:2], line[2:], (120, 120, 120), 5, cv2.LINE_AA)
    image[300:312, 200:230] = 200, 220, 210
    at = (230, 184)
    cv2.putText(image, "Mill Lane N", at, 0, 0.5, (240, 240, 240), 7, cv2.LINE_AA)
    cv2.putText(image, "Mill Lane N", at, 0, 0.5, (20, 20, 20), 1, cv2.LINE_AA)
    found = roads_of_map(image)
    assert found is not None
    points = np.vstack([road.points for road in found.roads])
    inner = points[np.abs(points[:, 1] - 180) < 60]
    assert inner[:, 0].max() == pytest.approx(332, abs=8)
    assert np.abs(inner[inner[:, 0] > 60][:, 1] - 180).max() < 3


def ribbon(color: tuple[int, int, int], mask: Booleans) -> MapTone:
    """A tone (RGB) of a map."""
    return map_tone(np.array(color[::-1], float), mask)


def test_a_river_of_a_violet_blue_is_no_road() -> None:
    river, street = np.zeros((400, 400), bool), np.zeros((400, 400), bool)
    river[100:112], street[:, 200:205], street[300:305] = True, True, True
    river &= ~street
    land = ~river & ~street
    tones = [
        ribbon((239, 239, 239), land),
        ribbon((255, 255, 255), street),
        ribbon((158, 189, 255), river),
    ]
    assert [tuple(tone.color) for tone in road_tones(tones, 400)] == [(255, 255, 255)]


def test_a_main_road_that_names_cut_is_a_road() -> None:
    """Less than half of it is in pieces that meet the other streets."""
    main, street = np.zeros((400, 400), bool), np.zeros((400, 400), bool)
    main[200:208, :80] = main[200:208, 120:240] = main[200:208, 280:] = True
    street[:198, 40:45] = street[210:, 20:25] = street[210:, 60:65] = True
    tones = [
        ribbon((239, 239, 239), ~main & ~street),
        ribbon((255, 255, 255), street),
        ribbon((255, 238, 170), main),
    ]
    assert {int(tone.color[0]) for tone in road_tones(tones, 400)} == {255, 170}


def test_a_map_of_few_streets_and_many_names_that_was_saved_as_jpeg_has_its_streets() -> None:
    """The outlines of its names, in the color of its streets, are more than they are."""
    image = np.full((600, 600, 3), (232, 239, 242), np.uint8)
    for line in ((-5, 300, 605, 300), (300, -5, 300, 300)):
        cv2.line(image, line[:2], line[2:], (205, 205, 205), 11, cv2.LINE_AA)
        cv2.line(image, line[:2], line[2:], (255, 255, 255), 9, cv2.LINE_AA)
    for y in (*range(60, 270, 30), *range(350, 600, 30)):
        for x in (30, 160, 340, 470):
            cv2.putText(image, "Meadow 12", (x, y), 0, 0.4, (255, 255, 255), 4, cv2.LINE_AA)
            cv2.putText(image, "Meadow 12", (x, y), 0, 0.4, (90, 90, 90), 1, cv2.LINE_AA)
    found = roads_of_map(as_jpeg(image, 80))
    assert found is not None
    points = np.vstack([road.points for road in found.roads])
    off = np.minimum(
        np.abs(points[:, 1] - 300), np.hypot(points[:, 0] - 300, np.maximum(points[:, 1] - 300, 0))
    )
    assert off.max() < 3
    assert points[:, 0].min() < 5
    assert points[:, 0].max() > 594
    assert points[:, 1].min() < 5


def test_streets_along_what_is_mostly_as_thin_as_they_are_have_no_casings_for_it() -> None:
    """In a JPEG the casings of streets may have the color of a strip of a park, which is wide."""
    street = np.zeros((400, 400), bool)
    street[:, 40:43] = street[:, 200:203] = street[200:203] = True
    casings = cv2.dilate(street.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0
    park = casings & ~street

    def tone(gray: float, where: Booleans, width: float, length: float) -> MapTone:
        shape = (length, 0.9, width, 1.5, 0.8, 40.0, 0.5, length / 2)
        return known_tone(np.full(3, gray), where, *shape)

    tones = [tone(240, ~casings, 50.0, 300.0), tone(255, street, 3.0, 1200.0)]
    found = road_tones([*tones, tone(225, park, 38.0, float(park.sum()) / 2)], 400)
    assert 255 in {one.color[0] for one in found}


def test_the_names_of_two_streets_that_touch_at_a_corner_cover_both() -> None:
    """The name of a street that comes from above ends on the name of one that crosses."""
    mask = blank()
    mask[98:103, 40:126] = mask[98:103, 268:] = mask[:22, 194:199] = True
    letters = name((slice(94, 106), slice(124, 270)))
    letters[20:96, 191:203] = True
    streets, named = streets_below_names(mask, letters, WIDTH)
    assert streets[99:102, 130:186].all()
    assert streets[99:102, 208:264].all()
    assert streets[26:90, 195:198].all()
    assert named[30, 196]


def test_two_names_of_shops_that_touch_are_no_street() -> None:
    """Together they rise a little, and a street leads up to one of them by chance."""
    mask = blank()
    mask[101:106, 10:76] = True
    letters = name((slice(97, 106), slice(76, 160)))
    letters[82:103, 150:230] = True
    assert not streets_below_names(mask, letters, WIDTH)[0].any()
