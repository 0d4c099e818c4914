"""Pictures that say where on Earth they are: north up, of square pixels, with a known origin."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, Diagnostic, Span, diagnose
from ..geometry.arrays import Floats
from ..geometry.earth_grids import ToDegrees, to_degrees
from ..geometry.local_projection import LocalProjection
from .border_color import border_color
from .georeference import Georeference
from .image_scale import FoundScale

Pixels = NDArray[np.uint8]

_LEAST_TURN = 0.5
"""Pixels by which a picture may be off north or off square before it is drawn anew."""
_MOST_PIXELS = 100_000_000
_NEAR = 10_000.0
"""Meters from (0, 0) up to which a plan may be of no grid at all."""
_NO_GRID = "nothing says in which grid its coordinates are; write a `.prj` file, or `origin`"


@dataclass(frozen=True, eq=False)
class PlacedPixels:
    """`pixels` with north up; `scale`: meters per pixel, where known; `origin`: latitude and
    longitude in degrees of their lower left corner, where known; `warning`: why it is not."""

    pixels: Pixels
    scale: float | None
    origin: tuple[float, float] | None = None
    warning: Diagnostic | None = None


def placed(
    pixels: Pixels, found: FoundScale | None, written: str, span: Span | None
) -> PlacedPixels:
    """A picture as it lies on Earth; as it is, where nothing says that.

    One that is turned, or whose pixels are not square, as those of degrees are not, is drawn anew;
    what it does not show has the usual color of its border. `written` is its path in the scene.
    """
    if found is None or found.reference is None:
        return PlacedPixels(pixels, None if found is None else found.meters)
    reference = found.reference
    if not reference.grid:
        warning = _unknown(written, span, _NO_GRID) if _is_far(reference) else None
        return PlacedPixels(pixels, found.meters, None, warning)
    degrees, reason = _to_degrees(reference.grid)
    if degrees is None:
        return PlacedPixels(pixels, found.meters, None, _unknown(written, span, reason))
    height, width = pixels.shape[:2]
    try:
        return _drawn(pixels, _Frame.of(reference, degrees, width, height))
    except (ArithmeticError, ValueError):
        warning = _unknown(written, span, "its coordinates are not on Earth")
        return PlacedPixels(pixels, found.meters, None, warning)


def _is_far(reference: Georeference) -> bool:
    """Whether it is of some grid. Plans whose scale alone is known have their corner near 0."""
    return max(map(abs, reference.at(0.0, 0.0))) > _NEAR


def _unknown(written: str, span: Span | None, reason: str) -> Diagnostic:
    path = None if span is not None else written
    return diagnose(Code.UNKNOWN_PLACE_OF_IMAGE, span, path=path, file=written, reason=reason)


def _to_degrees(grid: str) -> tuple[ToDegrees | None, str]:
    """From coordinates of a grid to latitude and longitude, or why not."""
    known = to_degrees(int(grid[5:])) if grid.startswith("EPSG:") else None
    if known is not None:
        return known, ""
    name = grid if grid.startswith("EPSG:") else "of its .prj file"
    try:
        import pyproj
    except ImportError:
        return None, f'its grid {name} needs `pyproj`: pip install "roadlang[maps]"'
    try:
        transformer = pyproj.Transformer.from_crs(grid, "EPSG:4326", always_xy=True)
    except pyproj.exceptions.CRSError:
        return None, f"its grid {name} is not known to `pyproj`"

    def degrees(x: float, y: float) -> tuple[float, float]:
        longitude, latitude = transformer.transform(x, y)
        return float(latitude), float(longitude)

    return degrees, ""


@dataclass(frozen=True, eq=False)
class _Frame:
    """`corners` (4, 2): meters east and north of the first, of the lower left, lower right, upper
    left and upper right corner of a picture; the first is at `origin`."""

    origin: tuple[float, float]
    corners: Floats
    width: int
    height: int

    @classmethod
    def of(cls, reference: Georeference, degrees: ToDegrees, width: int, height: int) -> _Frame:
        """Raises ValueError for what is not on Earth."""
        places = [
            degrees(*reference.at(column, row)) for row in (height, 0) for column in (0, width)
        ]
        if not all(abs(lat) < 89.0 and abs(lon) <= 360.0 for lat, lon in places):
            raise ValueError("not on Earth")
        projection = LocalProjection(*places[0])
        corners = np.array([projection.point(*place) for place in places])
        if not np.abs(corners).max() < 1e6:
            raise ValueError("too large for a map of a plane")
        return cls(places[0], corners, width, height)

    @property
    def sides(self) -> tuple[Floats, Floats]:
        """(2,) meters by which a pixel goes to the right, and one up."""
        lower_left, lower_right, upper_left, upper_right = self.corners
        right = (lower_right - lower_left + upper_right - upper_left) / (2.0 * self.width)
        up = (upper_left - lower_left + upper_right - lower_right) / (2.0 * self.height)
        return right, up


def _drawn(pixels: Pixels, frame: _Frame) -> PlacedPixels:
    import cv2

    right, up = frame.sides
    scale = math.sqrt(abs(float(right[0] * up[1] - right[1] * up[0])))
    if not scale > 0.0:
        raise ValueError("without area")
    size = np.array([frame.width, frame.height])
    # How far a corner is off, in pixels, if the picture is taken as it is.
    off = np.stack([right / scale - (1.0, 0.0), up / scale - (0.0, 1.0)]) * size[:, None]
    if np.abs(off).sum() < _LEAST_TURN:
        return PlacedPixels(pixels, scale, frame.origin)
    scale = min(float(np.hypot(*right)), float(np.hypot(*up)))
    low, high = frame.corners.min(axis=0), frame.corners.max(axis=0)
    columns, rows = (int(count) for count in np.ceil((high - low) / scale))
    if columns * rows > _MOST_PIXELS:
        raise ValueError("too large")
    # From the middle of a pixel to where it is, and from there to the middle of a new one.
    first = frame.corners[2] + (right - up) / 2.0 - low
    across, down = right / scale, -up / scale
    x, y = first / scale
    matrix = np.array([[across[0], down[0], x - 0.5], [-across[1], -down[1], rows - y - 0.5]])
    drawn = cv2.warpAffine(pixels, matrix, (columns, rows), flags=cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_CONSTANT, borderValue=border_color([pixels]))  # fmt: skip
    origin = LocalProjection(*frame.origin).place(float(low[0]), float(low[1]))
    return PlacedPixels(np.asarray(drawn, np.uint8), scale, origin)
