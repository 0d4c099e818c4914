"""Land cover: lawns, fields, woods' floor, water, and the narrow things that are not roads."""

from __future__ import annotations

import cv2
import numpy as np

from training.rendering.frame import Frame, Layer, ribbon
from training.rendering.layouts.curves import crossing, wander
from training.rendering.noise import blend, fractal, smooth, streaks
from training.rendering.setting import Setting


def ground(rng: np.random.Generator, setting: Setting, near: Layer) -> tuple[Layer, Layer]:
    """The bare land (h, w, 3) in 0..1, and where water lies (h, w).

    `near` is the distance to the nearest road edge in meters, negative on the road.
    """
    frame = setting.frame
    image = np.empty((*frame.shape, 3), np.float32)
    image[:] = setting.palette["lawn"]
    soil = np.clip(0.5 * fractal(rng, frame, 60) + rng.normal(-0.3, 0.3), 0, 0.8).astype(np.float32)
    blend(image, setting.palette["soil"], soil)
    for _ in range(0 if setting.plain else rng.poisson(2.5)):
        _field(rng, setting, image)
    image *= (1 + 0.09 * fractal(rng, frame, 40) + 0.05 * fractal(rng, frame, 3, 2))[..., None]
    if setting.plain:
        return image, np.zeros(frame.shape, np.float32)
    water = _water(rng, setting, image, near)
    for _ in range(rng.poisson(1.2)):
        _path(rng, setting, image)
    if rng.random() < 0.2:
        _stream(rng, setting, image)
    if rng.random() < 0.08:
        _railway(rng, setting, image)
    return image, water


def _field(rng: np.random.Generator, setting: Setting, image: Layer) -> None:
    frame = setting.frame
    center, turn = rng.uniform(0, frame.extent, 2), rng.uniform(0, np.pi)
    half = rng.uniform(25, 140, 2)
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half * rng.uniform(0.8, 1.1, (4, 2))
    spin = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    cover = polygon(frame, center + corners @ spin.T)
    base = np.array(setting.palette["field" if rng.random() < 0.7 else "lawn"]) * rng.normal(
        1, 0.15
    )
    rows = _rows(frame, turn, rng.uniform(2.5, 9)) * rng.uniform(0, 0.08)
    texture = 1 + rows + 0.05 * streaks(rng, frame, 12, turn) + 0.06 * smooth(rng, frame, 50)
    blend(image, np.clip(base, 0.05, 1) * texture[..., None], cover * rng.uniform(0.7, 1))
    if rng.random() < 0.4:
        edge = cv2.morphologyEx(cover, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))
        tone = np.array(setting.palette[str(rng.choice(["wood", "soil"]))]) * rng.uniform(0.6, 1.3)
        if rng.random() < 0.4:
            edge = cv2.dilate(edge, np.ones((2, 2), np.uint8))
        blend(image, tuple(np.clip(tone, 0, 1)), edge * rng.uniform(0.3, 0.9))


def _rows(frame: Frame, turn: float, pitch: float) -> Layer:
    y, x = np.mgrid[: frame.size, : frame.size].astype(np.float32) * frame.meters_per_pixel
    return np.sin((x * -np.sin(turn) + y * np.cos(turn)) * (2 * np.pi / pitch)).astype(np.float32)


def polygon(frame: Frame, corners: np.ndarray) -> Layer:
    """Coverage 0..1 of a polygon given in meters."""
    cover = np.zeros(frame.shape, np.uint8)
    cv2.fillPoly(
        cover, [np.round(frame.pixels(corners) * 16).astype(np.int32)], 255, cv2.LINE_AA, 4
    )
    return cover.astype(np.float32) / 255


def _water(rng: np.random.Generator, setting: Setting, image: Layer, near: Layer) -> Layer:
    frame = setting.frame
    if rng.random() > 0.36 - 0.12 * setting.homes:
        return np.zeros(frame.shape, np.float32)
    level = fractal(rng, frame, rng.uniform(150, 600)) + np.clip(12 - near, 0, 40) * 0.2
    depth = -(level + rng.uniform(0.6, 1.6))
    water = np.clip(depth * 12, 0, 1).astype(np.float32)
    if rng.random() < 0.65:
        rim = rng.uniform(0.03, 0.15)
        sand = np.clip(1.5 - np.abs(depth + rim) / rim * rng.uniform(1, 1.6), 0, 1)
        tone = np.clip(np.array(setting.palette["soil"]) * rng.uniform(0.9, 1.5), 0, 1)
        blend(image, tuple(tone), (sand * rng.uniform(0.5, 1)).astype(np.float32))
    if rng.random() < 0.5:
        _shore(rng, setting, image, water)
    ripple = 1 + 0.06 * streaks(rng, frame, 6, rng.uniform(0, np.pi)) + 0.1 * smooth(rng, frame, 90)
    blend(image, np.array(setting.palette["water"], np.float32) * ripple[..., None], water)
    return water


def _shore(rng: np.random.Generator, setting: Setting, image: Layer, water: Layer) -> None:
    """A pale strip of even width along the water, which looks like a road from above."""
    frame = setting.frame
    dry = (water < 0.5).astype(np.uint8)
    if dry.all() or not dry.any():
        return
    away = cv2.distanceTransform(dry, cv2.DIST_L2, 5) * frame.meters_per_pixel
    ragged = 1 + 0.25 * smooth(rng, frame, rng.uniform(10, 40))
    gap, width = rng.choice([0.0, rng.uniform(0, 8)]), rng.uniform(2.5, 14) * ragged
    strip = np.clip((away - gap) * 0.8 + 0.5, 0, 1) * np.clip(
        (gap + width - away) * 0.8 + 0.5, 0, 1
    )
    gray, sand = np.full(3, rng.uniform(0.4, 0.8)), np.array(setting.palette["soil"])
    tone = np.clip(gray if rng.random() < 0.5 else sand * rng.uniform(0.9, 1.5), 0, 1)
    blend(image, tuple(tone), (strip * rng.uniform(0.4, 1)).astype(np.float32))


def _line(
    image: Layer, frame: Frame, points: np.ndarray, width: float, color: np.ndarray, cover: float
) -> None:
    window, alpha = ribbon(frame.pixels(points), frame.length(width), frame.shape)
    blend(image[window], tuple(np.clip(color, 0, 1)), alpha * cover)


def _path(rng: np.random.Generator, setting: Setting, image: Layer) -> None:
    frame = setting.frame
    start = rng.uniform(0, frame.extent, 2)
    points = wander(rng, start, rng.uniform(0, 2 * np.pi), rng.uniform(60, 300), 1.2e-2)
    color = np.array(setting.palette["soil"]) * rng.uniform(0.8, 1.3)
    _line(image, frame, points, rng.uniform(0.8, 2.4), color, rng.uniform(0.3, 0.8))


def _stream(rng: np.random.Generator, setting: Setting, image: Layer) -> None:
    points = crossing(rng, setting.frame.extent, 1.2e-2)
    color = np.array(setting.palette["water"]) * rng.uniform(0.6, 1.2)
    _line(image, setting.frame, points, rng.uniform(1.5, 8), color, rng.uniform(0.5, 1))


def _railway(rng: np.random.Generator, setting: Setting, image: Layer) -> None:
    points = crossing(rng, setting.frame.extent, 8e-4)
    _line(
        image, setting.frame, points, 5.0, np.array([0.36, 0.4, 0.42]) * rng.uniform(0.8, 1.3), 0.85
    )
    _line(image, setting.frame, points, 1.4, np.array([0.25, 0.3, 0.36]), 0.6)
