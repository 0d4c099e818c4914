"""The surface of a scene's roads, seen from above, in pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.api import Code, DiagnosticError, diagnose
from roadlang.geometry import Floats

from .surfaces.junction_surface import junction_surfaces
from .surfaces.road_surface import road_surfaces

if TYPE_CHECKING:
    from roadlang.api import Scene

MOST_PIXELS = 16384
_TOLERANCE = 0.02
"""Meters by which chords may be off the edges of roads."""
_FRACTION_BITS = 6
"""Of a pixel, in which OpenCV draws."""


@dataclass(frozen=True)
class RoadMask:
    """`pixels` (h, w) are 255 on roads, north up; `left`, `bottom` is the corner in meters."""

    pixels: NDArray[np.uint8]
    scale: float
    left: float
    bottom: float

    def png(self) -> bytes:
        """As a gray picture."""
        return bytes(cv2.imencode(".png", self.pixels)[1])

    def world_file(self) -> str:
        """Meters a pixel east and south, and the center of the first pixel (ESRI world file)."""
        half = self.scale / 2
        top = self.bottom + self.scale * self.pixels.shape[0]
        numbers = (self.scale, 0.0, 0.0, -self.scale, self.left + half, top - half)
        return "".join(f"{number:.10g}\n" for number in numbers)


def road_mask(scene: Scene, scale: float, margin: float) -> RoadMask:
    """The mask of the roads and junctions that are built, `scale` meters a pixel.

    Raises DiagnosticError RL480 where a side would have more than `MOST_PIXELS` pixels.
    """
    shapes = list(_shapes(scene))
    points = np.concatenate(shapes)
    low, high = points.min(axis=0) - margin, points.max(axis=0) + margin
    left, bottom = np.floor(low / scale) * scale
    width, height = (int(n) for n in np.ceil((high - (left, bottom)) / scale))
    if max(width, height) > MOST_PIXELS:
        coarsest = float(max(high - low)) / MOST_PIXELS
        raise DiagnosticError(
            diagnose(
                Code.INVALID_OPTION,
                option="scale",
                kind="emit road_mask",
                reason=f"gives a picture of {width} x {height} pixels",
                help=f"set it to {coarsest:.2g}m/px or more",
            )
        )
    pixels = np.zeros((height, width), np.uint8)
    for shape in shapes:
        at = (shape - (left, bottom)) / scale
        at[:, 1] = height - at[:, 1]
        corners = np.round((at - 0.5) * 2**_FRACTION_BITS).astype(np.int32)
        cv2.fillPoly(pixels, [corners], 255, cv2.LINE_8, _FRACTION_BITS)
    return RoadMask(pixels, scale, float(left), float(bottom))


def _shapes(scene: Scene) -> list[Floats]:
    """Rings (n, 2): junctions, and roads from one station to the next."""
    shapes = [junction.ring[:, :2] for junction in junction_surfaces(scene)]
    for road in road_surfaces(scene, _TOLERANCE):
        a, b = road.borders[0, :, :2], road.borders[-1, :, :2]
        shapes += list(np.stack((a[:-1], a[1:], b[1:], b[:-1]), axis=1))
    return shapes
