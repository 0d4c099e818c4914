"""What a rendering is made of: the frame of the picture, the roads in it, and their truth."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Image = NDArray[np.uint8]
Layer = NDArray[np.float32]

_SUBPIXELS = 4
_SHIFT = 4


@dataclass(frozen=True, slots=True)
class Frame:
    """A square picture of `size` pixels; meters run right and down from its corner."""

    size: int
    meters_per_pixel: float

    @property
    def extent(self) -> float:
        """Side of the pictured square in meters."""
        return self.size * self.meters_per_pixel

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return (self.size, self.size)

    def pixels(self, points: Floats) -> Floats:
        """Meters (n, 2) to pixels, (0, 0) the center of the top-left pixel."""
        return np.asarray(points, float) / self.meters_per_pixel - 0.5

    def length(self, meters: float) -> float:
        """A length in pixels."""
        return meters / self.meters_per_pixel


@dataclass(frozen=True, slots=True)
class PlannedRoad:
    """A road to be painted: center line in meters (n, 2), full width in meters, and its manner."""

    points: Floats
    width: float
    manner: str = "street"
    closed: bool = False


@dataclass(frozen=True, slots=True)
class TrueRoad:
    """A road as it lies in the picture: center line (n, 2) and full width, both in pixels."""

    points: Floats
    width: float
    closed: bool = False


@dataclass(frozen=True)
class Truth:
    """The exact roads of a picture, and what hides them.

    `hidden` is (h, w) bool: a crown covers the pixel or a shadow lies on it.
    """

    shape: tuple[int, int]
    roads: tuple[TrueRoad, ...]
    hidden: NDArray[np.bool_]
    meters_per_pixel: float = 1.0

    def mask(self) -> Image:
        """Road surface, 255 = road, (h, w)."""
        mask = np.zeros(self.shape, np.uint8)
        for road in self.roads:
            window, cover = ribbon(road.points, road.width, self.shape)
            mask[window] = np.maximum(mask[window], (cover > 0.5).astype(np.uint8) * 255)
        return mask

    def polylines(self) -> list[list[list[float]]]:
        """Center lines clipped to the picture, as the scorer reads them."""
        return [
            run.round(3).tolist() for road in self.roads for run in inside(road.points, self.shape)
        ]

    def hidden_share(self) -> float:
        """Share of the center-line length that a crown or a shadow hides."""
        samples = [_dense(np.asarray(line)) for line in self.polylines()]
        if not samples:
            return 0.0
        x, y = np.vstack(samples).round().astype(int).T
        height, width = self.shape
        return float(self.hidden[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)].mean())


@dataclass(frozen=True)
class Rendering:
    """A picture, (h, w, 3) uint8 in OpenCV's channel order, and its truth."""

    image: Image
    truth: Truth


def ribbon(
    points: Floats, width: float, shape: tuple[int, int]
) -> tuple[tuple[slice, slice], Layer]:
    """Coverage 0..1 of a ribbon about a center line (pixels), within the window it touches."""
    reach = width / 2 + 2
    low = np.floor(points.min(axis=0) - reach).astype(int)
    high = np.ceil(points.max(axis=0) + reach).astype(int) + 1
    left, top = np.clip(low, 0, (shape[1], shape[0]))
    right, bottom = np.clip(high, 0, (shape[1], shape[0]))
    window = (slice(top, bottom), slice(left, right))
    if right <= left or bottom <= top:
        return window, np.zeros((max(0, bottom - top), max(0, right - left)), np.float32)
    fine = np.zeros(((bottom - top) * _SUBPIXELS, (right - left) * _SUBPIXELS), np.uint8)
    for patch in _patches(points, width):
        at = (patch - (left, top) + 0.5) * _SUBPIXELS - 0.5
        cv2.fillPoly(fine, [np.round(at * 2**_SHIFT).astype(np.int32)], 255, cv2.LINE_8, _SHIFT)
    cover = cv2.resize(fine, (right - left, bottom - top), interpolation=cv2.INTER_AREA)
    return window, cover.astype(np.float32) / 255


def _patches(points: Floats, width: float, chunk: int = 12) -> list[Floats]:
    """The ribbon as polygons so short that none crosses itself."""
    tangent = np.gradient(points, axis=0)
    tangent /= np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
    normal = np.c_[-tangent[:, 1], tangent[:, 0]] * width / 2
    left, right = points + normal, points - normal
    starts = range(0, max(1, len(points) - 1), chunk)
    return [np.vstack([left[i : i + chunk + 2], right[i : i + chunk + 2][::-1]]) for i in starts]


def inside(points: Floats, shape: tuple[int, int]) -> list[Floats]:
    """The stretches of a line that lie in the picture, at least two points each."""
    x, y = points.T
    within = (x >= -0.5) & (y >= -0.5) & (x <= shape[1] - 0.5) & (y <= shape[0] - 0.5)
    edges = np.flatnonzero(np.diff(np.r_[0, within.astype(int), 0]))
    return [points[a:b] for a, b in edges.reshape(-1, 2) if b - a >= 2]


def _dense(points: Floats) -> Floats:
    steps = np.hypot(*np.diff(points, axis=0).T)
    station = np.r_[0, np.cumsum(steps)]
    at = np.arange(0, station[-1], 1.0)
    return np.c_[np.interp(at, station, points[:, 0]), np.interp(at, station, points[:, 1])]
