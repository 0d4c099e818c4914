"""Paved ground that is no road: parking lots with lines, islands and cars; yards between houses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from training.rendering.frame import Floats, Image, Layer, ribbon
from training.rendering.noise import blend, fractal
from training.rendering.pavement import car, quad
from training.rendering.setting import Setting

_ROW, _PLACE = 8.5, 2.7


@dataclass(frozen=True, slots=True)
class Lot:
    """A parking lot: center, half sides in meters, heading, and where it meets its street."""

    center: Floats
    half: Floats
    heading: float
    door: Floats


def lay_lots(rng: np.random.Generator, setting: Setting, image: Layer, lots: list[Lot]) -> None:
    """Pave the lots and their ways in, in place."""
    frame = setting.frame
    for lot in lots:
        tone = float(np.clip(setting.asphalt * rng.uniform(0.7, 1.3), 0.15, 0.8))
        u, _ = _axes(lot)
        side = np.vstack([lot.center - lot.half[0] * u, lot.center + lot.half[0] * u])
        window, alpha = ribbon(frame.pixels(side), frame.length(2 * lot.half[1]), frame.shape)
        blend(image[window], (tone,) * 3, alpha)
        way = np.vstack([lot.door, lot.door + 0.9 * (lot.center - lot.door)])
        window, alpha = ribbon(frame.pixels(way), frame.length(rng.uniform(4, 8)), frame.shape)
        blend(image[window], (tone,) * 3, alpha)


def lay_yards(rng: np.random.Generator, setting: Setting, image: Layer, near: Layer) -> None:
    """Pave a part of the ground (h, w, 3) near the streets in pale, patchy tones, in place."""
    patches = fractal(rng, setting.frame, rng.uniform(15, 40), 3) + rng.normal(-0.4, 0.7)
    cover = np.clip(3 * patches, 0, 1) * np.clip((60 - near) / 10, 0, 1) * rng.uniform(0.3, 0.9)
    tone = np.clip(rng.uniform(0.3, 0.75) * rng.normal(1, 0.03, 3), 0, 1)
    blend(image, tuple(tone), cover.astype(np.float32))


def fill_lots(rng: np.random.Generator, setting: Setting, image: Image, lots: list[Lot]) -> None:
    """Paint the places and the cars, in place: rows back to back, aisles between them."""
    for lot in lots:
        _fill(rng, setting, image, lot)


def _fill(rng: np.random.Generator, setting: Setting, image: Image, lot: Lot) -> None:
    u, v = _axes(lot)
    full = rng.uniform(0, 0.9)
    paint = rng.uniform(0.5, 0.95)
    islands = rng.random() < 0.5
    for row in np.arange(-lot.half[1] + 3, lot.half[1] - 2, _ROW):
        for place in np.arange(-lot.half[0] + 2, lot.half[0] - 1.5, _PLACE):
            at = lot.center + place * u + row * v
            if islands and rng.random() < 0.04:
                green = np.array(setting.palette["lawn"]) * rng.uniform(0.6, 1)
                quad(setting, image, at, np.array([1.2, 2.4]), lot.heading, green)
                continue
            line = np.array([0.08, 2.4])
            quad(setting, image, at + 0.5 * _PLACE * u, line, lot.heading, np.full(3, paint))
            if rng.random() < full:
                car(rng, setting, image, at, lot.heading + np.pi / 2)


def _axes(lot: Lot) -> tuple[Floats, Floats]:
    ahead = np.array([np.cos(lot.heading), np.sin(lot.heading)])
    return ahead, np.array([-ahead[1], ahead[0]])
