"""Roads as outlines in meters, with few points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..geometry.arrays import Floats, Integers
from ..ir.scene import Scene, SceneRoad
from .decimation import deltas, simplified

_TOLERANCE = 0.1
"""How far the drawn line may be from the road's, meters."""
CENTIMETERS = 100.0


@dataclass(frozen=True)
class Outline:
    """What is drawn of a road: its surface (n, 2), a ring, and lines between lanes, with whether
    each is broken. Meters."""

    surface: Floats
    lines: tuple[tuple[Floats, bool], ...]

    def record(self) -> dict[str, Any]:
        """For the page: deltas in centimeters."""
        return {
            "surface": _flat(self.surface),
            "lines": [[_flat(line), int(broken)] for line, broken in self.lines],
        }


def outlines(scene: Scene) -> list[Outline]:
    """The roads that are driven, and the surfaces of junctions."""
    roads = [road for road in scene.roads if road.derived] or list(scene.roads)
    areas = [
        Outline(np.array(junction.area), ())
        for network in scene.networks
        for junction in network.junctions
        if len(junction.area) > 2 and any(road.network == network.name for road in roads)
    ]
    return [*map(outline, roads), *areas]


def outline(road: SceneRoad) -> Outline:
    """A road with its lanes."""
    stations = np.array(road.stations)
    borders = road.cross_section().border_offsets(stations)
    markings = road.cross_section().markings
    lines = [_beside(road, border) for border in borders]
    ring = np.concatenate([lines[0][_selected(lines[0])], lines[-1][_selected(lines[-1])][::-1]])
    if road.closed:
        ring = _with_hole(lines[0], lines[-1])
    return Outline(ring, tuple(_marked(road, lines, markings)))


def _marked(
    road: SceneRoad, lines: list[Floats], markings: tuple[str, ...]
) -> Iterator[tuple[Floats, bool]]:
    """The lines between lanes, outside of junctions."""
    stations = np.array(road.stations)
    first, last = road.trim[0], road.length - road.trim[1]
    shown = (stations >= first) & (stations <= last)
    for line, marking in zip(lines[1:-1], markings[1:-1], strict=True):
        if marking == "none" or shown.sum() < 2:
            continue
        part = line[shown]
        part = np.concatenate([part, part[:1]]) if road.closed else part
        yield part[_selected(part)], marking == "broken"


def _with_hole(left: Floats, right: Floats) -> Floats:
    """The ring of a closed road: out along one side, back along the other."""
    outer, inner = (np.concatenate([side, side[:1]]) for side in (left, right))
    ring: Floats = np.concatenate([outer[_selected(outer)], inner[_selected(inner)][::-1]])
    return ring


def _beside(road: SceneRoad, offset: Floats) -> Floats:
    heading = np.array(road.heading)
    left = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
    return np.asarray(np.stack([road.x, road.y], axis=-1) + offset[:, None] * left)


def _selected(line: Floats) -> Integers:
    return simplified(line, _TOLERANCE)


def _flat(points: Floats) -> list[list[int]]:
    return [deltas(points[:, 0], CENTIMETERS), deltas(points[:, 1], CENTIMETERS)]
