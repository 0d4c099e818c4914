"""Cars on a drawn road have road beneath them; arrows in a rare color beside it are no roads."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from roadlang_standard.extraction.drawings.drawing import roads_of_drawing
from roadlang_standard.extraction.drawings.objects_on_roads import with_objects

GRAY, BLUE, RED, ORANGE = (89, 89, 89), (196, 114, 68), (0, 0, 192), (49, 125, 237)
AXIS = np.column_stack([np.arange(40, 861.0), 300 - 90 * np.sin((np.arange(821.0)) / 180)])


def _slide() -> np.ndarray:
    """A slide (h, w, 3): a gray road with dashes, a text box, and an arrow to the road."""
    image = np.full((540, 900, 3), 255, np.uint8)
    points = np.round((AXIS + 0.5) * 16 - 8).astype(np.int32)
    cv2.polylines(image, [points], False, GRAY, 36, cv2.LINE_AA, 4)
    for start in range(10, 800, 40):
        cv2.polylines(
            image, [points[start : start + 20]], False, (255, 255, 255), 3, cv2.LINE_AA, 4
        )
    cv2.rectangle(image, (620, 430), (830, 510), BLUE, -1)
    cv2.arrowedLine(image, (620, 450), (480, 365), ORANGE, 3, cv2.LINE_AA, tipLength=0.2)
    return image


def test_cars_at_the_edge_of_a_road_are_on_it(distance_to: Any) -> None:
    image = _slide()
    for index, color, aside in ((150, BLUE, -9), (600, RED, 9)):
        x, y = np.round(AXIS[index]).astype(int)
        cv2.rectangle(image, (x - 18, y + aside - 8), (x + 18, y + aside + 8), color, -1)
    found = roads_of_drawing(image)
    (road,) = found.roads
    assert distance_to(road.points, AXIS).max() < 2.0


def test_an_arrow_in_a_color_of_its_own_is_no_road(distance_to: Any) -> None:
    (road,) = roads_of_drawing(_slide()).roads
    assert distance_to(road.points, AXIS).max() < 1.5


def test_islands_and_what_stands_beside_a_road_are_no_part_of_it() -> None:
    road, marked = np.zeros((200, 300), np.float32), np.zeros((200, 300), bool)
    road[80:120] = 1
    cv2.circle(road, (150, 100), 60, 1, -1)
    cv2.circle(road, (150, 100), 25, 0, -1)
    marked[80:120] = road[80:120] > 0
    for island in ((slice(60, 78), slice(20, 60)), (slice(75, 126), slice(125, 176))):
        marked[island] = road[island] == 0
    assert with_objects(road, marked) is road
    marked[85:100, 20:50], road[85:100, 20:50] = True, 0
    assert with_objects(road, marked)[85:100, 20:50].all()


def test_the_soft_edge_of_a_road_is_no_object_on_it() -> None:
    road, marked = np.zeros((100, 300), np.float32), np.zeros((100, 300), bool)
    road[3:23], marked[:23] = 1, True
    assert with_objects(road, marked) is road
