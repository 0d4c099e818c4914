"""Clean drawings give exact roads: circuits between edge lines, filled roads, masks."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.drawings.thresholding import ContourSteps, roads_by_contour
from roadlang_standard.extraction.picture_kinds.picture_kind import picture_kind
from training.rendering.drawings import as_jpeg, draw_circuit, draw_filled


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("change", ["as drawn", "inverted", "jpeg"])
def test_a_circuit_is_one_closed_road_between_its_lines(
    seed: int, change: str, distance_to: Any
) -> None:
    drawn = draw_circuit(seed, size=500)
    changed = {"as drawn": drawn.image, "inverted": 255 - drawn.image}
    image = changed.get(change, as_jpeg(drawn.image, 60))
    found = roads_by_contour(image, ContourSteps())
    (road,) = found.roads
    assert found.method == "edge lines"
    assert road.closed
    (true,) = drawn.truth.roads
    # Bends tighter than half the road's width, of 2 px radius here, come out rounder.
    assert distance_to(road.points, np.vstack([true.points, true.points[:1]])).max() < 1.8
    assert distance_to(true.points, road.points).max() < 2.5
    assert abs(np.median(road.widths) / true.width - 1) < 0.15


@pytest.mark.parametrize("plan", ["curve", "suburb", "roundabout"])
@pytest.mark.parametrize(("ground", "ink"), [((255,) * 3, (60,) * 3), ((30, 90, 30), (200,) * 3)])
def test_filled_roads_are_found_to_the_pixel(
    plan: str, ground: Any, ink: Any, distance_to: Any
) -> None:
    drawn = draw_filled(plan, 3, 400, ground, ink)
    found = roads_by_contour(drawn.image, ContourSteps())
    seen = np.vstack([road.points for road in found.roads])
    true = [np.asarray(line) for line in drawn.truth.polylines()]
    away = np.min([distance_to(seen, line) for line in true], axis=0)
    assert np.quantile(away, 0.9) < 1.0
    nearest = np.argmin([distance_to(seen, road.points) for road in drawn.truth.roads], axis=0)
    true_widths = np.array([road.width for road in drawn.truth.roads])[nearest]
    widths = np.concatenate([road.widths for road in found.roads])
    assert np.median(np.abs(widths / true_widths - 1)) < 0.1


def test_the_threshold_can_be_given() -> None:
    image = np.full((60, 200, 3), 200, np.uint8)
    image[20:30] = 150
    image[40:50] = 20
    both = roads_by_contour(image, ContourSteps(threshold=0.7, road="dark", between=False))
    dark = roads_by_contour(image, ContourSteps(threshold=0.3, road="dark", between=False))
    assert (len(both.roads), len(dark.roads)) == (2, 1)


def test_a_blank_picture_has_no_road() -> None:
    found = roads_by_contour(np.full((50, 50, 3), 128, np.uint8), ContourSteps())
    assert found.roads == ()
    assert found.remarks


@pytest.mark.parametrize("seed", range(3))
def test_kinds_of_drawings_are_told_apart(seed: int) -> None:
    assert picture_kind(draw_circuit(seed).image).name == "edge-line drawing"
    assert picture_kind(draw_filled("suburb", seed).image).name == "filled drawing"
    mask = draw_filled("grid", seed, ground=(0, 0, 0), road=(255, 255, 255)).image
    assert picture_kind(mask).name == "mask"


def _plan() -> tuple[np.ndarray, np.ndarray]:
    """A drawn plan (h, w, 3) and the axis (n, 2) of its road: wide, between two lines with open
    ends, with a dash-dotted axis, dimensions, a frame and a title block."""
    x = np.linspace(60, 840, 200)
    axis = np.column_stack([x, 260 - 90 * np.tanh((x - 450) / 160)])
    along = np.gradient(axis, axis=0)
    left = np.column_stack([-along[:, 1], along[:, 0]]) / np.hypot(*along.T)[:, None]
    image = np.full((560, 900, 3), 255, np.uint8)
    for side in (30, -30):
        _lined(image, axis + side * left, (0, 0, 0), 3)
    for start in range(0, 190, 12):
        _lined(image, axis[start : start + 7], (0, 0, 255), 1)
    cv2.rectangle(image, (15, 15), (885, 545), (0, 0, 0), 2)
    cv2.rectangle(image, (640, 440), (885, 545), (0, 0, 0), 2)
    cv2.line(image, (60, 500), (560, 500), (0, 0, 0), 1)
    for tick in (60, 310, 560):
        cv2.line(image, (tick, 490), (tick, 510), (0, 0, 0), 1)
    for text, place in (("125.00 m", (140, 494)), ("140.00 m", (400, 494)), ("PLAN", (680, 500))):
        cv2.putText(image, text, place, cv2.FONT_HERSHEY_SIMPLEX, 0.6, (0, 0, 0), 1, cv2.LINE_AA)
    return image, axis


def test_the_paper_within_a_frame_is_no_road() -> None:
    """A road with open ends divides it into a long part, about as wide everywhere."""
    x = np.linspace(40, 960, 200)
    axis = np.column_stack([x, 350 - 110 * np.tanh((x - 500) / 200)])
    along = np.gradient(axis, axis=0)
    left = np.column_stack([-along[:, 1], along[:, 0]]) / np.hypot(*along.T)[:, None]
    image = np.full((700, 1000, 3), 255, np.uint8)
    for side in (36, -36):
        _lined(image, axis + side * left, (40, 40, 40), 2)
    cv2.rectangle(image, (12, 12), (988, 688), (40, 40, 40), 2)
    cv2.line(image, (60, 600), (500, 600), (40, 40, 40), 1)
    cv2.putText(image, "Profile A-A", (60, 640), cv2.FONT_HERSHEY_SIMPLEX, 0.8, (40, 40, 40), 1, 16)
    found = roads_by_contour(image, ContourSteps())
    (road,) = found.roads
    assert found.method == "edge lines"
    assert abs(float(np.median(road.widths)) - 72) < 4


def _lined(image: np.ndarray, line: np.ndarray, color: tuple[int, int, int], pen: int) -> None:
    points = np.round((line + 0.5) * 16 - 8).astype(np.int32)
    cv2.polylines(image, [points], False, color, pen, cv2.LINE_AA, 4)


def test_a_plan_with_dimensions_and_a_title_block_is_one_road(distance_to: Any) -> None:
    image, axis = _plan()
    found = Auto().extract(Picture(image, 1.0))
    assert found.remarks[0] == "read as an edge-line drawing"
    (road,) = found.network.edges
    points = Picture(image, 1.0).to_pixels(road.curve.at(np.linspace(0, road.length, 200)))
    assert distance_to(points, axis).max() < 2.0
    assert abs(float(np.median(road.width.at(np.linspace(0, road.length, 50)))) - 60) < 3
