"""Small crowns and bushes all over, with their shadows, and the grain of the ground."""

from __future__ import annotations

import cv2
import numpy as np

from training.rendering.extras import Extras
from training.rendering.frame import Layer
from training.rendering.noise import blend, fractal, line_kernel, smooth
from training.rendering.setting import Setting


def overgrow(
    rng: np.random.Generator, setting: Setting, extras: Extras, image: Layer, near: Layer
) -> Layer:
    """Paint grain and thickets into the picture, in place; what hides the ground, 0..1.

    `near` is the distance to the nearest road edge in meters, negative on the road.
    """
    frame = setting.frame
    off_road = np.clip(near / 1.5 + 0.5, 0, 1)
    fine = cv2.GaussianBlur(
        rng.standard_normal(frame.shape).astype(np.float32), (0, 0), rng.uniform(0.5, 1.1)
    )
    fine /= max(float(fine.std()), 1e-6)
    image *= (1 + extras.grain * (0.25 + 0.75 * off_road) * fine)[..., None]
    if extras.thicket == 0:
        return np.zeros(frame.shape, np.float32)
    cover = _crowns(rng, setting, extras, off_road)
    throw = max(1.5, frame.length(rng.uniform(1.0, 5.0) * setting.slant))
    shadow = cv2.filter2D(
        cover, -1, _thrown_kernel(throw, setting.sun), borderType=cv2.BORDER_REFLECT
    )
    image *= 1 - (setting.dusk * np.clip(shadow * 1.6, 0, 1) * (1 - cover))[..., None]
    blend(image, _colors(rng, setting, cover), cover)
    return np.asarray(np.maximum(cover, np.clip(shadow, 0, 1)), np.float32)


def _crowns(rng: np.random.Generator, setting: Setting, extras: Extras, off_road: Layer) -> Layer:
    """Cover (h, w): bumps of noise above a threshold that is lower where more grows."""
    frame = setting.frame
    sigma = max(0.6, frame.length(rng.uniform(0.6, 2.2)))
    bumps = cv2.GaussianBlur(rng.standard_normal(frame.shape).astype(np.float32), (0, 0), sigma)
    bumps /= max(float(bumps.std()), 1e-6)
    bumps = bumps + 0.5 * smooth(rng, frame, rng.uniform(8, 20))
    bumps /= max(float(bumps.std()), 1e-6)
    share = extras.over_roads + off_road * (extras.thicket - extras.over_roads)
    density = _quantile(share) + 0.7 * fractal(rng, frame, rng.uniform(40, 160))
    dense = np.clip((bumps + density) * rng.uniform(1.0, 2.5), 0, 1)
    return np.asarray(dense * rng.uniform(0.55, 1.0), np.float32)


def _quantile(share: Layer) -> Layer:
    """Roughly that of the normal distribution."""
    part = np.clip(share, 0.01, 0.95)
    return np.asarray(4.91 * (part**0.14 - (1 - part) ** 0.14) * 1.2, np.float32)


def _thrown_kernel(length: float, sun: float) -> Layer:
    """Moves what it is applied to along `sun`, drawn out over `length` pixels."""
    reach = int(np.ceil(length))
    kernel = np.zeros((2 * reach + 1, 2 * reach + 1), np.float32)
    line = line_kernel(length, sun)
    middle = line.shape[0] // 2
    x, y = round(length / 2 * np.cos(sun)), round(length / 2 * np.sin(sun))
    top, left = reach - y - middle, reach - x - middle
    rows, columns = (slice(max(0, at), at + line.shape[0]) for at in (top, left))
    part = kernel[rows, columns]
    part += line[: part.shape[0], : part.shape[1]]
    return kernel


def _colors(rng: np.random.Generator, setting: Setting, cover: Layer) -> Layer:
    """Brown, gray or green crowns, lit from one side."""
    frame = setting.frame
    step = max(1.0, frame.length(0.8))
    shift = np.array([[1, 0, step * np.cos(setting.sun)], [0, 1, step * np.sin(setting.sun)]])
    moved = cv2.warpAffine(cover, shift, frame.shape[::-1], borderMode=cv2.BORDER_REFLECT)
    noise = cv2.GaussianBlur(rng.standard_normal(frame.shape).astype(np.float32), (0, 0), 0.7)
    lit = 1 + rng.uniform(0.3, 0.9) * (cover - moved) + rng.uniform(0.2, 0.7) * noise
    green = np.clip(2 * fractal(rng, frame, rng.uniform(10, 60)) + rng.normal(-0.5, 1), 0, 1)
    wood = np.array(setting.palette["wood"], np.float32) * rng.uniform(0.8, 1.8)
    pine = np.array(setting.palette["evergreen"], np.float32) * rng.uniform(0.7, 1.5)
    color = wood + green[..., None] * (pine - wood)
    return np.asarray(np.clip(color * lit[..., None], 0.01, 1), np.float32)
