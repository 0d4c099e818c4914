"""From scenes to training crops: turn, zoom, light, weather, lens; all seeded."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang_standard.extraction.photos.exposure import even_exposure
from training.pool import Scene

CROP = 256
_PEN = 1.4
"""Pixels by which OpenCV draws an anti-aliased thick line wider than told: measured."""


def crop(rng: np.random.Generator, scene: Scene) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """An image (256, 256, 3) RGB float32 in 0..255, targets (2, 128, 128), weight (1, 128, 128)."""
    zoom = rng.uniform(0.7, 1.45) if rng.random() < 0.65 else float(np.exp(rng.uniform(-0.9, 0.9)))
    matrix = _placement(rng, scene, zoom)
    image = scene.image
    if zoom < 0.75:
        image = cv2.resize(image, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
        at = matrix @ np.array([[2, 0, 0.5], [0, 2, 0.5], [0, 0, 1]])
    else:
        at = matrix
    shot = cv2.warpAffine(
        image, at, (CROP, CROP), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT
    )
    inside = cv2.warpAffine(np.ones(scene.image.shape[:2], np.float32), matrix, (CROP, CROP))
    targets = _targets(rng, scene, matrix, zoom)
    shot = _light(rng, shot, targets[0])
    return shot, targets, inside[None, ::2, ::2]


def _placement(rng: np.random.Generator, scene: Scene, zoom: float) -> np.ndarray:
    size = scene.image.shape[0]
    reach = min(size / 2 - 1, 0.5 * CROP / zoom)
    center = rng.uniform(reach, size - reach, 2)
    if rng.random() < 0.6:
        line = scene.lines[rng.integers(len(scene.lines))]
        spot = line[rng.integers(len(line))] + rng.normal(0, 20 / zoom, 2)
        center = np.clip(spot, reach, size - reach)
    angle = rng.uniform(0, 2 * np.pi)
    flip = rng.choice([-1, 1])
    linear = zoom * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    linear = linear @ np.diag([flip, 1]) * np.exp(rng.normal(0, 0.05))
    return np.c_[linear, CROP / 2 - linear @ center]


def _targets(rng: np.random.Generator, scene: Scene, matrix: np.ndarray, zoom: float) -> np.ndarray:
    """Surface and center line (2, 128, 128); the line is exp(-d^2 / 4.5), d in input pixels.

    Thickness is whole pixels, so it is rounded up or down at random: right on average.
    """
    surface = np.zeros((CROP, CROP), np.uint8)
    away = np.full((CROP, CROP), 255, np.uint8)
    for line, width in zip(scene.lines, scene.widths, strict=True):
        at = line @ matrix[:, :2].T + matrix[:, 2]
        reach = width * zoom
        if (at < -reach).all(axis=0).any() or (at > CROP + reach).all(axis=0).any():
            continue
        fixed = [np.round(at * 16).astype(np.int32)]
        thickness = max(1, int(width * zoom - _PEN + rng.random()))
        cv2.polylines(surface, fixed, False, 255, thickness, cv2.LINE_AA, 4)
        cv2.polylines(away, fixed, False, 0, 1, cv2.LINE_8, 4)
    distance = cv2.distanceTransform(away, cv2.DIST_L2, 5)
    heat = np.exp(-(np.minimum(distance, 30) ** 2) / 4.5)
    both = np.stack([surface.astype(np.float32) / 255, heat.astype(np.float32)])
    return both.reshape(2, CROP // 2, 2, CROP // 2, 2).mean(axis=(2, 4))


def _light(rng: np.random.Generator, shot: np.ndarray, surface: np.ndarray) -> np.ndarray:
    image = even_exposure(shot).astype(np.float32)
    if rng.random() < 0.25:
        image = _repave(rng, image, surface)
    if rng.random() < 0.3:
        image = _dapple(rng, image)
    if rng.random() < 0.35:
        image = _tint(rng, image)
    if rng.random() < 0.15:
        image[:] = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)[..., None]
    elif rng.random() < 0.06:
        image = np.ascontiguousarray(image[..., rng.permutation(3)])  # false colors
    if rng.random() < 0.7:
        image = _develop(rng, image)
    image = _lens(rng, image)
    return np.ascontiguousarray(np.clip(image, 0, 255)[..., ::-1], np.float32)


def _develop(rng: np.random.Generator, image: np.ndarray) -> np.ndarray:
    """Gamma, contrast, brightness and the gain of each channel, by one table."""
    tone = 255 * np.linspace(0, 1, 256) ** np.exp(rng.normal(0, 0.25))
    tone = (tone - 115) * rng.uniform(0.55, 1.4) + 115 + rng.normal(0, 15)
    table = np.clip(tone[:, None] * rng.normal(1, 0.06, 3), 0, 255).astype(np.float32)
    plain = np.clip(image, 0, 255).astype(np.uint8)
    return cv2.LUT(cv2.merge([plain]), table[None])


def _repave(rng: np.random.Generator, image: np.ndarray, surface: np.ndarray) -> np.ndarray:
    cover = cv2.GaussianBlur(cv2.resize(surface, (CROP, CROP)), (0, 0), 0.8)[..., None]
    shift = (rng.uniform(-60, 60) + rng.normal(0, 5, 3)).astype(np.float32)
    return image + cover * np.float32(rng.uniform(0.4, 1)) * shift


def _dapple(rng: np.random.Generator, image: np.ndarray) -> np.ndarray:
    cells = int(rng.integers(6, 50))
    field = cv2.resize(
        rng.standard_normal((cells, cells)).astype(np.float32),
        (CROP, CROP),
        interpolation=cv2.INTER_CUBIC,
    )
    shade = np.clip((field - rng.uniform(0.3, 1.5)) * 4, 0, 1)[..., None]
    return image * (1 - np.float32(rng.uniform(0.2, 0.7)) * shade)


def _tint(rng: np.random.Generator, image: np.ndarray) -> np.ndarray:
    hsv = cv2.cvtColor(np.clip(image, 0, 255).astype(np.float32) / 255, cv2.COLOR_BGR2HSV)
    hsv[..., 0] = (hsv[..., 0] + rng.normal(0, 15)) % 360
    hsv[..., 1] = np.clip(hsv[..., 1] * rng.uniform(0.3, 1.4), 0, 1)
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR) * 255


def _lens(rng: np.random.Generator, image: np.ndarray) -> np.ndarray:
    if rng.random() < 0.25:
        image = cv2.GaussianBlur(image, (0, 0), rng.uniform(0.4, 1.8))
    elif rng.random() < 0.4:
        soft = cv2.GaussianBlur(image, (0, 0), rng.uniform(0.7, 1.5))
        image = image + np.float32(rng.uniform(0.3, 2.0)) * (image - soft)
    if rng.random() < 0.4:
        image = image + np.float32(rng.uniform(1, 14)) * rng.standard_normal(
            image.shape, np.float32
        )
    if rng.random() < 0.35:
        plain = np.clip(image, 0, 255).astype(np.uint8)
        _, code = cv2.imencode(".jpg", plain, [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(25, 96))])
        image = cv2.imdecode(code, cv2.IMREAD_COLOR).astype(np.float32)
    return image
