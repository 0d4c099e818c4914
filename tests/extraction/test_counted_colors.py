"""Colors by how many pixels have them: the same answers as by looking at every pixel."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.colors.counted_colors import color_codes, counted, counted_colors


@pytest.fixture
def image() -> np.ndarray:
    """40 x 60 pixels of few colors, in no order."""
    levels = np.array([0, 3, 120, 254, 255], np.uint8)
    return levels[np.random.default_rng(1).integers(0, 5, (40, 60, 3))]


def test_a_code_has_blue_in_its_lowest_byte_and_red_in_its_highest() -> None:
    assert color_codes(np.array([[[1, 2, 3]]], np.uint8)).tolist() == [[1 + 2 * 256 + 3 * 65536]]


def test_codes_are_counted_as_numpy_does(image: np.ndarray) -> None:
    codes = color_codes(image)
    values, counts = np.unique(codes, return_counts=True)
    found = counted(codes)
    assert found[0].tolist() == values.tolist()
    assert found[1].tolist() == counts.tolist()


def test_no_pixels_have_no_colors() -> None:
    assert [each.tolist() for each in counted(np.zeros(0, np.int32))] == [[], []]


def test_medians_are_those_of_all_pixels(image: np.ndarray) -> None:
    """Of an even number of pixels the median lies between two."""
    pixels = image.reshape(-1, 3)
    for part in (pixels, pixels[:7], pixels[:8]):
        colors = counted_colors(color_codes(part[None]))
        all_of_them = np.ones(len(colors.counts), bool)
        assert colors.median(all_of_them).tolist() == np.median(part, axis=0).tolist()


def test_pixels_near_a_color_are_counted(image: np.ndarray) -> None:
    color = np.array([121.5, 4.0, 250.0])
    colors = counted_colors(color_codes(image))
    expected = (np.abs(image - color).max(axis=2) <= 5.5).sum()
    assert expected > 0
    assert colors.number(colors.near(color, 5.5)) == expected


def test_pixels_are_counted_by_bins_of_their_colors(image: np.ndarray) -> None:
    colors = counted_colors(color_codes(image))
    bins = (colors.colors[:, 0] > 100).astype(np.int32)
    bright = int((image[..., 0] > 100).sum())
    assert colors.binned(bins, 3).tolist() == [image[..., 0].size - bright, bright, 0]
