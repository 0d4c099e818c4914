"""Roads that leave a drawing obliquely: they do not bend on their way out."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_contour import Contour
from roadlang_standard.extraction.drawings.drawing import likeness

HEIGHT, WIDTH = 320, 480
MIDDLE = np.array([240.0, 160.0])
_FINE, _SHIFT = 4, 4


def straight(angle: float, width: float) -> tuple[Picture, np.ndarray]:
    """A drawing of a road across the whole picture, soft at its edges, and the normal to it."""
    ahead = np.array([np.cos(angle), np.sin(angle)])
    normal = np.array([-ahead[1], ahead[0]])
    aside, along = normal * width / 2, 900 * ahead
    corners = np.add(MIDDLE, [-along - aside, along - aside, along + aside, -along + aside])
    large = np.full((HEIGHT * _FINE, WIDTH * _FINE), 255, np.uint8)
    places = np.round(((corners + 0.5) * _FINE - 0.5) * 2**_SHIFT).astype(np.int32)
    cv2.fillPoly(large, [places], 0, cv2.LINE_AA, _SHIFT)
    gray = cv2.resize(large, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
    return Picture(cv2.merge([gray] * 3), 1.0), normal


@pytest.mark.parametrize("width", [9.0, 16.0, 30.0])
@pytest.mark.parametrize("degrees", [20.0, 40.0, 50.0, 60.0, 80.0, 130.0])
def test_a_straight_road_is_straight_to_its_ends(degrees: float, width: float) -> None:
    """A skeleton ends in a corner of the surface, up to half the cut beside the road's middle."""
    picture, normal = straight(np.radians(degrees), width)
    (road,) = Contour().extract(picture).network.edges
    along = np.linspace(0.0, road.length, 300)
    points = picture.to_pixels(road.curve.at(along))
    assert np.abs((points - MIDDLE) @ normal).max() < 0.4
    assert np.abs(road.curve.curvature(along)).max() < 2e-4
    assert np.ptp(road.width.at(along)) < 0.5
    # Their ends are on the border.
    from_rim = np.minimum(points + 0.5, np.array([WIDTH, HEIGHT]) - 0.5 - points).min(axis=1)
    assert np.abs(from_rim[[0, -1]]).max() < 1.2


def test_a_road_along_the_border_stays_where_it_is() -> None:
    """Half of it is beyond the border: it is led to no middle of that cut."""
    pixels = np.full((HEIGHT, WIDTH, 3), 255, np.uint8)
    pixels[:9, 100:380] = 0
    picture = Picture(pixels, 1.0)
    (road,) = Contour().extract(picture).network.edges
    points = picture.to_pixels(road.curve.at(np.linspace(0.0, road.length, 100)))
    assert np.abs(points[:, 1] - 4.0).max() < 1.0


def _arc(center: tuple[float, float], radius: float, width: int) -> Picture:
    """A drawing of a round road about a place that may be beyond the border."""
    large = np.full((HEIGHT * _FINE, WIDTH * _FINE), 255, np.uint8)
    place = np.round((np.add(center, 0.5) * _FINE - 0.5) * 2**_SHIFT).astype(int).tolist()
    around = round(radius * _FINE * 2**_SHIFT)
    cv2.circle(large, place, around, 0, width * _FINE, cv2.LINE_AA, _SHIFT)
    gray = cv2.resize(large, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
    return Picture(cv2.merge([gray] * 3), 1.0)


@pytest.mark.parametrize("width", [12, 28])
@pytest.mark.parametrize("aside", [-6.0, 0.0, 6.0])
def test_a_road_that_bends_leaves_through_a_corner_as_it_bends(aside: float, width: int) -> None:
    """No side of the picture shows the middle of its cut."""
    center, radius = (250.0, -250.0), np.hypot(250.0, 250.0) + aside
    picture = _arc(center, radius, width)
    (road,) = Contour().extract(picture).network.edges
    points = picture.to_pixels(road.curve.at(np.linspace(0.0, road.length, 300)))
    away = np.hypot(*(points - center).T) - radius
    assert np.abs(away).max() < 1.0


def test_the_ground_beside_a_road_from_corner_to_corner_is_no_road() -> None:
    """The picture shows no middle of what is on either side: it is not thin for that."""
    picture = _arc((547.0, 635.0), 627.5, 27)
    pixels = cv2.copyMakeBorder(picture.pixels, 0, 40, 0, 0, cv2.BORDER_REPLICATE)
    light = (pixels[..., 0] / 255.0).astype(np.float32)
    assert likeness(1 - light) > 10 * likeness(light)
