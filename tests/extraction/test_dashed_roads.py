"""Roads drawn as dashes or dots are roads; words and rows of houses are none."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.drawings.dashed_roads import with_dashes_joined
from roadlang_standard.extraction.drawings.surface_roads import roads_of_surface

_SHAPE = (300, 400)
_TURN = np.linspace(0.2, 2.6, 60)
_BEND = np.column_stack([200 + 160 * np.cos(_TURN), 40 + 200 * np.sin(_TURN)])


def _dashed(length: int, gap: int, thick: int) -> np.ndarray:
    """A bend of about 430 px as dashes with square ends."""
    image = np.zeros(_SHAPE, np.float32)
    steps = np.hypot(*np.diff(_BEND, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    for start in np.arange(0.0, along[-1] - length, length + gap):
        at = np.array([start, start + length])
        a, b = np.column_stack([np.interp(at, along, column) for column in _BEND.T])
        ahead = (b - a) / np.hypot(*(b - a))
        aside = np.array([-ahead[1], ahead[0]]) * thick / 2
        corners = np.round(np.array([a - aside, b - aside, b + aside, a + aside]) * 16)
        cv2.fillPoly(image, [corners.astype(np.int32)], 1.0, cv2.LINE_8, 4)
    return image


@pytest.mark.parametrize(("length", "gap", "thick"), [(24, 10, 8), (16, 16, 5), (7, 7, 6)])
def test_dashes_and_dots_are_one_road(length: int, gap: int, thick: int) -> None:
    (road,) = roads_of_surface(with_dashes_joined(_dashed(length, gap, thick)), "test").roads
    away = np.hypot(*(road.points - (200, 40)).T / np.array([[160.0], [200.0]]))
    assert np.abs(away - 1).max() < 0.02
    assert road.confidence > 0.9


def test_words_stay_letters() -> None:
    image = np.zeros(_SHAPE, np.float32)
    for row, words in enumerate(("Streets of", "the old town", "and about it")):
        cv2.putText(image, words, (20, 60 + 80 * row), cv2.FONT_HERSHEY_SIMPLEX, 1.4, 1.0, 3)
    assert with_dashes_joined(image) is image


def test_houses_in_a_row_stay_houses() -> None:
    image = np.zeros(_SHAPE, np.float32)
    for left in range(10, 390, 45):
        image[100:125, left : left + 28] = 1.0
    assert with_dashes_joined(image) is image


def test_dots_beside_roads_stay_dots() -> None:
    """They are trees, or a path; dashed roads are most of what is drawn."""
    image = _dashed(7, 7, 6)
    image[20:40] = image[:, 10:30] = image[:, 370:390] = 1.0
    assert with_dashes_joined(image) is image
