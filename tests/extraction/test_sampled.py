"""Layers between their pixels, also of pictures that are longer than OpenCV takes."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.curves.sampled import sampled
from roadlang_standard.extraction.photos.classical import ribbon_evidence

X = np.array([[0.5, 2.25, -3.0, 99.0]], np.float32)
Y = np.array([[0.0, 1.5, 0.0, 0.0]], np.float32)


@pytest.mark.parametrize("columns", [4, 40_000])
@pytest.mark.parametrize("copies", [1, 10_000])
def test_values_lie_between_those_of_the_pixels_around(columns: int, copies: int) -> None:
    layer = np.zeros((3, columns), np.float32)
    layer[:, :4] = np.arange(4) + 10.0 * np.arange(3)[:, None]
    layer[:, 4:] = 3.0
    found = sampled(layer, np.tile(X, copies), np.tile(Y, copies))
    assert found.shape == (1, 4 * copies)
    np.testing.assert_allclose(found[0, -4:], [0.5, 17.25, 0.0, 3.0], atol=1e-4)


def test_a_picture_may_be_very_long() -> None:
    image = np.full((120, 33_000, 3), 230, np.uint8)
    cv2.line(image, (0, 55), (32_999, 65), (60, 60, 60), 9, cv2.LINE_AA)
    (road,) = Auto().extract(Picture(image, 1.0)).network.edges
    assert road.curve.length > 32_900


@pytest.mark.parametrize("turned", [False, True], ids=["wide", "tall"])
def test_ribbons_of_a_strip_are_those_of_its_pieces(turned: bool) -> None:
    """A strip is turned piece by piece: the canvas of the whole would be a square."""
    strip = np.random.default_rng(1).integers(90, 110, (60, 2000, 3), np.uint8)
    for x in (300, 480, 1200):
        strip[:, x : x + 9] = 160
    whole = strip.transpose(1, 0, 2) if turned else strip
    evidence = ribbon_evidence(np.ascontiguousarray(whole))
    along = (evidence.T if turned else evidence)[20:40].mean(axis=0)
    assert along.shape == (2000,)
    assert min(along[x + 4] for x in (300, 480, 1200)) > 2 * along[700:1000].max()
