"""Single trees from above, as small pictures: what is seen of them and the shadow they throw."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from training.rendering.frame import Floats, Layer

_FINE = 4
"""Subpixels per pixel in which limbs are drawn, so that thin ones cover a part of a pixel."""


@dataclass(frozen=True, slots=True)
class View:
    """How heights appear on the picture.

    `sun` and `lean` (2,) are the meters by which each meter of height moves a shadow and the thing
    itself; `pixels` is how many pixels a meter has.
    """

    sun: Floats
    lean: Floats
    pixels: float


@dataclass(frozen=True, slots=True)
class Sprite:
    """A tree about its foot, the middle of each array: color (k, k, 3), cover (k, k) and shade
    (m, m), 0..1."""

    color: Layer
    cover: Layer
    shade: Layer


def bare_tree(rng: np.random.Generator, view: View, height: float, tone: Floats) -> Sprite:
    """A tree without leaves: a trunk, limbs and a haze of twigs."""
    limbs, twigs = _skeleton(rng, height)
    thick = max(1, round(0.05 * height / 3 * view.pixels * _FINE))
    layers = []
    for shift in (view.lean, view.sun):
        layer = _drawn(limbs, shift, view, thick, height)
        fine = _drawn(twigs, shift, view, 1, height)
        layers.append(np.maximum(layer, np.float32(rng.uniform(0.35, 0.8)) * fine))
    cover, shade = layers
    noise = rng.normal(1, 0.12, cover.shape).astype(np.float32)
    return Sprite(np.clip(noise[..., None] * tone, 0, 1).astype(np.float32), cover, shade)


def _skeleton(rng: np.random.Generator, height: float) -> tuple[Floats, Floats]:
    """Limbs and twigs as segments (n, 2, 3) in meters, the last axis x, y and height."""
    trunk = np.array([[[0.0, 0, 0], [*rng.normal(0, 0.03 * height, 2), 0.85 * height]]])
    count = int(rng.integers(5, 11))
    at = rng.uniform(0.25, 0.85, count)
    start = trunk[:, 0] + at[:, None] * (trunk[:, 1] - trunk[:, 0])
    limbs = _grown(rng, start, rng.uniform(0.16, 0.34, count) * height)
    share = rng.uniform(0.3, 1.0, (count, 5, 1))
    from_limbs = limbs[:, None, 0] + share * (limbs[:, None, 1] - limbs[:, None, 0])
    length = rng.uniform(0.06, 0.15, 5 * count) * height
    twigs = _grown(rng, from_limbs.reshape(-1, 3), length)
    return np.concatenate([trunk, limbs]), twigs


def _grown(rng: np.random.Generator, start: Floats, length: Floats) -> Floats:
    """One segment from each start, up and outward."""
    turn = rng.uniform(0, 2 * np.pi, len(start))
    rise = rng.uniform(0.2, 1.2, len(start))
    step = np.c_[np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)]
    return np.stack([start, start + length[:, None] * step], axis=1)


def _drawn(segments: Floats, shift: Floats, view: View, thick: int, height: float) -> Layer:
    reach = int(np.ceil((height * float(np.abs(shift).max()) + 0.6 * height) * view.pixels)) + 1
    side = (2 * reach + 1) * _FINE
    at = (segments[..., :2] + segments[..., 2:] * shift) * view.pixels * _FINE + side / 2
    fine = np.zeros((side, side), np.uint8)
    cv2.polylines(fine, list(np.round(at * 8).astype(np.int32)), False, 255, thick, cv2.LINE_AA, 3)
    whole = 2 * reach + 1
    return cv2.resize(fine, (whole, whole), interpolation=cv2.INTER_AREA).astype(np.float32) / 255


def needle_tree(rng: np.random.Generator, view: View, height: float, tone: Floats) -> Sprite:
    """A conifer: whorls that get narrower upward, brighter toward the sun and the top."""
    levels = np.linspace(0.15, 1, max(5, int(height / 1.2)))
    radius = height * rng.uniform(0.14, 0.26) * (1 - levels) ** rng.uniform(0.6, 1.0) + 0.3
    aside = rng.normal(0, 0.15, (len(levels), 2))
    return _stacked(rng, view, levels * height, radius, aside, tone, 0.95)


def leafy_tree(rng: np.random.Generator, view: View, height: float, tone: Floats) -> Sprite:
    """A crown of leaves: round clumps upon each other."""
    count = int(rng.integers(8, 20))
    wide = height * rng.uniform(0.2, 0.38)
    place = rng.normal(0, 0.45, (count, 2)) * wide
    level = height * np.clip(0.95 - 0.5 * (np.hypot(*place.T) / wide) ** 2, 0.35, 1)
    level += rng.normal(0, 0.04 * height, count)
    order = np.argsort(level)
    radius = wide * rng.uniform(0.3, 0.6, count)
    return _stacked(rng, view, level[order], radius, place[order], tone, 0.9)


def _stacked(
    rng: np.random.Generator,
    view: View,
    levels: Floats,
    radius: Floats,
    aside: Floats,
    tone: Floats,
    dense: float,
) -> Sprite:
    """Ragged clumps (n) at heights `levels`, the lowest first."""
    top = float(levels.max())
    wide = float((radius + np.abs(aside).max(axis=1)).max())
    color, cover = _canvas(wide + top * float(np.abs(view.lean).max()), view, 3)
    shade = _canvas(wide + top * float(np.abs(view.sun).max()), view, 1)[1]
    toward = -view.sun / max(1e-6, float(np.hypot(*view.sun)))
    for level, size, place in zip(levels, radius, aside, strict=True):
        clump, lit = _clump(rng, size * view.pixels, toward)
        bright = (0.45 + 0.55 * level / top) * (1 + 0.45 * lit) * rng.uniform(0.8, 1.2)
        _lay(color, cover, clump, bright[..., None] * tone, place + level * view.lean, view)
        _lay(None, shade, clump * dense, None, place + level * view.sun, view)
    return Sprite(color, cover, shade)


def _canvas(reach: float, view: View, channels: int) -> tuple[Layer, Layer]:
    side = 2 * (int(np.ceil(1.4 * reach * view.pixels)) + 2) + 1
    return np.zeros((side, side, channels), np.float32), np.zeros((side, side), np.float32)


def _clump(rng: np.random.Generator, radius: float, toward: Floats) -> tuple[Layer, Layer]:
    """Cover (k, k) of a ragged disc of `radius` pixels, and how much it faces the light, -1..1."""
    reach = int(np.ceil(1.35 * radius)) + 1
    y, x = np.mgrid[-reach : reach + 1, -reach : reach + 1].astype(np.float32)
    turn, away = np.arctan2(y, x), np.hypot(x, y)
    lobes = sum(rng.normal(0, 0.16) * np.cos(k * turn + rng.uniform(0, 6.3)) for k in (2, 3, 5, 7))
    rough = rng.normal(0, 0.12, x.shape)
    cover = np.clip((1 + lobes + rough) * radius - away + 0.5, 0, 1)
    lit = (x * toward[0] + y * toward[1]) / max(radius, 0.5) + rng.normal(0, 0.25, x.shape)
    return cover.astype(np.float32), np.clip(lit, -1, 1).astype(np.float32)


def _lay(
    color: Layer | None, cover: Layer, clump: Layer, paint: Layer | None, at: Floats, view: View
) -> None:
    x, y = np.round(at * view.pixels).astype(int) + cover.shape[0] // 2 - clump.shape[0] // 2
    side = clump.shape[0]
    if x < 0 or y < 0 or x + side > cover.shape[1] or y + side > cover.shape[0]:
        return
    there = (slice(y, y + side), slice(x, x + side))
    if color is not None and paint is not None:
        color[there] += clump[..., None] * (np.clip(paint, 0, 1) - color[there])
    cover[there] = np.maximum(cover[there], clump)
