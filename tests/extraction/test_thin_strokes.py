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
