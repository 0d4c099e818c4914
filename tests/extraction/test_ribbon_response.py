"""The response of ribbons, evaluated in parts, is that of the whole picture."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.photos.classical import _LENGTH, _WIDTHS, _response


@pytest.mark.parametrize("side", [5, 40, 120])
def test_it_is_that_of_the_whole_picture_where_that_is_shown(side: int) -> None:
    turned = np.random.default_rng(side).normal(size=(side, side)).astype(np.float32)
    shown = np.zeros((side, side), np.uint8)
    shown[side // 5 :, : side // 2] = 1
    whole = np.zeros_like(turned)
    for bar in _WIDTHS:
        inner = cv2.blur(turned, (_LENGTH, bar))
        rough = cv2.blur(turned * turned, (_LENGTH, bar)) - inner * inner
        above, below = inner - np.roll(inner, bar + 1, 0), inner - np.roll(inner, -bar - 1, 0)
        edge = np.maximum(np.minimum(above, below), -np.maximum(above, below))
        whole = np.maximum(whole, edge - 0.35 * np.sqrt(np.maximum(rough, 0)))
    found = _response(turned, shown)
    assert (found == whole)[shown > 0].all()
