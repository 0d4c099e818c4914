"""Roads whose surfaces overlap where no junction is: a fault of the drawing."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from ..cross_section import CrossSection
from ..network import Edge, RoadNetwork
from .model import Problem
from .sweeping import TOLERANCE, valid

NO_JUNCTION = -1
_SPACING = 2.0
_SHORTEST = 0.1


def overlaps(
    network: RoadNetwork,
    sections: Mapping[int, CrossSection],
    trims: Mapping[int, tuple[float, float]],
    known: Collection[frozenset[int]],
) -> tuple[Problem, ...]:
    """Pairs of roads that overlap between their trims, but for those that are `known`."""
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
        if a >= b or frozenset(ids) in known:
            continue
        box = shapely.bounds(shapely.intersection(surfaces[a], surfaces[b]))
        along = float(np.hypot(box[2] - box[0], box[3] - box[1]))
        if along < _SHORTEST:
            continue
        problems.append(Problem("overlap", NO_JUNCTION, ids, along))
    return tuple(problems)


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
