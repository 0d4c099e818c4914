"""The areas of junctions, what is painted there and at crosswalks, and signals."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import PAINT_HEIGHT, crosswalk_paint, junction_paint, paint_rings
from roadlang.geometry import Floats

from ..surfaces.heights import SceneHeights
from ..surfaces.junction_surface import JunctionSurface
from .meshes import Faces, strip
from .solids import box

if TYPE_CHECKING:
    from roadlang.api import Scene

_UP = np.array([0.0, 0.0, 1.0])
_POLE = 3.6
"""Height of a set of lights, meters."""


def area_part(surface: JunctionSurface) -> Faces | None:
    """The paved area."""
    if not len(surface.triangles):
        return None
    normals = np.tile(_UP, (len(surface.ring), 1))
    return Faces("asphalt", surface.ring, normals, surface.triangles, surface.ring[:, :2])


def edge_parts(surface: JunctionSurface, ground: float) -> Iterator[Faces | None]:
    """The sides of the area down to the ground, which lies at this height."""
    ring = surface.ring
    for first, second in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        top = np.stack((first, second))
        foot = np.column_stack((top[:, :2], (ground, ground)))
        step = second - first
        length = float(np.hypot(step[0], step[1]))
        if length > 0.0:
            out = np.array([step[1], -step[0], 0.0]) / length
            yield strip("embankment", top, foot, out)


def paint_parts(scene: Scene, surface: JunctionSurface) -> Iterator[Faces]:
    """Stop lines, arrows and zebra crossings."""
    for ring in paint_rings(junction_paint(scene, [surface.junction])):
        yield _painted(ring, _heights(surface, ring))


def crosswalk_parts(scene: Scene, heights: SceneHeights) -> Iterator[Faces]:
    """The stripes of crosswalks."""
    for ring in paint_rings(crosswalk_paint(scene)):
        yield _painted(ring, heights.at(ring))


def _painted(ring: Floats, heights: Floats) -> Faces:
    points = np.column_stack((ring, heights + PAINT_HEIGHT))
    last = np.arange(2, len(ring))
    fan = np.column_stack((np.zeros(len(last), int), last - 1, last))
    return Faces("paint", points, np.tile(_UP, (len(ring), 1)), fan)


def signal_parts() -> Iterator[Faces]:
    """A set of lights that looks toward -x, where the traffic comes from that it is for."""
    yield box("metal", (-0.06, -0.06, 0.0), (0.06, 0.06, _POLE))
    yield box("tire", (-0.2, -0.17, _POLE - 1.05), (-0.06, 0.17, _POLE))
    for place, light in enumerate(("red", "yellow", "green")):
        middle = _POLE - 0.2 - 0.32 * place
        low, high = (-0.22, -0.1, middle - 0.1), (-0.2, 0.1, middle + 0.1)
        yield box(f"{light} light", low, high)


def _heights(surface: JunctionSurface, points: Floats) -> Floats:
    """(n,) of the area at points (n, 2) in it or near its edge: those of the nearest corners."""
    if not surface.ring[:, 2].any():
        return np.zeros(len(points))
    away = np.linalg.norm(points[:, None] - surface.ring[None, :, :2], axis=2)
    return np.asarray(surface.ring[away.argmin(axis=1), 2])
