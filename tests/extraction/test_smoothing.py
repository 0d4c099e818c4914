"""Smoothing splines: noise goes, ends stay, deviation and bends are bounded."""

from __future__ import annotations

from typing import Any

import numpy as np

from roadlang_standard.extraction.curves.smoothing import curvature, resample, smooth


def noisy_sine(seed: int = 0) -> Any:
    x = np.arange(0, 400.0)
    true = np.c_[x, 30 * np.sin(x / 40)]
    return true, true + np.random.default_rng(seed).normal(0, 0.7, true.shape)


def test_noise_is_taken_out_and_the_ends_stay() -> None:
    true, seen = noisy_sine()
    curve = smooth(seen, wavelength=40, tolerance=5)
    assert np.abs(curve - true)[5:-5].mean() < 0.25
    assert (curve[[0, -1]] == seen[[0, -1]]).all()


def test_the_curve_stays_within_the_tolerance() -> None:
    _, seen = noisy_sine()
    curve = smooth(seen, wavelength=400, tolerance=3)
    assert np.hypot(*(curve - seen).T).max() <= 3


def test_a_corner_is_rounded_to_the_tightest_radius() -> None:
    corner = resample(np.array([[0.0, 0], [60, 0], [60, 60]]))
    curve = smooth(corner, wavelength=6, tolerance=4, tightest=8)
    assert 1 / curvature(curve)[3:-3].max() > 0.75 * 8


def test_a_closed_line_has_no_seam() -> None:
    angle = np.linspace(0, 2 * np.pi, 300, endpoint=False)
    circle = 50 * np.c_[np.cos(angle), np.sin(angle)]
    curve = smooth(circle, wavelength=20, tolerance=1, closed=True)
    assert abs(np.hypot(*curve.T) - 50).max() < 0.2
