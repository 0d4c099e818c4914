"""The surface of a junction: stubs of the arms, roads inside and connections, corners rounded."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..arrays import Floats
from ..networks.junction_model import Arm, Point
from .arms import ArmKey, ArmLine, Face
from .connecting import Connected
from .corners import NOSE
from .places import JunctionSite
from .sweeping import road_beyond, strip, stub

_SIMPLIFIED = 1e-3
_ROUND = 0.01
"""Meters between the round curb of a corner and the chords that it is drawn with"""
_SAME = 1e-6
_APRON = 0.5
"""Meters."""


def surface(
    place: JunctionSite,
    found: Connected,
    trims: Mapping[ArmKey, float],
    widths: Sequence[tuple[float, float]],
    inside: Sequence[ArmLine],
) -> Any:
    """The polygon of a place. `inside` has both ends of each road that lies in it.

    The union of all that is driven on, closed by the corner radius within the hull of the faces,
    less the roads beyond the faces: what is subtracted last is never run over.
    """
    import shapely

    parts = [
        stub(arm, trims[arm.key]) if trims[arm.key] > 0.0 else _apron(face)
        for arm, face in zip(found.arms, found.faces, strict=True)
    ]
    parts += [stub(line, min(line.length / 2.0, float(line.s[-1]))) for line in inside]
    parts += [strip(found.fits, row, widths[row]) for row in np.flatnonzero(found.usable).tolist()]
    if len(place.nodes) == 1 and len(found.arms) == 2:
        parts.append(_corner_of_bend(found))
    base = shapely.union_all(parts)
    radii = [corner.radius for corner in place.arms.corners if corner.radius is not None]
    radius = max(radii, default=NOSE)
    rounds = {"quad_segs": _chords_of_quarter(radius)}
    closed = base.buffer(radius, **rounds).buffer(-radius, **rounds)
    if found.faces:
        base = base.union(closed.intersection(_hull_of_faces(found)))
    roads = [road_beyond(arm, trims) for arm in found.arms]
    roads = [road for road in roads if road is not None]
    area = base.difference(shapely.union_all(roads)) if roads else base
    parts = [part for part in shapely.get_parts(area) if part.geom_type == "Polygon"]
    largest = max(parts, key=lambda part: float(part.area))
    return shapely.Polygon(largest.exterior)


def _chords_of_quarter(radius: float) -> int:
    """How many chords stay within the tolerance of a quarter of a circle."""
    return math.ceil(0.25 * math.pi / math.acos(max(0.0, 1.0 - _ROUND / radius)))


def _corner_of_bend(found: Connected) -> Any:
    """What lies between the square ends of two roads that meet at an angle: without it there would
    be a notch at the outside of the bend."""
    import shapely

    corners = [border[0] for arm in found.arms for border in arm.borders(0.0, 1.0)]
    return shapely.MultiPoint(corners).convex_hull


def _apron(face: Face) -> Any:
    """A little of the ground before a road that begins at its node."""
    import shapely

    left, right = face.corner(1), face.corner(-1)
    back = -_APRON * math.cos(face.heading), -_APRON * math.sin(face.heading)
    behind = [(x + back[0], y + back[1]) for x, y in (right, left)]
    return shapely.Polygon([left, right, *behind])


def _hull_of_faces(found: Connected) -> Any:
    import shapely

    corners = [face.corner(side) for face in found.faces for side in (1, -1)]
    return shapely.MultiPoint(corners).convex_hull


def ring_with_faces(
    area: Any, found: Connected, trims: Mapping[ArmKey, float]
) -> tuple[tuple[Point, ...], tuple[Arm, ...], Floats]:
    """The ring of an area with the corners of all faces among its points, the arms with their
    indices, and how far each corner was from the ring, (arms, 2)."""
    import shapely

    simple = area.simplify(_SIMPLIFIED)
    ring = np.asarray(simple.exterior.coords)[:-1]
    if shapely.Polygon(ring).exterior.is_ccw is False:
        ring = ring[::-1]
    points = [(float(x), float(y)) for x, y in ring]
    corners = [(face.corner(1), face.corner(-1)) for face in found.faces]
    gaps = np.array([[_insert(points, corner) for corner in pair] for pair in corners])
    arms = tuple(
        Arm(arm.edge.id, arm.end, trims[arm.key], _nearest(points, left), _nearest(points, right))
        for arm, (left, right) in zip(found.arms, corners, strict=True)
    )
    return tuple(points), arms, gaps.reshape(-1, 2)


def _insert(points: list[Point], corner: Point) -> float:
    """Makes a corner a point of the ring where it is not; how far away the ring was."""
    ring = np.array(points)
    away = np.hypot(*(ring - corner).T)
    near = int(away.argmin())
    if away[near] <= _SAME:
        points[near] = corner
        return float(away[near])
    step = np.roll(ring, -1, axis=0) - ring
    share = ((np.array(corner) - ring) * step).sum(axis=1) / np.maximum(
        (step**2).sum(axis=1), 1e-18
    )
    foot = ring + np.clip(share, 0.0, 1.0)[:, None] * step
    gap = np.hypot(*(foot - corner).T)
    best = int(gap.argmin())
    if gap[best] <= 2.0 * _SIMPLIFIED:
        points.insert(best + 1, corner)
    return float(gap[best])


def _nearest(points: list[Point], corner: Point) -> int:
    return int(np.hypot(*(np.array(points) - corner).T).argmin())
