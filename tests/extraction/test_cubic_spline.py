"""Cubic splines of roads are those of scipy, which takes longer to load than a road to be drawn."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from roadlang_standard.extraction.curves.cubic_spline import splined


@pytest.mark.parametrize("closed", [False, True], ids=["open", "closed"])
@pytest.mark.parametrize("count", [3, 4, 5, 60])
def test_a_spline_is_that_of_scipy(count: int, closed: bool) -> None:
    random = np.random.default_rng(count)
    station, points = np.cumsum(random.uniform(0.2, 3, count)), random.normal(size=(count, 2))
    if closed:
        points[-1] = points[0]
    at = np.linspace(station[0], station[-1], 200)
    expected = CubicSpline(station, points, bc_type="periodic" if closed else "not-a-knot")(at)
    np.testing.assert_allclose(splined(station, points, at, closed), expected, atol=1e-12)


def test_a_circuit_is_extracted_without_loading_what_is_not_needed() -> None:
    program = """
import sys
import cv2, numpy as np
from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto
image = np.full((300, 300, 3), 255, np.uint8)
cv2.circle(image, (150, 150), 100, (60, 60, 60), 12, cv2.LINE_AA)
(ring,) = Auto().extract(Picture(image, 1.0)).network.edges
assert ring.start == ring.end
assert "scipy.interpolate" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", program], check=True)
