"""Where trees stand, and the layers that all of them make together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from training.rendering.frame import Floats, Frame, Layer
from training.rendering.sunlit.sprites import Sprite


@dataclass
class Stand:
    """All trees of a scene: color (h, w, 3), cover (h, w) and the sunlight let through (h, w)."""

    color: Layer
    cover: Layer
    light: Layer

    @staticmethod
    def empty(frame: Frame) -> Stand:
        """No trees."""
        return Stand(
            np.zeros((*frame.shape, 3), np.float32),
            np.zeros(frame.shape, np.float32),
            np.ones(frame.shape, np.float32),
        )


def spots(rng: np.random.Generator, frame: Frame, density: Layer, pitch: float) -> Floats:
    """Places (n, 2) in meters, `pitch` apart on a jittered grid where `density` (0..1) is one."""
    lines = np.arange(0, frame.extent, pitch)
    grid = np.stack(np.meshgrid(lines, lines), axis=-1).reshape(-1, 2)
    at = grid + rng.uniform(0, pitch, grid.shape)
    column, row = np.clip(frame.pixels(at).round().astype(int), 0, frame.size - 1).T
    return np.asarray(at[rng.random(len(at)) < density[row, column]])


def grow(
    rng: np.random.Generator, frame: Frame, stand: Stand, kinds: list[Sprite], at: Floats
) -> None:
    """Put a tree of one of the kinds at each place, in place; those farther down lie above."""
    middle = np.round(frame.pixels(at)).astype(int)
    which = rng.integers(len(kinds), size=len(at))
    bright = rng.normal(1, 0.13, len(at)).clip(0.6, 1.5).astype(np.float32)
    for (x, y), index, gain in zip(middle, which, bright, strict=True):
        sprite = kinds[index]
        here, there = _overlap(frame, sprite.cover.shape[0], x, y)
        if here is not None:
            alpha = sprite.cover[here]
            color = stand.color[there]
            color += alpha[..., None] * (gain * sprite.color[here] - color)
            stand.cover[there] = 1 - (1 - stand.cover[there]) * (1 - alpha)
        here, there = _overlap(frame, sprite.shade.shape[0], x, y)
        if here is not None:
            stand.light[there] *= 1 - sprite.shade[here]


Window = tuple[slice, slice]


def _overlap(frame: Frame, side: int, x: int, y: int) -> tuple[Window | None, Window]:
    """The part of a sprite of `side` pixels about (x, y) that lies in the picture, and where."""
    reach, size = side // 2, frame.size
    top, left, bottom, right = max(0, y - reach), max(0, x - reach), y + reach + 1, x + reach + 1
    bottom, right = min(size, bottom), min(size, right)
    there = (slice(top, bottom), slice(left, right))
    if top >= bottom or left >= right:
        return None, there
    down, aside = reach - y, reach - x
    return (slice(top + down, bottom + down), slice(left + aside, right + aside)), there
