"""Masks grown, closed and opened row by row are those of OpenCV."""

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.masks.ellipses import closed_by, grown_by, opened_by

RNG = np.random.default_rng(3)


@pytest.mark.parametrize("size", [1, 9, 15, 16, 33, 78])
@pytest.mark.parametrize("shape", [(1, 1), (40, 3), (61, 90), (700, 500)])
@pytest.mark.parametrize("share", [0.002, 0.3, 0.99])
def test_they_are_those_of_opencv(shape: tuple[int, int], size: int, share: float) -> None:
    mask = RNG.random(shape) < share
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    seen = mask.view(np.uint8)
    assert np.array_equal(grown_by(mask, size), cv2.dilate(seen, kernel) > 0)
    for ours, kind in ((closed_by, cv2.MORPH_CLOSE), (opened_by, cv2.MORPH_OPEN)):
        assert np.array_equal(ours(mask, size), cv2.morphologyEx(seen, kind, kernel) > 0)
