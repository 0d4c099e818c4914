"""Drawings on paper as a camera sees them: unevenly lit, noisy, maybe ruled."""

from __future__ import annotations

import cv2
import numpy as np

_SHAPE = (360, 480)
INK = (70, 40, 30)
RULING = (215, 180, 150)


def wave() -> np.ndarray:
    """A line (n, 2) across the sheet, pixels."""
    x = np.linspace(40, 440, 200)
    return np.column_stack([x, 180 + 70 * np.sin(x / 70)])


def sheet() -> np.ndarray:
    """Blank paper (h, w, 3) BGR."""
    return np.full((*_SHAPE, 3), (236, 240, 240), np.uint8)


def drawn(
    image: np.ndarray, line: np.ndarray, pen: int = 3, color: tuple[int, ...] = INK
) -> np.ndarray:
    """The line on the image."""
    points = np.round((line + 0.5) * 16 - 8).astype(np.int32)
    return np.asarray(cv2.polylines(image.copy(), [points], False, color, pen, cv2.LINE_AA, 4))


def ruled(image: np.ndarray, squared: bool = False) -> np.ndarray:
    """The sheet with printed lines, slightly turned."""
    image = image.copy()
    for k in range(-2, 20):
        cv2.line(image, (0, 24 * k), (480, 24 * k + 14), RULING, 1, cv2.LINE_AA)
        if squared:
            cv2.line(image, (24 * k, 0), (24 * k - 10, 360), RULING, 1, cv2.LINE_AA)
    return image


def photographed(image: np.ndarray, seed: int = 1) -> np.ndarray:
    """The sheet in light that falls off to one side, with a shadow across it, and noise."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[: _SHAPE[0], : _SHAPE[1]]
    light = 1 - 0.35 * x / _SHAPE[1] - 0.25 / (1 + np.exp(-(x - 250 + 0.5 * y) / 12))
    lit = image * light[..., None] + rng.normal(0, 3, (*_SHAPE, 1))
    return np.asarray(np.clip(lit, 0, 255), np.uint8)


def overexposed(image: np.ndarray, seed: int = 1) -> np.ndarray:
    """The sheet in bright light, warm at one side, with the shade of a hand, and noise; as JPEG."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[: _SHAPE[0], : _SHAPE[1]]
    hand = cv2.GaussianBlur(((x > 330) & (y > 230)).astype(np.float32), (0, 0), 8)
    light = np.repeat((1.25 - 0.45 * hand)[..., None], 3, axis=2)
    light[..., 0] -= 0.3 * np.clip(1 - x / 150, 0, 1)
    lit = np.clip(image * light + rng.normal(0, 2.5, (*_SHAPE, 1)), 0, 255).astype(np.uint8)
    coded = cv2.imencode(".jpg", lit, [cv2.IMWRITE_JPEG_QUALITY, 88])[1]
    return np.asarray(cv2.imdecode(coded, cv2.IMREAD_COLOR))


def on_desk(image: np.ndarray, desk: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray]:
    """The sheet on a desk of this color, seen at an angle, and the homography (3, 3) to there."""
    height, width = image.shape[:2]
    sheet_corners = np.array([[0, 0], [width, 0], [width, height], [0, height]], np.float32)
    seen = np.array([[60, 50], [430, 35], [460, 330], [25, 345]], np.float32)
    homography = cv2.getPerspectiveTransform(sheet_corners, seen)
    rng = np.random.default_rng(3)
    around = np.clip(rng.normal(0, 3, image.shape) + desk, 0, 255).astype(np.uint8)
    cv2.circle(around, (20, 20), 30, (250, 250, 250), -1, cv2.LINE_AA)
    size = (width, height)
    covered = cv2.warpPerspective(np.full(image.shape, 255, np.uint8), homography, size)
    paper = cv2.warpPerspective(image, homography, size)
    return np.where(covered > 127, paper, around), homography
