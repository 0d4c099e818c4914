"""Roads that are hardly lighter than the ground, with names on them."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.drawings.pale_roads import pale_surfaces

_GROUND, _ROAD, _NAME = (222, 239, 242), (255, 255, 255), (60, 60, 60)


def _named_streets() -> np.ndarray:
    """Two white streets on cream, rows 109 to 130 and 259 to 280, with their names on them."""
    image = np.full((400, 600, 3), _GROUND, np.uint8)
    image[109:131] = image[259:281] = _ROAD
    for row, name in ((120, "Main Street"), (270, "High Street")):
        cv2.putText(image, name, (220, row + 6), cv2.FONT_HERSHEY_SIMPLEX, 0.6, _NAME, 1)
    return image


def test_two_white_streets_on_cream_are_found_and_not_their_names() -> None:
    picture = Picture(_named_streets(), 1.0)
    found = Auto().extract(picture)
    rows = [
        picture.to_pixels(road.curve.at(np.linspace(0, road.length, 50)))[:, 1]
        for road in found.network.edges
    ]
    assert sorted(row.mean() for row in rows) == pytest.approx([119.5, 269.5], abs=0.6)
    assert max(np.ptp(row) for row in rows) < 1.5
    assert found.confidence > 0.9


def test_a_ground_of_one_tone_has_no_pale_roads() -> None:
    gray = np.full((100, 200), 240, np.uint8)
    gray[40:50] = 20
    assert pale_surfaces(gray, 128.0) is None
    shaded = gray.copy()
    shaded[60:] = np.linspace(210, 250, 200).astype(np.uint8)
    assert pale_surfaces(shaded, 128.0) is None
