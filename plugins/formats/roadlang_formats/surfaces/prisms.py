"""Roads and junctions as convex prisms, for engines that collide with convex shapes alone."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from roadlang.api import CURB_HEIGHT
from roadlang.geometry import Floats

from .junction_surface import JunctionSurface
from .road_surface import RoadSurface

THICKNESS = 0.5
"""Meters from the top of a road to its bottom."""
_LEAST_AREA = 1e-3
"""Square meters of a prism seen from above, below which it is left out."""
_STRAIGHT = 1e-9
"""Square meters by which a corner may turn the wrong way and still be straight."""


def road_prisms(
    surface: RoadSurface, thickness: float = THICKNESS
) -> Iterator[tuple[Floats, bool]]:
    """The corners (8, 3) of a prism for each span between stations, and whether it is raised: one
    for all neighboring lanes of the same height. Its top is the surface, `thickness` meters above
    its bottom."""
    raised = [lane.raised for lane in surface.section.lanes]
    changes = [place for place in range(1, len(raised)) if raised[place] != raised[place - 1]]
    for first, last in pairwise((0, *changes, len(raised))):
        lift = CURB_HEIGHT if raised[first] else 0.0
        left, right = surface.borders[first], surface.borders[last]
        for at in range(len(left) - 1):
            ring = np.stack((right[at], right[at + 1], left[at + 1], left[at]))
            if _area(ring) > _LEAST_AREA:
                yield _prism(ring, lift, thickness), raised[first]


def junction_prisms(surface: JunctionSurface, thickness: float = THICKNESS) -> Iterator[Floats]:
    """The corners (2 k, 3) of prisms over convex polygons with k corners."""
    for polygon in convex_parts(surface.ring, surface.triangles.tolist()):
        ring = surface.ring[polygon]
        if _area(ring) > _LEAST_AREA:
            yield _prism(ring, 0.0, thickness)


def convex_parts(points: Floats, triangles: list[list[int]]) -> list[list[int]]:
    """Few convex polygons, counter-clockwise, made by joining triangles (Hertel and Mehlhorn,
    1983). `points` (n, 3) lie nearly in a plane."""
    parts = [list(triangle) for triangle in triangles]
    if np.ptp(points[:, 2]) > 0.05:
        return parts  # on a slope, polygons of many corners are not flat
    joined = True
    while joined:
        joined = False
        edges = {(a, b): k for k, part in enumerate(parts) for a, b in _edges(part)}
        for (a, b), k in edges.items():
            other = edges.get((b, a))
            if other is None or other == k:
                continue
            union = _union(parts[k], parts[other], a, b)
            if _is_convex(points[union]):
                parts[k] = union
                del parts[other]
                joined = True
                break
    return parts


def _edges(part: list[int]) -> Iterator[tuple[int, int]]:
    yield from zip(part, (*part[1:], part[0]), strict=True)


def _union(part: list[int], other: list[int], a: int, b: int) -> list[int]:
    """Two polygons that share the edge from `a` to `b`, which the second has the other way."""
    at, to = part.index(b), other.index(a)
    return [*part[at:], *part[:at]][:-1] + [*other[to:], *other[:to]][:-1]


def _is_convex(ring: Floats) -> bool:
    step = np.roll(ring, -1, axis=0)[:, :2] - ring[:, :2]
    after = np.roll(step, -1, axis=0)
    turns = step[:, 0] * after[:, 1] - step[:, 1] * after[:, 0]
    return bool((turns > -_STRAIGHT).all())


def _area(ring: Floats) -> float:
    x, y = ring[:, 0], ring[:, 1]
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def _prism(ring: Floats, lift: float, thickness: float) -> Floats:
    up = np.array([0.0, 0.0, 1.0])
    return np.concatenate((ring + lift * up, ring + (lift - thickness) * up))
