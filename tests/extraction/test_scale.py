"""At which size a photo is looked at, and which specks of a mask are noise."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.masks import without_holes, without_specks
from roadlang_standard.extraction.scale import resized, start_scale


def photo(height: int = 800, width: int = 1000) -> np.ndarray:
    return np.random.default_rng(3).integers(0, 255, (height, width, 3), dtype=np.uint8)


@pytest.mark.parametrize(
    ("meters_per_pixel", "scale"),
    [(0.3, 1 / 3), (0.09, 0.1), (0.01, 0.1), (0.9, 1.0), (0.8, 1.0), (5.0, 1.0)],
)
def test_a_fine_photo_is_made_smaller_and_no_photo_larger(
    meters_per_pixel: float, scale: float
) -> None:
    assert start_scale(photo(), meters_per_pixel) == pytest.approx(scale, rel=1e-3)


def test_a_small_photo_keeps_64_pixels() -> None:
    assert start_scale(photo(160, 400), 0.09) == pytest.approx(64 / 160)


def test_an_enlarged_photo_is_told_by_what_it_lacks() -> None:
    assert start_scale(photo()) == 1.0
    assert start_scale(resized(photo(300, 300), 4.0)) == pytest.approx(1 / 3)


@pytest.mark.parametrize(("least", "filled"), [(9, False), (10, True)])
def test_a_hole_of_as_many_pixels_as_asked_for_stays(least: int, filled: bool) -> None:
    mask = np.ones((20, 20), bool)
    mask[5:8, 5:8] = False
    assert without_holes(mask, least).all() == filled
    assert without_specks(~mask, least).any() != filled
