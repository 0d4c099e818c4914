"""The small parts of a mask: the same, whether all pixels are counted or those in doubt alone."""

import numpy as np
import pytest
from scipy.ndimage import label

from roadlang_standard.extraction.mask_parts import small_parts


def drawn(share: float) -> np.ndarray:
    """Spots on (300, 400) pixels, and a large square that holds some of the paper."""
    rng = np.random.default_rng(7)
    mask = rng.random((300, 400)) < share
    mask[50:250, 60:300] = True
    mask[100:200, 100:200] = False
    return mask


@pytest.mark.parametrize("most", [2, 12, 5000])
@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("share", [0.0, 0.02, 0.5, 0.98])
def test_small_parts_are_those_of_fewer_pixels(share: float, diagonal: bool, most: int) -> None:
    mask = drawn(share)
    labels, _ = label(mask, np.ones((3, 3)) if diagonal else None)
    few = np.bincount(labels.ravel()) < most
    few[0] = False
    found = small_parts(mask, most, 8 if diagonal else 4)
    assert np.array_equal(np.zeros_like(mask) if found is None else found, few[labels])
    assert (found is None) == (not few.any())
