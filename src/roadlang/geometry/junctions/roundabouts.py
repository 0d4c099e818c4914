"""Roundabouts: faces of the network's drawing that are nearly circles."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TypeAlias

import numpy as np

from ..arrays import Floats, cross
from ..lanes.cross_section import CrossSection
from ..networks.junction_model import End
from ..networks.network import RoadNetwork
from .one_way import direction_of

HalfEdge: TypeAlias = tuple[int, End]
"""An edge, traveled from the named end."""

_ROUND, _COMPACT = 0.11, 0.9
"""A ring drawn by hand may be three tenths longer than wide."""
_SMALLEST, _LARGEST = 6.0, 60.0
_LARGEST_ONE_WAY = 150.0
"""Meters: a greater ring is an ordinary road that comes back to itself, unless traffic runs one way
round it already, as maps say."""
_SAMPLES = 16


def roundabouts(
    network: RoadNetwork, sections: Mapping[int, CrossSection]
) -> tuple[tuple[HalfEdge, ...], ...]:
    """The rings of half-edges, counter-clockwise, of faces that are nearly circles with at least
    two roads that lead away: of 6 to 60 m radius, and of up to 150 m where all roads around are
    one-way in this direction."""
    found = []
    for face in _faces(network):
        outline = np.concatenate([_line(network, half) for half in face])
        junctions = {_origin(network, half) for half in face}
        leading = sum(network.degree(node) >= 3 for node in junctions)
        is_one_way = all(_runs_along(sections[id], end) for id, end in face)
        largest = _LARGEST_ONE_WAY if is_one_way else _LARGEST
        if leading >= 2 and _is_circle(outline, largest):
            found.append(face)
    return tuple(found)


def _runs_along(section: CrossSection, end: End) -> bool:
    """Whether a road is one-way from this end to the other."""
    return direction_of(section) == ("forward" if end == "start" else "backward")


def _faces(network: RoadNetwork) -> list[tuple[HalfEdge, ...]]:
    """The counter-clockwise boundaries: at every node on to the next edge clockwise."""
    following = _following(network)
    faces, seen = [], set()
    for first in sorted(following):
        face: list[HalfEdge] = []
        half = first
        while half not in seen:
            seen.add(half)
            face.append(half)
            half = following[half]
        if face and len({edge for edge, _ in face}) == len(face):
            faces.append(tuple(face))
    return faces


def _following(network: RoadNetwork) -> dict[HalfEdge, HalfEdge]:
    leaving: dict[int, list[tuple[float, HalfEdge]]] = {}
    for edge in network.edges:
        first, last = edge.end_headings
        leaving.setdefault(edge.start, []).append((_angle(first), (edge.id, "start")))
        leaving.setdefault(edge.end, []).append((_angle(last + math.pi), (edge.id, "end")))
    after: dict[HalfEdge, HalfEdge] = {}
    for halves in leaving.values():
        order = [half for _, half in sorted(halves)]
        for place, (id, end) in enumerate(order):
            after[id, "end" if end == "start" else "start"] = order[place - 1]
    return after


def _angle(heading: float) -> float:
    return round(heading % (2.0 * math.pi), 9)


def _origin(network: RoadNetwork, half: HalfEdge) -> int:
    edge = network.edge(half[0])
    return edge.start if half[1] == "start" else edge.end


def _line(network: RoadNetwork, half: HalfEdge) -> Floats:
    edge = network.edge(half[0])
    s = np.linspace(0.0, edge.length, _SAMPLES, endpoint=False)
    return edge.curve.at(s if half[1] == "start" else edge.length - s)


def _is_circle(outline: Floats, largest: float) -> bool:
    """A circle of at most this radius, fitted by least squares (Kasa 1976), leaves less than 11 %
    of it."""
    after = np.roll(outline, -1, axis=0)
    area = float(cross(outline, after).sum()) / 2.0
    perimeter = float(np.hypot(*(after - outline).T).sum())
    if area <= 0.0 or 4.0 * math.pi * area < _COMPACT * perimeter**2:
        return False
    middle = outline.mean(axis=0)
    local = outline - middle
    design = np.column_stack([2.0 * local, np.ones(len(local))])
    solution = np.linalg.lstsq(design, (local**2).sum(axis=1), rcond=None)[0]
    radius = math.sqrt(max(float(solution[2] + solution[0] ** 2 + solution[1] ** 2), 0.0))
    if not _SMALLEST < radius < largest:
        return False
    away = np.hypot(*(local - solution[:2]).T) - radius
    return float(np.sqrt((away**2).mean())) < _ROUND * radius


def ring_directions(
    network: RoadNetwork, sections: Mapping[int, CrossSection]
) -> Mapping[int, bool]:
    """For the edges of all roundabouts: whether counter-clockwise is from start to end."""
    rings = roundabouts(network, sections)
    return {edge: end == "start" for ring in rings for edge, end in ring}
