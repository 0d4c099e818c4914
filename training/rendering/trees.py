"""Woods and single trees: crowns that hide the road, and the shadows they throw on it."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from training.rendering.extras import Extras
from training.rendering.frame import Floats, Layer, PlannedRoad, ribbon
from training.rendering.layouts.curves import crossing
from training.rendering.noise import fractal, relief, smooth, streaks
from training.rendering.setting import Setting


@dataclass
class Canopy:
    """Crowns from above: color (h, w, 3), cover (h, w), how much shade they throw (h, w)."""

    color: Layer
    cover: Layer
    shade: Layer


def woods(rng: np.random.Generator, setting: Setting, near: Layer, water: Layer) -> Canopy:
    """Closed woodland, kept off water and mostly off the roads."""
    frame = setting.frame
    settled = -0.9 * setting.homes * np.clip(1 - near / 45, 0, 1)
    field = fractal(rng, frame, rng.uniform(120, 400), 5, 0.5) + setting.woods + settled
    field = field + 0.08 * smooth(rng, frame, 4)
    cover = np.clip(field * rng.uniform(3, 10), 0, 1)
    margin = -setting.overhang + 1.8 * smooth(rng, frame, 14) + 1.2 * smooth(rng, frame, 5)
    cover *= np.clip((near - margin) / 1.2, 0, 1)
    cover *= np.clip(1 - 3 * water, 0, 1)
    evergreen = np.clip(2.5 * (fractal(rng, frame, 60) + rng.normal(-0.5, 0.7)), 0, 1)[..., None]
    color = (1 - evergreen) * _leafy(rng, setting) + evergreen * _needles(rng, setting)
    thick = (
        0.35 + 0.5 * evergreen[..., 0]
        if setting.leafless
        else np.full(frame.shape, 0.9, np.float32)
    )
    if setting.leafless:
        gaps = np.clip(0.75 + 0.5 * streaks(rng, frame, 5, setting.sun), 0.25, 1)
        cover = cover * np.maximum(evergreen[..., 0], np.where(near < 4, gaps, 1))
    return Canopy(
        color.astype(np.float32), cover.astype(np.float32), (cover * thick).astype(np.float32)
    )


def _leafy(rng: np.random.Generator, setting: Setting) -> Layer:
    frame = setting.frame
    base = np.array(setting.palette["wood"], np.float32)
    tone = (
        1 + 0.1 * smooth(rng, frame, 40) + 0.09 * relief(rng, frame, rng.uniform(4, 9), setting.sun)
    )
    if setting.leafless:
        tone += 0.12 * streaks(rng, frame, 9, setting.sun) + 0.1 * relief(
            rng, frame, 2.5, setting.sun
        )
    else:
        tone += 0.12 * relief(rng, frame, rng.uniform(6, 12), setting.sun)
    hue = 0.03 * smooth(rng, frame, 60)[..., None] * np.array([-0.3, 0.3, 1.0], np.float32)
    return np.clip(base * (tone[..., None] + hue), 0.02, 1)


def _needles(rng: np.random.Generator, setting: Setting) -> Layer:
    tone = 1 + 0.25 * relief(rng, setting.frame, rng.uniform(4, 8), setting.sun)
    return np.clip(np.array(setting.palette["evergreen"], np.float32) * tone[..., None], 0.02, 1)


def plant(
    rng: np.random.Generator,
    setting: Setting,
    canopy: Canopy,
    near: Layer,
    water: Layer,
    plan: list[PlannedRoad],
) -> None:
    """Add single trees, some of them in avenues beside the road, in place."""
    frame = setting.frame
    count = rng.poisson(min(900, setting.trees * (frame.extent / 100) ** 2))
    clumps = rng.uniform(0, frame.extent, (max(1, count // 5), 2))
    spots = np.vstack([rng.uniform(0, frame.extent, (count // 2, 2)), np.repeat(clumps, 3, axis=0)])
    spots += rng.normal(0, 9, spots.shape)
    stamps = [stamp(rng, setting, frame.length(radius)) for radius in rng.uniform(1.5, 5.5, 10)]
    for center in spots:
        x, y = frame.pixels(center)
        row, column = np.clip((int(y), int(x)), 0, frame.size - 1)
        if near[row, column] > -setting.overhang and not water[row, column] > 0:
            press(canopy, stamps[int(rng.integers(len(stamps)))], center, setting)
    for road in plan:
        if rng.random() < 0.15 and road.manner == "street":
            side, gap = (
                rng.choice([-1, 1]) * (road.width / 2 + rng.uniform(1, 3)),
                rng.uniform(7, 16),
            )
            for index in range(1, len(road.points) - 2, max(2, int(gap / 2))):
                ahead = road.points[index + 1] - road.points[index - 1]
                across = np.array([-ahead[1], ahead[0]]) / max(1e-9, float(np.hypot(*ahead)))
                at = road.points[index] + across * side + rng.normal(0, 0.5, 2)
                press(canopy, stamps[int(rng.integers(len(stamps)))], at, setting)


def clear_strip(setting: Setting, extras: Extras, canopy: Canopy) -> None:
    """Fell a straight strip through the woods, in place."""
    rng = np.random.default_rng([extras.seed, 2])
    frame = setting.frame
    line = crossing(rng, frame.extent, 1e-4)
    window, cover = ribbon(frame.pixels(line), frame.length(rng.uniform(8, 45)), frame.shape)
    for layer in (canopy.cover, canopy.shade):
        layer[window] *= 1 - cover


def stamp(rng: np.random.Generator, setting: Setting, radius: float) -> tuple[Layer, Layer]:
    """One crown of `radius` pixels: color (k, k, 3) and cover (k, k)."""
    reach = int(np.ceil(radius * 1.3)) + 1
    y, x = np.mgrid[-reach : reach + 1, -reach : reach + 1].astype(np.float32)
    noise = cv2.GaussianBlur(
        rng.standard_normal(x.shape).astype(np.float32), (0, 0), max(0.6, radius / 4)
    )
    noise /= max(float(noise.std()), 1e-6)
    distance = np.hypot(x, y) / max(radius, 0.5) + 0.16 * noise
    bare = setting.leafless and rng.random() < 0.5
    cover = np.clip((1 - distance) * max(2.0, radius), 0, 1) * (
        rng.uniform(0.3, 0.6) if bare else 1.0
    )
    lit = -(x * np.cos(setting.sun) + y * np.sin(setting.sun)) / max(radius, 0.5)
    base = np.array(
        setting.palette["wood" if bare or rng.random() < 0.5 else "evergreen"], np.float32
    )
    tone = np.clip(1 + 0.4 * lit + 0.15 * noise, 0.2, 2) * rng.uniform(0.8, 1.2)
    return np.clip(base * tone[..., None], 0, 1), cover.astype(np.float32)


def press(canopy: Canopy, crown: tuple[Layer, Layer], center: Floats, setting: Setting) -> None:
    """Put a crown into the canopy, in place, at a point in meters."""
    color, cover = crown
    reach, size = cover.shape[0] // 2, setting.frame.size
    x, y = np.round(setting.frame.pixels(center)).astype(int)
    top, left = max(0, y - reach), max(0, x - reach)
    bottom, right = min(size, y + reach + 1), min(size, x + reach + 1)
    if top >= bottom or left >= right:
        return
    there = (slice(top, bottom), slice(left, right))
    here = (slice(top - y + reach, bottom - y + reach), slice(left - x + reach, right - x + reach))
    alpha = cover[here]
    canopy.color[there] += alpha[..., None] * (color[here] - canopy.color[there])
    canopy.cover[there] = np.maximum(canopy.cover[there], alpha)
    canopy.shade[there] = np.maximum(
        canopy.shade[there], alpha * (0.5 if setting.leafless else 0.9)
    )


def thrown(mask: Layer, setting: Setting, height: float) -> Layer:
    """The shadow (h, w) of things `height` meters tall whose cover is `mask`."""
    length = min(60.0, setting.frame.length(height * setting.slant))
    reach = max(1, int(np.ceil(length)))
    kernel = np.zeros((2 * reach + 1, 2 * reach + 1), np.uint8)
    tip = (reach - length * np.cos(setting.sun), reach - length * np.sin(setting.sun))
    cv2.line(kernel, (reach, reach), (round(float(tip[0])), round(float(tip[1]))), 1)
    return cv2.dilate(mask, kernel)
