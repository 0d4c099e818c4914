"""Ribbons of a map: strips that keep their width."""

from __future__ import annotations

import numpy as np

from roadlang_standard.extraction.maps.tone_shape import ToneSurface


def _strip(period: int) -> np.ndarray:
    """A street across a map (200, 200), of 4 pixels and, in every second part, of 5."""
    mask = np.zeros((200, 200), bool)
    mask[98:102] = True
    mask[102] = np.arange(200) // period % 2 == 0
    return mask


def test_a_street_as_wide_as_the_bound_between_two_classes_keeps_its_width() -> None:
    for period in (2, 3, 5, 8):
        assert ToneSurface(_strip(period)).steadiness.share > 0.9, period


def test_squares_do_not_keep_their_width() -> None:
    mask = np.zeros((200, 200), bool)
    for row in range(5, 190, 20):
        for column in range(5, 190, 20):
            mask[row : row + 14, column : column + 14] = True
    assert ToneSurface(mask).steadiness.share < 0.2
