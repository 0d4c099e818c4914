"""Names, arrows and frames are drawn with a thinner pen than the roads, and are none."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang_standard.extraction.drawings.surface_roads import roads_of_surface
from roadlang_standard.extraction.networks.found_network import FoundNetwork
from tests.extraction.painted_roads import band

_WHITE = 1.0


def _found(image: np.ndarray) -> FoundNetwork:
    return roads_of_surface(image, "test")


def _street() -> np.ndarray:
    """A road of rows 90 to 101."""
    return band(90, 102, 200, 300)


def test_a_name_and_an_arrow_are_left_out_and_that_is_said() -> None:
    image = _street()
    cv2.putText(image, "Main Street", (60, 70), cv2.FONT_HERSHEY_SIMPLEX, 0.8, _WHITE, 2)
    cv2.arrowedLine(image, (100, 130), (160, 130), _WHITE, 2)
    found = _found(image)
    assert len(found.roads) == 1
    assert any("names and arrows" in remark for remark in found.remarks)
    assert not _found(_street()).remarks


def test_a_thin_road_stays_where_it_is_long_or_leaves_the_picture() -> None:
    image = _street()
    cv2.line(image, (40, 150), (260, 150), _WHITE, 3)
    cv2.line(image, (40, 0), (40, 50), _WHITE, 3)
    assert len(_found(image).roads) == 3


def test_short_roads_of_the_same_width_stay() -> None:
    image = _street()
    image[140:152, 100:160] = _WHITE
    assert len(_found(image).roads) == 2


def test_a_frame_is_no_road_and_a_ring_road_is_one() -> None:
    framed = _street()
    cv2.rectangle(framed, (4, 4), (295, 195), _WHITE, 2)
    (road,) = _found(framed).roads
    assert np.abs(road.points[:, 1] - 95.5).max() < 0.6
    around = _street()
    cv2.rectangle(around, (6, 6), (293, 193), _WHITE, 10)
    assert len(_found(around).roads) > 2


def test_an_arrow_that_touches_a_road_is_left_out_and_a_thin_road_that_leaves_it_is_not() -> None:
    image = _street()
    cv2.line(image, (100, 96), (100, 130), _WHITE, 1)
    cv2.line(image, (100, 130), (108, 138), _WHITE, 1)
    (road,) = (found := _found(image)).roads
    assert np.abs(road.points[:, 1] - 95.5).max() < 0.6
    assert any("names and arrows" in remark for remark in found.remarks)
    path = _street()
    cv2.line(path, (100, 96), (100, 199), _WHITE, 1)
    assert len(_found(path).roads) == 3
    drive = _street()
    drive[96:150, 100:105] = _WHITE
    assert len(_found(drive).roads) == 3


def test_letters_go_also_where_their_thinnest_strokes_are_taken_for_arrows() -> None:
    """Of a letter that loses such a stroke the rest is one line, made anew."""
    image = np.zeros((500, 700), np.float32)
    cv2.ellipse(image, (350, 250), (320, 220), 0, 0, 360, _WHITE, 10)
    for y, name in enumerate(("Main St", "Shop", "Elm Bank", "Home Rd 12")):
        place = (180, 150 + 60 * y)
        cv2.putText(image, name, place, cv2.FONT_HERSHEY_SIMPLEX, 1.0, _WHITE, 2)
    assert len(_found(image).roads) == 1


def test_a_name_written_with_the_same_pen_is_left_out_beside_a_long_road_only() -> None:
    image = np.zeros((600, 800), np.float32)
    cv2.ellipse(image, (400, 300), (350, 250), 0, 0, 360, _WHITE, 7, cv2.LINE_AA)
    name = image.copy()
    cv2.putText(name, "Lake", (330, 300), cv2.FONT_HERSHEY_SCRIPT_SIMPLEX, 1.6, _WHITE, 7)
    found = _found(name)
    assert len(found.roads) == 1
    assert found.roads[0].confidence == 1.0
    page = np.zeros((600, 800), np.float32)
    page[100:107, 50:750] = _WHITE
    for y in range(180, 560, 70):
        cv2.putText(page, "Lake Rd Lake", (60, y), cv2.FONT_HERSHEY_SCRIPT_SIMPLEX, 1.6, _WHITE, 7)
    roads = _found(page).roads
    assert len(roads) > 10
    assert max(road.confidence for road in roads) < 0.5
