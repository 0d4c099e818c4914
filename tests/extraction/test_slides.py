"""Roads on slides, below a title."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.drawings.title_bars import without_title_bars

_BLUE, _GRAY, _WHITE = (150, 80, 20), (90, 90, 90), (255, 255, 255)
_NAVY, _SLATE, _LIGHT = (60, 35, 20), (85, 60, 45), (235, 235, 235)


def _slide(ground: tuple[int, ...], bar: tuple[int, ...], road: tuple[int, ...]) -> np.ndarray:
    """A road across another one, with dashes, and a title in white letters on a bar."""
    image = np.full((700, 1000, 3), ground, np.uint8)
    lines = [
        np.array([[80, 420], [500, 440], [920, 400]]),
        np.array([[520, 180], [500, 440], [430, 640]]),
    ]
    for color, width in ((road, 18), (ground, 3)):
        for line in lines:
            for start, end in pairwise(line):
                step = 1 if width > 3 else 2  # dashes
                places = np.linspace(start, end, 24)
                for a, b in zip(places[:-1:step], places[1::step], strict=False):
                    ends = [tuple(np.round(each).astype(int).tolist()) for each in (a, b)]
                    cv2.line(image, ends[0], ends[1], color, width, cv2.LINE_AA)
    cv2.rectangle(image, (0, 0), (999, 70), bar, -1)
    font = cv2.FONT_HERSHEY_SIMPLEX
    cv2.putText(image, "Test route: scenario 3", (30, 48), font, 1.2, _WHITE, 3, cv2.LINE_AA)
    return image


@pytest.mark.parametrize(
    "colors", [(_WHITE, _BLUE, _GRAY), (_NAVY, _SLATE, _LIGHT)], ids=["light", "dark"]
)
def test_the_title_of_a_slide_is_no_road(colors: tuple[tuple[int, ...], ...]) -> None:
    found = Auto().extract(Picture(_slide(*colors), 1.0))
    assert found.remarks[0] == "read as a filled drawing"
    assert len(found.network.edges) == 4
    assert min(road.confidence for road in found.network.edges) > 0.9


def test_a_road_along_the_border_is_no_title_bar() -> None:
    surface = np.zeros((200, 400), np.float32)
    across = np.arange(400)
    for row in range(200):
        surface[row] = row < 14 + 12 * np.sin(across / 60)
    assert without_title_bars(surface) is surface


@pytest.mark.parametrize("side", range(4))
def test_a_bar_goes_with_its_letters_at_any_side(side: int) -> None:
    surface = np.zeros((200, 400), np.float32)
    surface[:30] = 1
    surface[8:22, 20:120:6] = 0
    surface[100:110, 50:350] = 1
    turned = np.ascontiguousarray(np.rot90(surface, side))
    left = np.rot90(without_title_bars(turned), -side)
    assert not left[:30].any()
    assert np.array_equal(left[30:], surface[30:])
