"""Railways: ballast, ties, rails, verges and cuttings, one track or a yard of them."""

from __future__ import annotations

import numpy as np

from training.rendering.frame import Floats, Layer, ribbon
from training.rendering.layouts.curves import crossing
from training.rendering.noise import blend
from training.rendering.pavement import offset
from training.rendering.setting import Setting

_SPACING = 4.4


def lay_railway(rng: np.random.Generator, setting: Setting, image: Layer, tracks: int) -> None:
    """A line of so many tracks across the picture, in place."""
    axis = crossing(rng, setting.frame.extent, 8e-4)
    bed = _SPACING * (tracks - 1) + rng.uniform(3.5, 6)
    soil = np.array(setting.palette["soil"]) * rng.uniform(0.6, 1.1)
    verge = bed + rng.uniform(2, 30)
    if rng.random() < 0.7:
        color = np.array(setting.palette["lawn"]) * rng.uniform(0.6, 1.2)
        _lay(setting, image, axis, verge, color, rng.uniform(0.4, 0.95))
    if rng.random() < 0.35:
        for side in (-1, 1):
            slope = offset(axis, side * (bed / 2 + 2))
            _lay(setting, image, slope, rng.uniform(2, 6), soil * (1 + 0.3 * side), 0.7)
    gray = rng.uniform(0.25, 0.65)
    ballast = gray * rng.normal([0.95, 1.0, 1.05], 0.04)
    _lay(setting, image, axis, bed, ballast, rng.uniform(0.7, 1.0))
    for track in range(tracks):
        line = offset(axis, (track - (tracks - 1) / 2) * _SPACING)
        _track(rng, setting, image, line, ballast)
    if tracks > 2:
        _wagons(rng, setting, image, axis, tracks)


def _track(
    rng: np.random.Generator, setting: Setting, image: Layer, line: Floats, ballast: Floats
) -> None:
    tie = ballast * rng.uniform(0.45, 0.9)
    _lay(setting, image, line, 2.4, tie, rng.uniform(0.3, 0.8))
    if setting.frame.meters_per_pixel < 0.6:
        for index in range(len(line) - 1):
            _lay(setting, image, _across(line, index), 0.3, tie * 0.8, 0.8)
    for side in (-0.72, 0.72):
        _lay(setting, image, offset(line, side), 0.18, np.full(3, rng.uniform(0.2, 0.8)), 0.9)


def _across(line: Floats, index: int) -> Floats:
    ahead = line[index + 1] - line[index]
    across = np.array([-ahead[1], ahead[0]]) / max(1e-9, float(np.hypot(*ahead)))
    return np.asarray(line[index] + np.outer(np.linspace(-1.25, 1.25, 4), across))


def _wagons(
    rng: np.random.Generator, setting: Setting, image: Layer, axis: Floats, tracks: int
) -> None:
    """Standing trains in a yard."""
    for _ in range(tracks):
        line = offset(axis, (int(rng.integers(tracks)) - (tracks - 1) / 2) * _SPACING)
        start = int(rng.integers(0, max(1, len(line) - 30)))
        for index in range(start, min(len(line) - 8, start + int(rng.integers(10, 80))), 8):
            color = np.clip(rng.uniform(0.1, 0.8) * rng.normal(1, 0.15, 3), 0, 1)
            _lay(setting, image, line[index : index + 7], 2.9, color, 1.0)


def _lay(
    setting: Setting, image: Layer, points: Floats, width: float, color: Floats, cover: float
) -> None:
    frame = setting.frame
    window, alpha = ribbon(frame.pixels(points), frame.length(width), frame.shape)
    blend(image[window], tuple(np.clip(color, 0, 1)), alpha * cover)
