"""Squared paper photographed at an angle: its printed lines meet far away."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.paper.ruling import without_ruling

_SIZE = (1000, 750)
_CORNERS = np.array([[0, 0], [1000, 0], [1000, 750], [0, 750]], np.float32)
_SEEN = np.array([[-20, -30], [1060, -10], [1010, 760], [-60, 790]], np.float32)


def _at_an_angle(layer: np.ndarray) -> np.ndarray:
    homography = cv2.getPerspectiveTransform(_CORNERS, _SEEN)
    warped = cv2.warpPerspective(layer, homography, _SIZE, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(warped)


def _squares() -> np.ndarray:
    layer = np.zeros(_SIZE[::-1], np.float32)
    layer[20::32] = layer[21::32] = 0.25
    layer[:, 20::32] = layer[:, 21::32] = 0.25
    return layer


def test_lines_that_meet_far_away_are_printed() -> None:
    ink = _at_an_angle(_squares())
    left = without_ruling(ink, 0.1)
    assert (left > 0.1).mean() < 0.1 * (ink > 0.1).mean()


def test_printed_lines_make_what_is_drawn_on_them_no_less_sure() -> None:
    """They have more edges than the road, but nobody drew them."""
    ink = _squares()
    x = np.linspace(60, 940, 300)
    road = np.column_stack([x, 375 + 150 * np.sin(x / 150)])
    cv2.polylines(ink, [np.round(road).astype(np.int32)], False, 0.5, 4, cv2.LINE_AA)
    rng = np.random.default_rng(2)
    light = np.array([225, 235, 238]) * (1 - _at_an_angle(ink)[..., None])
    image = np.clip(light + rng.normal(0, 2, light.shape), 0, 255).astype(np.uint8)
    found = Auto().extract(Picture(image, 1.0))
    assert found.remarks[0] == "read as a drawing on paper"
    (edge,) = found.network.edges
    assert edge.confidence > 0.9
