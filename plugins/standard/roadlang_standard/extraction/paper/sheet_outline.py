"""Where a sheet of paper lies on a desk: a light part of the picture with straight sides."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..colors.tones import Image, Layer

_SMALL, _LEVELS = 400, 16
"""The outline is searched in a copy of at most `_SMALL` pixels a side, at `_LEVELS` levels of
gray."""
_LEAST, _MOST = 0.15, 0.97
"""Least and greatest share of the picture that the sheet covers."""
_CORNERS, _BEND = 6, 0.02
"""A sheet cut off by the picture has at most `_CORNERS` corners; its sides bend by less than
`_BEND` of its outline."""
_FILLED = 0.965
"""Least overlap of the sheet with its straight outline."""
_DARKER, _AROUND = 0.85, 0.9
"""The desk is darker than `_DARKER` times the sheet, along at least `_AROUND` of the visible
outline."""
_SEEN = 0.5
"""Least share of the outline that lies within the picture, where the desk is visible."""
_BESIDE, _MARGIN = 4, 2
"""Pixels of the small copy. Sheet and desk are compared `_BESIDE` pixels from the outline;
`_MARGIN` pixels along it are left out, where the sheet curls and casts a shadow."""


def sheet_outline(image: Image) -> Booleans | None:
    """The pixels (h, w) of a light sheet on a darker desk, without its rim; None if the picture
    (h, w, 3) shows no desk."""
    scale = min(1.0, _SMALL / max(image.shape[:2]))
    size = (max(1, round(image.shape[1] * scale)), max(1, round(image.shape[0] * scale)))
    small = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    blue, green, red = cv2.split(cv2.GaussianBlur(small, (0, 0), 1.0))
    least, most = cv2.min(cv2.min(blue, green), red), cv2.max(cv2.max(blue, green), red)
    # Paper is lighter than the desk, or whiter than wood and cloth, in shadows too.
    whiteness = cv2.divide(least, most, scale=255)
    found = [each for gray in (least, whiteness) if (each := _outlined(gray)) is not None]
    if not found:
        return None
    _, corners = max(found, key=lambda each: each[0])
    filled = cv2.fillPoly(np.zeros(least.shape, np.uint8), [corners], 1)
    kernel = np.ones((2 * _MARGIN + 1, 2 * _MARGIN + 1), np.uint8)
    inner = cv2.erode(filled, kernel, borderType=cv2.BORDER_CONSTANT, borderValue=1)
    return np.asarray(cv2.resize(inner, image.shape[1::-1], interpolation=cv2.INTER_NEAREST) > 0)


def _outlined(gray: Image) -> tuple[float, np.ndarray] | None:
    """The outline that best fits a part lighter than the desk around it, as `_at_level`; None
    without. Where the outline is a pixel aside, what is beside it is not the desk yet."""
    low, high = (float(np.quantile(gray, share)) for share in (0.02, 0.98))
    levels = np.unique(np.floor(np.linspace(low, high, _LEVELS + 2)[1:-1]))  # grays are whole
    found = [each for each in (_at_level(gray, level) for level in levels) if each is not None]
    fitting = sorted((each for each in found if each[0] >= _FILLED), key=lambda each: -each[0])
    return next((each for each in fitting if _on_darker_desk(gray, each[1])), None)


def _at_level(gray: Image, level: float) -> tuple[float, np.ndarray] | None:
    """The largest part (h, w) above a level as a polygon of few corners (n, 1, 2), and the share
    that both have in common; None if it has more corners or no sheet's size."""
    outlines, _ = cv2.findContours(
        (gray > level).astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE
    )
    largest = max(outlines, key=cv2.contourArea, default=None)
    if largest is None or not _LEAST < cv2.contourArea(largest) / gray.size < _MOST:
        return None
    hull = cv2.convexHull(largest)
    corners = cv2.approxPolyDP(hull, _BEND * cv2.arcLength(hull, True), True)
    if not 4 <= len(corners) <= _CORNERS:
        return None
    part = cv2.fillPoly(np.zeros(gray.shape, np.uint8), [largest], 1)
    straight = cv2.fillPoly(np.zeros(gray.shape, np.uint8), [corners], 1)
    both, any_ = (cv2.countNonZero(each) for each in (part & straight, part | straight))
    return both / any_, corners


def _on_darker_desk(gray: Image, corners: np.ndarray) -> bool:
    """Whether most of the outline lies within the picture, and what is beyond it is darker."""
    filled = cv2.fillPoly(np.zeros(gray.shape, np.uint8), [corners], 1)
    signed = cv2.distanceTransform(filled, cv2.DIST_L2, 5)
    signed = signed - cv2.distanceTransform(1 - filled, cv2.DIST_L2, 5)
    closed = np.vstack([corners, corners[:1]])[:, 0].astype(float)
    steps = [np.linspace(a, b, 32, endpoint=False) for a, b in pairwise(closed)]
    x, y = np.vstack(steps).T
    slope = np.gradient(signed, axis=1), np.gradient(signed, axis=0)
    inside, outside = (_beside(gray, slope, x, y, side * _BESIDE) for side in (1, -1))
    lengths = np.repeat(np.hypot(*np.diff(closed, axis=0).T), 32)
    rim = np.minimum.reduce([x, y, gray.shape[1] - 1 - x, gray.shape[0] - 1 - y]) < _BESIDE
    seen = np.isfinite(inside) & np.isfinite(outside) & ~rim
    darker = seen & (np.nan_to_num(outside) < _DARKER * np.nan_to_num(inside))
    total = float(lengths[seen].sum())
    return bool(total >= _SEEN * lengths.sum() and lengths[darker].sum() >= _AROUND * total)


def _beside(gray: Image, slope: tuple[Layer, Layer], x: Layer, y: Layer, away: float) -> np.ndarray:
    """The gray (n,) beside points of an outline; NaN beyond the picture. `slope` (h, w) is how much
    farther inside the outline the next pixel is, to the right and below."""
    across, down = slope
    row, column = np.round(y).astype(int), np.round(x).astype(int)
    norm = np.maximum(np.hypot(across[row, column], down[row, column]), 1e-6)
    to_x = np.round(x + away * across[row, column] / norm).astype(int)
    to_y = np.round(y + away * down[row, column] / norm).astype(int)
    there = (to_x >= 0) & (to_y >= 0) & (to_x < gray.shape[1]) & (to_y < gray.shape[0])
    result = np.full(len(x), np.nan)
    result[there] = gray[to_y[there], to_x[there]]
    return result
