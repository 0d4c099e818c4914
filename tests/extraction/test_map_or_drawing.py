"""What tells a drawing of few colors from a rendered map."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto

LAND, CASING, ORANGE, WHITE = (235, 240, 240), (60, 60, 60), (90, 200, 250), (255, 255, 255)


def picture(land: tuple[int, int, int] = LAND) -> np.ndarray:
    return np.full((500, 700, 3), land, np.uint8)


def crossing(
    image: np.ndarray, pairs: list[tuple[tuple[int, int, int], int]], shrink: int = 0
) -> np.ndarray:
    """A road from left to right and one from top to bottom, each with a color and a width."""
    for (color, width), ends in zip(
        pairs, (((60, 240), (640, 260)), ((340, 50), (360, 450))), strict=True
    ):
        cv2.line(image, *ends, color, width - shrink, cv2.LINE_AA)
    return image


def test_roads_as_light_as_the_land_are_found_within_their_casings() -> None:
    """Their tone is no darker than the ground's: read as a drawing, the casings were the roads."""
    image = crossing(picture(), [(CASING, 36), (CASING, 26)])
    image = crossing(image, [(ORANGE, 30), (WHITE, 20)])
    found = Auto().extract(Picture(image, 1.0))
    assert found.remarks[0] == "read as a rendered map"
    assert len(found.network.edges) == 4
    assert sum(edge.length for edge in found.network.edges) == pytest.approx(1010, abs=40)


def test_roads_with_lanes_and_zebra_crossings_are_drawn() -> None:
    """Their stripes are no letters of a map."""
    gray = (80, 80, 80)
    image = crossing(picture(), [(gray, 80), (gray, 80)])
    for x in (230, 440):
        for y in range(210, 290, 10):
            cv2.rectangle(image, (x, y), (x + 18, y + 4), WHITE, -1)
    for aside in (-36, -20, 20, 36):
        for ends in (
            ((60, 240 + aside), (220, 245 + aside)),
            ((470, 254 + aside), (640, 260 + aside)),
        ):
            cv2.line(image, *ends, WHITE, 2)
    for aside in (-3, 3):
        cv2.line(image, (60, 240 + aside), (220, 245 + aside), (0, 200, 255), 2)
        cv2.line(image, (470, 254 + aside), (640, 260 + aside), (0, 200, 255), 2)
    found = Auto().extract(Picture(image, 1.0))
    assert found.remarks[0] == "read as a filled drawing"
    assert len(found.network.edges) == 4


def test_edge_lines_are_found_beside_thinner_dimension_lines() -> None:
    image = picture(WHITE)
    for y in (220, 270):
        cv2.line(image, (50, y), (660, y), (0, 0, 0), 5)
    cv2.arrowedLine(image, (300, 245), (300, 223), (0, 0, 0), 1)
    cv2.arrowedLine(image, (300, 245), (300, 267), (0, 0, 0), 1)
    cv2.putText(image, "7.0 m", (310, 250), cv2.FONT_HERSHEY_SIMPLEX, 0.7, (0, 0, 0), 1)
    cv2.line(image, (50, 320), (660, 320), (0, 0, 0), 1)
    cv2.putText(image, "120 m", (330, 340), cv2.FONT_HERSHEY_SIMPLEX, 0.7, (0, 0, 0), 1)
    (road,) = Auto().extract(Picture(image, 1.0)).network.edges
    assert road.width.at(road.length / 2) == pytest.approx(50, abs=2)


@pytest.mark.parametrize("land", [(255, 255, 255), (90, 170, 110)])
@pytest.mark.parametrize(("width", "line"), [(22, 3), (22, 5), (40, 5)])
def test_a_wide_road_with_a_yellow_middle_line_is_one_road(
    land: tuple[int, int, int], width: int, line: int
) -> None:
    """The line is as long as the road, and its color differs from all else."""
    x = np.arange(-10, 720, 10)
    course = np.stack([x, 250 + 120 * np.sin(x / 110)], axis=1).round().astype(np.int32)
    image = cv2.polylines(picture(land), [course], False, (90, 90, 90), width, cv2.LINE_AA)
    image = cv2.polylines(image, [course], False, (0, 215, 255), line, cv2.LINE_AA)
    found = Auto().extract(Picture(image, 1.0))
    assert found.remarks[0] != "read as a rendered map"
    (road,) = found.network.edges
    assert road.length == pytest.approx(np.hypot(*np.diff(course, axis=0).T).sum(), rel=0.05)
