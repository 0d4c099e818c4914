"""A photo of snow is no sheet of paper: trees and houses are paler than ink, and many."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from benchmarks.extraction.conditions import snow
from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.paper.pale_spots import pale_spots
from roadlang_standard.extraction.paper.paper import roads_on_paper
from tests.extraction.paper_drawings import drawn, photographed, ruled, sheet, wave
from training.rendering.aerial import render_aerial


@pytest.mark.parametrize("plan", ["suburb", "village"])
def test_a_photo_of_snow_is_read_as_a_photo(plan: str) -> None:
    rendering = render_aerial(plan, 88001, 512)
    image = snow(rendering, 1, deep=0.99)
    assert Auto().extract(Picture(image, 1.0)).remarks[0] == "read as a photo"


def test_rough_ground_with_packed_snow_is_no_sheet() -> None:
    """Snow in a forest leaves neither spots nor strokes, but more noise than paper has."""
    image = snow(render_aerial("bend", 89006, 512), 6, plowed=0.28)
    assert roads_on_paper(image, textured=True) is None


def test_colored_fields_and_printed_lines_are_still_paper() -> None:
    colored = sheet()
    rng = np.random.default_rng(2)
    for _ in range(14):
        x, y = (int(value) for value in rng.uniform((30, 30), (450, 330)))
        cv2.circle(colored, (x, y), int(rng.uniform(10, 40)), (190, 220, 205), -1, cv2.LINE_AA)
    for image in (colored, ruled(sheet(), squared=True)):
        found = roads_on_paper(photographed(drawn(image, wave(), 4)))
        assert found is not None
        assert len(found.roads) == 1


def test_spots_are_broad_paler_than_ink_and_away_from_it() -> None:
    ink = np.zeros((100, 100), np.float32)
    assert pale_spots(ink, 0.1, 0.01) == 0
    ink[50:53] = 0.8
    ink[10] = 0.3
    ink[53:58, 10:20] = 0.3
    assert pale_spots(ink, 0.1, 0.01) == 0
    for x in (10, 40, 70):
        ink[70:80, x : x + 10] = 0.3
    assert pale_spots(ink, 0.1, 0.01) == 3
    assert pale_spots(ink, 0.1, 0.2) == 0


def test_broad_printed_lines_and_shadows_are_no_spots() -> None:
    """In a photo of many pixels printed lines are broad, and a pen cuts each in two."""
    ink = np.zeros((1200, 1000), np.float32)
    for y in range(20, 1200, 40):
        ink[y : y + 7] = 0.2
    cv2.line(ink, (500, 0), (560, 1199), 0.8, 5)
    assert pale_spots(ink, 0.1, 0.01) == 0
    cv2.line(ink, (0, 600), (300, 480), 0.1, 60)
    assert pale_spots(ink, 0.05, 0.01) <= 1


def test_a_shadow_that_printed_lines_cut_into_squares_is_no_spots() -> None:
    ink = np.zeros((400, 400), np.float32)
    ink[195:205] = 0.8
    ink[40:160, 40:360] = 0.2
    for line in range(0, 400, 20):
        ink[line : line + 5, :][ink[line : line + 5] < 0.5] = 0
        ink[:, line : line + 5][ink[:, line : line + 5] < 0.5] = 0
    assert pale_spots(ink, 0.1, 0.01) > 50
    assert pale_spots(ink, 0.1, 0.01, was_ruled=True) <= 1
