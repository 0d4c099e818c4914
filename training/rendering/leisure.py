"""Sports grounds: running tracks, courts and diamonds, which look like roads but are none."""

from __future__ import annotations

import numpy as np

from training.rendering.frame import Floats, Layer, ribbon
from training.rendering.ground import polygon
from training.rendering.noise import blend
from training.rendering.setting import Setting


def lay_grounds(rng: np.random.Generator, setting: Setting, image: Layer) -> None:
    """Lay a few of them anywhere, in place, before houses and streets cover them."""
    for _ in range(rng.poisson(0.5)):
        kind = rng.integers(3)
        center = rng.uniform(0, setting.frame.extent, 2)
        turn = rng.uniform(0, np.pi)
        if kind == 0:
            _track(rng, setting, image, center, turn)
        elif kind == 1:
            _courts(rng, setting, image, center, turn)
        else:
            _diamond(rng, setting, image, center, turn)


def _turned(points: Floats, center: Floats, turn: float) -> Floats:
    spin = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    return np.asarray(center + points @ spin.T)


def _track(
    rng: np.random.Generator, setting: Setting, image: Layer, center: Floats, turn: float
) -> None:
    frame, radius, straight = setting.frame, rng.uniform(30, 38), rng.uniform(35, 45)
    angle = np.linspace(-np.pi / 2, np.pi / 2, 24)
    cap = np.c_[straight + radius * np.cos(angle), radius * np.sin(angle)]
    oval = np.vstack([cap, -cap])
    grass = np.array(setting.palette["lawn"]) * rng.uniform(0.8, 1.2)
    blend(image, tuple(np.clip(grass, 0, 1)), polygon(frame, _turned(oval, center, turn)))
    red, gray = np.array([0.32, 0.36, 0.55]), np.full(3, rng.uniform(0.3, 0.6))
    tone = np.clip((red if rng.random() < 0.5 else gray) * rng.uniform(0.8, 1.3), 0, 1)
    ring = _turned(np.vstack([oval, oval[:2]]), center, turn)
    window, alpha = ribbon(frame.pixels(ring), frame.length(rng.uniform(6, 9)), frame.shape)
    blend(image[window], tuple(tone), alpha)


def _courts(
    rng: np.random.Generator, setting: Setting, image: Layer, center: Floats, turn: float
) -> None:
    frame, half = setting.frame, np.array([9.0, 18.0])
    box = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    colors = ([0.35, 0.42, 0.25], [0.5, 0.4, 0.25], [0.5, 0.5, 0.5])
    apron = np.array(colors[int(rng.integers(3))]) * rng.uniform(0.8, 1.4)
    inner = np.array(colors[int(rng.integers(3))]) * rng.uniform(0.8, 1.4)
    for index in range(int(rng.integers(1, 5))):
        middle = _turned(np.array([[index * 2 * half[0], 0.0]]), center, turn)[0]
        for size, tone in ((1.0, apron), (0.6, inner)):
            cover = polygon(frame, _turned(box * half * size, middle, turn))
            blend(image, tuple(np.clip(tone, 0, 1)), cover)


def _diamond(
    rng: np.random.Generator, setting: Setting, image: Layer, center: Floats, turn: float
) -> None:
    frame, reach = setting.frame, rng.uniform(25, 40)
    angle = np.linspace(0, np.pi / 2, 16)
    fan = np.vstack([[[0.0, 0.0]], reach * np.c_[np.cos(angle), np.sin(angle)]])
    soil = np.clip(np.array(setting.palette["soil"]) * rng.uniform(0.9, 1.4), 0, 1)
    lawn = np.clip(np.array(setting.palette["lawn"]) * rng.uniform(0.8, 1.2), 0, 1)
    for size, tone in ((2.4, lawn), (1.0, soil), (0.6, lawn)):
        blend(image, tuple(tone), polygon(frame, _turned(size * fan, center, turn)))
