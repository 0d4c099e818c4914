"""Printed lines are bold or faint, and people draw along them."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.paper.ruling import without_ruling


def _ruling(count: int = 12) -> np.ndarray:
    """So many printed lines (h, w), every second one twice as dark: it is on one row of pixels."""
    ink = np.zeros((15 * count, 400), np.float32)
    ink[7::30], ink[22::30] = 0.3, 0.15
    return ink


def test_printed_lines_go_though_some_are_twice_as_dark() -> None:
    assert not without_ruling(_ruling(), 0.1).any()


@pytest.mark.parametrize("end", [120, 360])
def test_a_street_along_a_printed_line_stays(end: int) -> None:
    """Along a third of it, or nearly all of it; the rest of the line goes."""
    ink = _ruling()
    ink[51:54, 20:end] = 0.8
    cleaned = without_ruling(ink, 0.1)
    assert np.array_equal(cleaned[51:54, 20:end], ink[51:54, 20:end])
    assert cleaned.sum() == pytest.approx(ink[51:54, 20:end].sum())


def test_lines_beside_which_nothing_is_marked_do_no_harm() -> None:
    """At the border of a sheet at an angle, the fan has lines of which no pixel is in the
    picture."""
    rng = np.random.default_rng(7)
    rows, columns = np.mgrid[:90, :200]
    for spread in np.linspace(-0.3, 0.3, 25):
        slope = spread * (rows / 90 - 0.5)
        ink = np.where((rows + slope * columns) % 11 < 1, 0.3, 0).astype(np.float32)
        ink[rng.random(ink.shape) < 0.02] = 0.2
        assert without_ruling(ink, 0.1).shape == ink.shape
