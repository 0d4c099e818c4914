"""A ring with dead ends that lead into it is drawn by filled roads, not by edges of one."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.drawings.drawing import has_edge_lines, roads_of_drawing

CENTER, RADII = np.array([500.0, 400.0]), np.array([350.0, 260.0])


def _ring(dead_ends: int, reach: float, pen: int) -> np.ndarray:
    image = np.full((800, 1000, 3), 255, np.uint8)
    cv2.ellipse(image, (500, 400), (350, 260), 0, 0, 360, (40, 40, 40), pen, cv2.LINE_AA)
    for angle in np.linspace(0, 2 * np.pi, dead_ends, endpoint=False):
        toward = RADII * [np.cos(angle), np.sin(angle)]
        start, end = ((CENTER + share * toward).astype(int).tolist() for share in (1.0, reach))
        cv2.line(image, start, end, (40, 40, 40), pen, cv2.LINE_AA)
    return image


@pytest.mark.parametrize(("dead_ends", "reach", "pen"), [(8, 0.6, 14), (10, 0.6, 6), (10, 0.3, 14)])
def test_dead_ends_within_a_ring_are_roads(dead_ends: int, reach: float, pen: int) -> None:
    found = roads_of_drawing(_ring(dead_ends, reach, pen))
    assert len(found.roads) == 2 * dead_ends
    assert np.median([np.median(road.widths) for road in found.roads]) == pytest.approx(pen, abs=2)


def test_a_ring_of_two_edges_with_a_marked_center_line_stays_one_road() -> None:
    image = np.full((800, 1000, 3), 255, np.uint8)
    for share in (1.0, 0.8):
        axes = (RADII * share).astype(int).tolist()
        cv2.ellipse(image, (500, 400), axes, 0, 0, 360, (0, 0, 0), 4, cv2.LINE_AA)
    for angle in range(0, 360, 8):
        axes = (RADII * 0.9).astype(int).tolist()
        cv2.ellipse(image, (500, 400), axes, 0, angle, angle + 4, (0, 0, 0), 3, cv2.LINE_AA)
    assert has_edge_lines(image[:, :, 0] < 128)
    assert len(roads_of_drawing(image).roads) == 1
