"""What web pages draw over maps: buttons, boxes, scale bars, and whose data it is."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps.map_controls import without_controls
from roadlang_standard.extraction.maps.map_tiles import roads_of_map
from roadlang_standard.extraction.maps.map_tones import EXACT
from tests.extraction.drawn_maps import (
    DARK,
    LIGHT,
    PALE,
    MapStyle,
    drawn_map,
    found_streets,
    on_streets,
)

_WHITE, _GRAY = (255, 255, 255), (60, 60, 60)


def buttons(image: np.ndarray, left: int, top: int) -> None:
    """Two buttons, "+" and "-", with a line between them."""
    cv2.rectangle(image, (left - 1, top - 1), (left + 30, top + 61), (200, 200, 200), -1)
    for row in (top, top + 31):
        cv2.rectangle(image, (left, row), (left + 29, row + 29), _WHITE, -1)
        cv2.line(image, (left + 9, row + 15), (left + 20, row + 15), _GRAY, 2)
    cv2.line(image, (left + 15, top + 9), (left + 15, top + 20), _GRAY, 2)


def notice(image: np.ndarray, veil: float) -> None:
    """A strip at the right end of the bottom through which the map shines."""
    part = image[-18:, -210:]
    part[:] = np.round((1 - veil) * part + veil * 255)
    place = (image.shape[1] - 200, image.shape[0] - 5)
    cv2.putText(image, "(c) contributors of a map", place, 0, 0.4, _GRAY, 1, cv2.LINE_AA)


def scale_bar(image: np.ndarray) -> None:
    """A box open at its top, with a length in it."""
    row = image.shape[0] - 12
    cv2.rectangle(image, (10, row - 18), (101, row), _WHITE, -1)
    cv2.line(image, (10, row), (101, row), _GRAY, 2)
    for column in (10, 100):
        cv2.rectangle(image, (column, row - 18), (column + 1, row), _GRAY, -1)
    cv2.putText(image, "50 m", (16, row - 6), 0, 0.4, _GRAY, 1, cv2.LINE_AA)


def changed(image: np.ndarray) -> np.ndarray:
    return np.asarray((without_controls(image, EXACT) != image).any(axis=2))


@pytest.mark.parametrize("style", [LIGHT, PALE, DARK], ids=["light", "pale", "dark"])
def test_a_map_without_controls_stays_as_it_is(style: MapStyle) -> None:
    image = drawn_map(style)
    assert without_controls(image, EXACT) is image


def test_buttons_give_way_to_land() -> None:
    image = drawn_map(LIGHT)
    buttons(image, 12, 12)
    there = changed(image)
    assert there[12:72, 12:42].mean() > 0.9
    assert there[80:].sum() == 0


@pytest.mark.parametrize("veil", [0.5, 0.8])
def test_a_notice_through_which_the_map_shines_gives_way_to_land(veil: float) -> None:
    image = drawn_map(LIGHT)
    notice(image, veil)
    there = changed(image)
    assert there[-17:, -205:].mean() > 0.9
    assert not there[:-30].any()


def test_a_scale_bar_gives_way_to_land() -> None:
    image = drawn_map(LIGHT)
    scale_bar(image)
    there = changed(image)
    assert there[-28:-13, 12:98].mean() > 0.9
    assert not there[:-40].any()


def test_a_frame_around_another_view_goes_with_the_buttons() -> None:
    image = drawn_map(LIGHT)
    buttons(image, 12, 12)
    cv2.rectangle(image, (200, 140), (263, 203), (60, 90, 70), -1)
    cv2.rectangle(image, (200, 140), (263, 203), _WHITE, 2)
    assert changed(image)[142:202, 202:262].all()


def test_a_white_building_that_is_not_upright_stays() -> None:
    image = drawn_map(LIGHT)
    corners = cv2.boxPoints(((200.0, 150.0), (50.0, 40.0), 4.0)).astype(np.int32)
    cv2.fillPoly(image, [corners], _WHITE)
    cv2.putText(image, "12", (190, 156), 0, 0.5, _GRAY, 1, cv2.LINE_AA)
    assert without_controls(image, EXACT) is image


def test_the_streets_beside_controls_are_found_and_no_others() -> None:
    image = drawn_map(LIGHT)
    buttons(image, 12, 12)
    notice(image, 0.8)
    scale_bar(image)
    found = roads_of_map(image)
    assert found is not None
    points = np.vstack([road.points for road in found.roads])
    assert on_streets(points).mean() > 0.95
    assert found_streets(points).mean() > 0.85
