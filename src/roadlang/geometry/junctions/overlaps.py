"""Roads whose surfaces overlap where no junction is, and junctions that overlap: faults of the
drawing, or roads on different levels."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from ..areas.levels import are_apart
from ..lanes.cross_section import CrossSection
from ..networks.junction_model import NO_JUNCTION, Junction, Problem
from ..networks.network import Edge, RoadNetwork
from .sweeping import TOLERANCE, valid

_SPACING = 2.0
_SHORTEST = 0.1


def overlaps(
    network: RoadNetwork,
    sections: Mapping[int, CrossSection],
    trims: Mapping[int, tuple[float, float]],
    known: Collection[frozenset[int]],
) -> tuple[Problem, ...]:
    """Pairs of roads that overlap between their trims, but for those `known`; those that lie on
    different levels pass above one another."""
    problems = []
    for a, b, common in _overlapping(network, sections, trims):
        ids = a.id, b.id
        above = a.level != b.level
        if frozenset(ids) in known and not above:
            continue
        problems.append(Problem("level" if above else "overlap", NO_JUNCTION, ids, _extent(common)))
    return tuple(problems)


def passing_above(
    network: RoadNetwork,
    sections: Mapping[int, CrossSection],
    trims: Mapping[int, tuple[float, float]],
) -> tuple[Problem, ...]:
    """Pairs of roads of a map with heights of which one passes above the other."""
    if all(edge.elevations is None for edge in network.edges):
        return ()
    return tuple(
        Problem("level", NO_JUNCTION, (a.id, b.id), _extent(common))
        for a, b, common in _overlapping(network, sections, trims)
        if are_apart(_height(a, common), _height(b, common))
    )


def _overlapping(
    network: RoadNetwork,
    sections: Mapping[int, CrossSection],
    trims: Mapping[int, tuple[float, float]],
) -> Iterator[tuple[Edge, Edge, Any]]:
    """Pairs of roads that overlap between their trims, and what they have in common."""
    import shapely

    edges = sorted(network.edges, key=lambda edge: edge.id)
    surfaces = [_surface(edge, sections[edge.id], trims[edge.id]) for edge in edges]
    present = [place for place, surface in enumerate(surfaces) if surface is not None]
    if len(present) < 2:
        return
    tree = shapely.STRtree([surfaces[place] for place in present])
    first, second = tree.query([surfaces[place] for place in present], predicate="intersects")
    for i, j in sorted(zip(first.tolist(), second.tolist(), strict=True)):
        if i >= j:
            continue
        a, b = present[i], present[j]
        common = shapely.intersection(surfaces[a], surfaces[b])
        if _extent(common) >= _SHORTEST:
            yield edges[a], edges[b], common


def _extent(shape: Any) -> float:
    """Meters across the box around a shape."""
    import shapely

    box = shapely.bounds(shape)
    return float(np.hypot(box[2] - box[0], box[3] - box[1]))


def _height(edge: Edge, place: Any) -> float:
    """Meters of a road above the origin of its map, where it comes nearest to a place."""
    if edge.elevations is None:
        return 0.0
    (along,), _ = edge.curve.project([[place.centroid.x, place.centroid.y]])
    stations = np.linspace(0.0, edge.length, len(edge.elevations))
    return float(np.interp(along, stations, edge.elevations))


def junction_overlaps(junctions: Sequence[Junction]) -> tuple[Problem, ...]:
    """Pairs of junctions whose areas overlap, each by the roads of both that are nearest to it. A
    junction that all of its roads lie in has none that leads to it, and is left out."""
    import shapely

    junctions = [junction for junction in junctions if junction.arms]
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
        edge = _nearest_road(junctions[i], common)
        edges = edge, _nearest_road(junctions[j], common, other_than=edge)
        problems.append(Problem("overlap", junctions[i].id, edges, _extent(common)))
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
