"""A line that is little of what a picture shows is no sure road; a road among names is."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.doubts import picture_doubts
from roadlang_standard.extraction.doubts.share_of_marks import sure_by_share
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad

_LINE = np.column_stack([np.linspace(0, 639, 100), 240 + 60 * np.sin(np.linspace(0, 6, 100))])


def _written(rows: int, dark: int = 20) -> np.ndarray:
    """A white page of 480 x 640 with so many rows of words, except near the line."""
    page = np.full((480, 640, 3), 250, np.uint8)
    for row in range(rows):
        y = 30 + 22 * row
        words = "words of a page, all in rows, of which many fill it"
        cv2.putText(page, words, (20, y), cv2.FONT_HERSHEY_SIMPLEX, 0.7, (dark,) * 3, 2)
    near = np.zeros(page.shape[:2], np.uint8)
    cv2.polylines(near, [np.round(_LINE).astype(np.int32)], False, 1, 40)
    page[near > 0] = 250
    return page


def _with_line(page: np.ndarray, width: int, gray: int) -> tuple[FoundNetwork, np.ndarray]:
    picture = page.copy()
    line = [np.round(_LINE * 16).astype(np.int32)]
    cv2.polylines(picture, line, False, (gray,) * 3, width, cv2.LINE_AA, 4)
    road = FoundRoad(0, 1, _LINE, np.full(len(_LINE), float(width)))
    return FoundNetwork(_LINE[[0, -1]], (road,), np.zeros(page.shape[:2], bool)), picture


@pytest.mark.parametrize("width", [4, 20])
def test_a_line_through_a_full_page_is_no_sure_road(width: int) -> None:
    assert sure_by_share(*_with_line(_written(20), width, 60)) == 0.45


@pytest.mark.parametrize("width", [4, 20])
def test_a_road_with_a_row_of_names_beside_it_is_sure(width: int) -> None:
    assert sure_by_share(*_with_line(_written(1), width, 60)) == 1.0


def test_pale_roads_count_beside_dark_names() -> None:
    assert sure_by_share(*_with_line(_written(1), 20, 228)) == 1.0


def test_grain_far_weaker_than_the_road_does_not_count() -> None:
    found, picture = _with_line(_written(0), 20, 60)
    grain = np.random.default_rng(1).normal(0, 6, picture.shape)
    noisy = np.clip(picture + grain, 0, 255).astype(np.uint8)
    assert sure_by_share(found, noisy) == 1.0


def _screen() -> np.ndarray:
    """A window full of colored rows of text, with a line from side to side."""
    screen = np.full((600, 800, 3), (252, 251, 250), np.uint8)
    colors = ((160, 40, 20), (30, 120, 40), (40, 40, 40))
    for row in range(25):
        text = " " * (row % 4) + f"if window.rows[{row}] == other: text.draw(row, size)"
        color = colors[row % 3]
        cv2.putText(screen, text, (20, 24 + 23 * row), cv2.FONT_HERSHEY_SIMPLEX, 0.6, color, 1)
    screen[300:306] = (200, 170, 140)
    return screen


def test_a_line_of_a_screen_full_of_text_is_no_sure_road(monkeypatch: pytest.MonkeyPatch) -> None:
    def surest() -> float:
        found = Auto().extract(Picture(_screen(), 1.0))
        return max((edge.confidence for edge in found.network.edges), default=0.0)

    assert surest() < 0.5
    monkeypatch.setattr(picture_doubts, "sure_by_share", lambda *_: 1.0)
    assert surest() > 0.5
