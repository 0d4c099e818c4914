"""Roads differ from what is on both sides of them; edges and contours lie between two colors."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extract_contour import Contour
from roadlang_standard.extraction.doubts.picture_doubts import with_picture_doubts
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad

_LEVEL = 60
"""Row of the line in the pictures."""


def _found(*starts: float) -> FoundNetwork:
    """A level line 8 pixels wide, in pieces that do not meet, which begin at these columns and end
    30 pixels before the next one."""
    ends = [start - 30 for start in starts[1:]] + [199.0]
    roads = tuple(
        FoundRoad(
            2 * index,
            2 * index + 1,
            np.column_stack([np.linspace(start, end, 50), np.full(50, float(_LEVEL))]),
            np.full(50, 8.0),
        )
        for index, (start, end) in enumerate(zip(starts, ends, strict=True))
    )
    return FoundNetwork(np.zeros((2 * len(roads), 2)), roads, np.zeros((120, 200), bool))


def _bands(above: int, line: int, below: int, blur: float = 0.0) -> np.ndarray:
    picture = np.full((120, 200, 3), above, np.uint8)
    picture[_LEVEL - 4 : _LEVEL + 5] = line
    picture[_LEVEL + 5 :] = below
    return cv2.GaussianBlur(picture, (0, 0), blur) if blur else picture


def _sure(picture: np.ndarray, *starts: float, width: float | None = None) -> list[float]:
    found = with_picture_doubts(_found(*(starts or (0.0,))), picture, width)
    return [road.confidence for road in found.roads]


@pytest.mark.parametrize("blur", [0.0, 2.0])
def test_a_road_differs_from_both_sides_whatever_these_are(blur: float) -> None:
    assert _sure(_bands(200, 100, 200, blur)) == [1.0]
    assert _sure(_bands(160, 250, 210, blur)) == [1.0]
    assert _sure(_bands(120, 70, 240, blur)) == [1.0]


def test_a_strip_between_two_colors_and_the_rim_of_an_area_are_edges() -> None:
    assert _sure(_bands(200, 150, 100)) == [0.45]
    assert _sure(_bands(200, 150, 100, 4.0)) == [0.45]
    assert _sure(_bands(200, 100, 100)) == [0.45]


def test_a_road_between_two_lines_has_their_contrast() -> None:
    picture = _bands(200, 200, 200)
    picture[[_LEVEL - 4, _LEVEL + 4]] = 40
    assert _sure(picture) == [1.0]


def test_a_side_beyond_the_border_says_nothing() -> None:
    assert _sure(_bands(200, 150, 100)[_LEVEL - 60 : _LEVEL + 5]) == [0.45]
    cut = np.ascontiguousarray(_bands(200, 150, 100)[: _LEVEL + 2])
    assert _sure(cut) == [1.0]


def test_a_given_width_does_not_say_where_the_sides_are() -> None:
    assert _sure(_bands(200, 150, 100), width=8.0) == [1.0]


def test_where_most_lines_are_edges_all_are_doubted() -> None:
    picture = _bands(200, 150, 100)
    picture[_LEVEL + 5 :, 160:] = 200
    assert _sure(picture, 0.0, 170.0) == [0.45, 0.45]
    picture[_LEVEL + 5 :, 60:] = 200
    edge, road = _sure(picture, 0.0, 70.0)
    assert edge == 0.45
    assert road == 1.0


def _clouds() -> np.ndarray:
    """Three soft white clouds in a blue sky, without any noise: read as a drawing or a map."""
    sky = np.full((360, 480, 3), (215, 155, 95), np.uint8)
    for x, y, size in ((120, 100, 60), (190, 130, 70), (380, 260, 80)):
        cv2.ellipse(sky, (x, y), (size, int(0.7 * size)), 20, 0, 360, (245, 240, 235), -1)
    return np.asarray(cv2.GaussianBlur(sky, (0, 0), 7))


def test_contours_of_clouds_are_no_sure_roads() -> None:
    found = Auto().extract(Picture(_clouds(), 1.0))
    assert found.network.edges
    assert all(edge.confidence < 0.5 for edge in found.network.edges)


def test_a_face_on_a_plain_ground_is_no_drawing_on_paper() -> None:
    rng = np.random.default_rng(1)
    face = np.full((480, 640, 3), (120, 110, 100), np.uint8)
    cv2.ellipse(face, (320, 270), (110, 150), 0, 0, 360, (140, 170, 215), -1)
    cv2.ellipse(face, (320, 160), (125, 90), 0, 180, 360, (35, 50, 70), -1)
    for x in (278, 362):
        cv2.circle(face, (x, 250), 11, (60, 50, 45), -1)
    cv2.ellipse(face, (320, 340), (40, 14), 0, 0, 180, (90, 90, 180), 5)
    shade = cv2.GaussianBlur(rng.normal(0, 1, face.shape[:2]), (0, 0), 80)
    soft = cv2.GaussianBlur(face.astype(float), (0, 0), 2) + 3 * (shade / shade.std())[..., None]
    picture = np.clip(soft + rng.normal(0, 2, face.shape), 0, 255).astype(np.uint8)
    found = Auto().extract(Picture(picture, 1.0))
    assert all(edge.confidence < 0.5 for edge in found.network.edges)


def test_a_band_between_a_dark_and_a_light_area_is_no_sure_road() -> None:
    y, x = np.mgrid[:300, :400]
    off = y - 150 - 30 * np.sin(x / 60)
    band = np.where(off < -7, 235, np.where(off < 7, 110, 60)).astype(np.uint8)
    found = Contour().extract(Picture(np.dstack([band] * 3), 1.0))
    assert found.network.edges
    assert all(edge.confidence < 0.5 for edge in found.network.edges)
