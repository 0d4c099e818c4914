"""The grain of the paper breaks the line of a pencil; it is one road all the same."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang_standard.extraction.paper.paper import roads_on_paper
from roadlang_standard.extraction.paper.pencil import unbroken

_SHAPE = (600, 800)


def _pencil_drawing(line: np.ndarray) -> np.ndarray:
    """A line (n, 2) drawn with a pencil on rough paper (h, w, 3) BGR."""
    rng = np.random.default_rng(4)
    grain = cv2.GaussianBlur(rng.normal(0, 1, _SHAPE), (0, 0), 0.9)
    stroke = np.zeros(_SHAPE, np.uint8)
    cv2.polylines(stroke, [np.round(line).astype(np.int32)], False, 255, 3, cv2.LINE_AA)
    cover = np.clip(0.6 + 0.25 * grain / grain.std(), 0, 1) * stroke / 255
    sheet = 235 * (1 - cover[..., None]) + 90 * cover[..., None]
    seen = cv2.GaussianBlur(np.repeat(sheet, 3, axis=2), (0, 0), 0.5)
    noisy = seen + rng.normal(0, 2, seen.shape)
    return np.asarray(np.clip(noisy, 0, 255), np.uint8)


def test_a_line_of_a_pencil_is_one_road() -> None:
    x = np.linspace(60, 740, 300)
    line = np.column_stack([x, 300 + 130 * np.sin(x / 110)])
    found = roads_on_paper(_pencil_drawing(line), textured=True)
    assert found is not None
    (road,) = found.roads
    length = np.hypot(*np.diff(line, axis=0).T).sum()
    assert abs(road.length - length) < 0.02 * length
    assert road.confidence > 0.5


def test_two_lines_side_by_side_stay_two() -> None:
    """Smoothed into one they would be longer, but only half of all."""
    two, one = np.zeros(_SHAPE, bool), np.zeros(_SHAPE, bool)
    for x in range(50, 750, 100):
        two[300:303, x : x + 95] = two[308:311, x : x + 95] = True
    one[300:311, 50:750] = True
    assert unbroken(two, lambda: one, shortest=60) is two


def test_letters_are_not_missed_where_the_ink_is_smoothed() -> None:
    """Ten letters as long together as a line that is cut into two: without them it is one."""
    broken, whole = np.zeros(_SHAPE, bool), np.zeros(_SHAPE, bool)
    broken[300:303, 50:400] = broken[300:303, 403:750] = whole[300:303, 50:750] = True
    for x in range(50, 750, 70):
        broken[100:103, x : x + 55] = True
    assert unbroken(broken, lambda: whole, shortest=60) is whole


def test_letters_alone_are_not_joined() -> None:
    letters, row = np.zeros(_SHAPE, bool), np.zeros(_SHAPE, bool)
    for x in range(50, 750, 70):
        letters[100:103, x : x + 55] = True
    row[100:103, 50:400] = True
    assert unbroken(letters, lambda: row, shortest=60) is letters
