"""Pictures that say where on Earth they are: of square pixels, with a known origin."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, Diagnostic, Span, diagnose
from ..geometry.arrays import Floats
from ..geometry.earth.earth_grids import ToDegrees, to_degrees
from ..geometry.earth.local_projection import LocalProjection
from ..geometry.earth.pixel_map import PixelMap
from .georeference import Georeference
from .image_scale import FoundScale

Pixels = NDArray[np.uint8]

_LEAST_TURN = 0.5
"""Pixels by which a picture may be off north, or off square, and is still taken as it is."""
MOST_PIXELS = 100_000_000
"""Of a picture that is read, and of one that is turned to the north."""
_NEAR = 10_000.0
"""Meters from (0, 0) up to which a plan may be of no grid at all."""
_NO_GRID = "its coordinate system is not known: add a `.prj` file, or `origin`"


@dataclass(frozen=True, eq=False)
class PlacedPixels:
    """`pixels` that are square on the ground; `scale`: meters per pixel, where known; `origin`:
    latitude and longitude in degrees of the lower left corner of what they lie in, where known;
    `warning`: why it is not; `file`: the pixels in their file, if they were drawn anew to be
    square; `north_up`: in the upright rectangle around them, if up is not north."""

    pixels: Pixels
    scale: float | None
    origin: tuple[float, float] | None = None
    warning: Diagnostic | None = None
    file: PixelMap | None = None
    north_up: PixelMap | None = None


def placed(
    pixels: Pixels,
    found: FoundScale | None,
    written: str,
    span: Span | None,
    fault: str | None = None,
) -> PlacedPixels:
    """A picture and how it lies on Earth, where something says that.

    One whose pixels are not square, as those of degrees are not, or that is mirrored, is drawn
    anew. `written` is its path in the scene; `fault` is what is wrong with a world file that
    cannot be used, if there is one.
    """
    if found is None or found.reference is None:
        scale = None if found is None else found.meters
        warning = None if fault is None or scale is not None else _unknown(written, span, fault)
        return PlacedPixels(pixels, scale, None, warning)
    reference = found.reference
    if not reference.grid:
        warning = _unknown(written, span, _NO_GRID) if _is_far(reference) else None
        return PlacedPixels(pixels, found.meters, None, warning)
    degrees, reason = _to_degrees(reference.grid)
    if degrees is None:
        return PlacedPixels(pixels, found.meters, None, _unknown(written, span, reason))
    height, width = pixels.shape[:2]
    try:
        return _squared(pixels, _Frame.of(reference, degrees, width, height))
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
    is_code = grid.startswith("EPSG:")
    name = f"its coordinate system {grid}" if is_code else "the coordinate system beside it"
    try:
        import pyproj
    except ImportError:
        return None, f'{name} needs `pyproj`: pip install "roadlang[maps]"'
    try:
        transformer = pyproj.Transformer.from_crs(grid, "EPSG:4326", always_xy=True)
    except pyproj.exceptions.ProjError:
        return None, f"{name} is not known to `pyproj`"

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


def _squared(pixels: Pixels, frame: _Frame) -> PlacedPixels:
    """Each pixel as wide as high, and not mirrored."""
    import cv2

    right, up = frame.sides
    wide, high = float(np.hypot(*right)), float(np.hypot(*up))
    if not min(wide, high) > 0.0:
        raise ValueError("without area")
    is_mirrored = right[0] * up[1] < right[1] * up[0]
    stretched = abs(wide - high) * max(frame.width, frame.height)
    if not is_mirrored and stretched < _LEAST_TURN * min(wide, high):
        return _turned(pixels, frame)
    side = min(wide, high)
    columns, rows = round(frame.width * wide / side), round(frame.height * high / side)
    if columns * rows > MOST_PIXELS:
        raise ValueError("too large")
    across, down = frame.width / columns, frame.height / rows
    matrix = (across, 0.0, (across - 1.0) / 2.0, 0.0, down, (down - 1.0) / 2.0)
    corners = frame.corners
    if is_mirrored:
        matrix = (*matrix[:4], -down, frame.height - 1.0 - matrix[5])
        pixels, corners = np.flipud(pixels), corners[[2, 3, 0, 1]]
    drawn = np.asarray(cv2.resize(pixels, (columns, rows), interpolation=cv2.INTER_LINEAR))
    square = _Frame(frame.origin, corners, columns, rows)
    return replace(_turned(drawn, square), file=PixelMap(matrix, frame.width, frame.height))


def _turned(pixels: Pixels, frame: _Frame) -> PlacedPixels:
    """Square pixels, in the upright rectangle around them where up is not north."""
    right, up = frame.sides
    scale = math.sqrt(abs(float(right[0] * up[1] - right[1] * up[0])))
    projection = LocalProjection(*frame.origin)
    size = np.array([frame.width, frame.height])
    # How far a corner is off, in pixels, if the picture is taken as it is.
    off = np.stack([right / scale - (1.0, 0.0), up / scale - (0.0, 1.0)]) * size[:, None]
    if np.abs(off).sum() < _LEAST_TURN:
        west, south = frame.corners[0].tolist()
        return PlacedPixels(pixels, scale, projection.place(west, south))
    low, high = frame.corners.min(axis=0), frame.corners.max(axis=0)
    columns, rows = (int(count) for count in np.ceil((high - low) / scale))
    # From the middle of a pixel to where it is, and from there to the upright rectangle.
    first = frame.corners[2] + (right - up) / 2.0 - low
    across, down = right / scale, -up / scale
    x, y = first / scale
    matrix = (across[0], down[0], x - 0.5, -across[1], -down[1], rows - y - 0.5)
    a, b, c, d, e, f = map(float, matrix)
    upright = PixelMap((a, b, c, d, e, f), columns, rows)
    origin = projection.place(float(low[0]), float(low[1]))
    return PlacedPixels(pixels, scale, origin, north_up=upright)
