"""Roads whose surfaces overlap where no junction is, and junctions that overlap: faults of the
drawing."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np

from ..cross_section import CrossSection
from ..network import Edge, RoadNetwork
from .model import NO_JUNCTION, Junction, Problem
from .sweeping import TOLERANCE, valid

_SPACING = 2.0
_SHORTEST = 0.1


def overlaps(
    network: RoadNetwork,
    sections: Mapping[int, CrossSection],
    trims: Mapping[int, tuple[float, float]],
    known: Collection[frozenset[int]],
) -> tuple[Problem, ...]:
    """Pairs of roads of one level that overlap between their trims, but for those `known`."""
    import shapely

    edges = sorted(network.edges, key=lambda edge: edge.id)
    surfaces = [_surface(edge, sections[edge.id], trims[edge.id]) for edge in edges]
    present = [place for place, surface in enumerate(surfaces) if surface is not None]
    if len(present) < 2:
        return ()
    tree = shapely.STRtree([surfaces[place] for place in present])
    first, second = tree.query([surfaces[place] for place in present], predicate="intersects")
    problems = []
    for i, j in sorted(zip(first.tolist(), second.tolist(), strict=True)):
        a, b = present[i], present[j]
        ids = edges[a].id, edges[b].id
        if a >= b or frozenset(ids) in known or edges[a].level != edges[b].level:
            continue
        box = shapely.bounds(shapely.intersection(surfaces[a], surfaces[b]))
        along = float(np.hypot(box[2] - box[0], box[3] - box[1]))
        if along < _SHORTEST:
            continue
        problems.append(Problem("overlap", NO_JUNCTION, ids, along))
    return tuple(problems)


def junction_overlaps(junctions: Sequence[Junction]) -> tuple[Problem, ...]:
    """Pairs of junctions whose areas overlap, each by the roads of both that are nearest to it."""
    import shapely

    if len(junctions) < 2:
        return ()
    areas = valid(np.array([shapely.Polygon(j.area) for j in junctions]))
    areas = shapely.buffer(areas, -TOLERANCE)
    tree = shapely.STRtree(areas)
    problems = []
    first, second = tree.query(areas, predicate="intersects")
    for i, j in sorted(zip(first.tolist(), second.tolist(), strict=True)):
        if i >= j:
            continue
        common = shapely.intersection(areas[i], areas[j])
        box = shapely.bounds(common)
        along = float(np.hypot(box[2] - box[0], box[3] - box[1]))
        edge = _nearest_road(junctions[i], common)
        edges = edge, _nearest_road(junctions[j], common, other_than=edge)
        problems.append(Problem("overlap", junctions[i].id, edges, along))
    return tuple(problems)


def _nearest_road(junction: Junction, place: Any, other_than: int | None = None) -> int:
    """The road of a junction whose face is nearest to a place; another one than that, if any."""
    import shapely

    arms = [arm for arm in junction.arms if arm.edge != other_than] or junction.arms
    faces = [
        shapely.linestrings([junction.area[arm.left], junction.area[arm.right]]) for arm in arms
    ]
    return arms[int(np.argmin(shapely.distance(faces, place)))].edge


def _surface(edge: Edge, section: CrossSection, trims: tuple[float, float]) -> Any:
    """The surface of a road between its trims, a little smaller; None if nothing is left."""
    import shapely

    start, stop = trims[0] + TOLERANCE, edge.length - trims[1] - TOLERANCE
    if stop - start < 0.1 or edge.curve.closed:
        return None
    s = np.linspace(start, stop, max(2, int((stop - start) / _SPACING) + 1))
    left, right = (half - TOLERANCE for half in section.half_widths(s))
    points, normal = edge.curve.at(s), edge.curve.normal(s)
    ring = np.concatenate(
        [points + left[:, None] * normal, (points - right[:, None] * normal)[::-1]]
    )
    return valid(shapely.polygons(ring))
