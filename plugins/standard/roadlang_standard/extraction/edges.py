"""Where the edges of a road are, left and right of its center line: widths, recentering."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from .smoothing import smooth_values

_STEP = 0.25


@dataclass(frozen=True)
class Sides:
    """Distances (n,) in pixels from the center line to the edges, NaN where none is found."""

    left: Floats
    right: Floats

    @property
    def seen(self) -> NDArray[np.bool_]:
        """Where both edges are seen."""
        return np.isfinite(self.left) & np.isfinite(self.right)

    def where(self, good: NDArray[np.bool_]) -> Sides:
        """The same, seen only where `good` (n,)."""
        return Sides(np.where(good, self.left, np.nan), np.where(good, self.right, np.nan))


def sides(
    points: Floats,
    surface: NDArray[np.float32],
    search_radius: float,
    level: float = 0.5,
    closed: bool = False,
) -> Sides:
    """Look along the normals for where the surface (h, w), 0..1, falls through `level`."""
    normal = normals(points, closed)
    away = np.arange(0, search_radius + _STEP, _STEP)
    found = []
    for sign in (1, -1):
        at = (points[:, None] + sign * away[None, :, None] * normal[:, None]).astype(np.float32)
        profile = sampled(surface, at)
        below = profile < level
        below[:, 0] = False
        first = np.argmax(below, axis=1)
        row = np.arange(len(points))
        high, low = profile[row, np.maximum(first - 1, 0)], profile[row, first]
        part = np.clip((high - level) / np.maximum(high - low, 1e-6), 0, 1)
        distance = (first - 1 + part) * _STEP
        found.append(np.where(below.any(axis=1) & (profile[:, 0] >= level), distance, np.nan))
    return Sides(found[0], found[1])


def normals(points: Floats, closed: bool = False) -> Floats:
    """Unit normals (n, 2) of a polyline; a closed one repeats its first point."""
    if closed:
        around = np.vstack([points[-2:-1], points, points[1:2]])
        tangent = (around[2:] - around[:-2]) / 2
    else:
        tangent = np.gradient(points, axis=0)
    tangent = tangent / np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
    return np.column_stack([-tangent[:, 1], tangent[:, 0]])


def sampled(
    surface: NDArray[np.float32], at: NDArray[np.float32], rows: int = 4096
) -> NDArray[np.float32]:
    """The surface (h, w) at points (n, m, 2), so many of them at a time."""
    pieces = [
        cv2.remap(
            surface,
            at[i : i + rows, :, 0],
            at[i : i + rows, :, 1],
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_REPLICATE,
        )
        for i in range(0, len(at), rows)
    ]
    return np.vstack(pieces)


def typical_width(found: Sides) -> float:
    """The median of the measured widths, NaN without any."""
    widths = (found.left + found.right)[found.seen]
    return float(np.median(widths)) if len(widths) else float("nan")


def widths(found: Sides, fallback: float, wavelength: float, closed: bool) -> tuple[Floats, float]:
    """Smoothed widths (n,) and the standard deviation of what was seen about them."""
    typical = typical_width(found)
    if not np.isfinite(typical):
        return np.full(len(found.left), fallback), float("nan")
    raw = found.left + found.right
    good = found.seen & (np.abs(raw - typical) < 0.5 * typical)
    filled = np.where(good, raw, typical)
    even = smooth_values(filled, wavelength, closed, np.where(good, 1.0, 0.02))
    spread = float(np.median(np.abs((raw - even)[good]))) * 1.4826 if good.any() else typical
    return np.maximum(even, 0.2 * typical), spread
