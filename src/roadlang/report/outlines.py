"""Roads as outlines in meters, with few points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..drive.lane_lines import few_points, line_beside, painted_lines
from ..geometry.arrays import Floats
from ..ir.scene import Scene, SceneRoad
from .decimation import deltas

CENTIMETERS = 100.0
_SCALE = 10.0
"""Pixels per meter of the page when it shows a stretch of road close by"""


@dataclass(frozen=True)
class Outline:
    """What is drawn of a road: its surface (n, 2), a ring, and lines between lanes, with
    whether each is broken. Meters."""

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
    lines = [line_beside(road, border) for border in borders]
    ring = np.concatenate([few_points(lines[0]), few_points(lines[-1])[::-1]])
    if road.closed:
        ring = _with_hole(lines[0], lines[-1])
    last = len(borders) - 1
    painted = painted_lines(road, _SCALE)
    # The surface shows where the road ends: a page of many roads stays small.
    inner = ((line, stroke) for line, stroke in painted if 0 < stroke.border < last)
    return Outline(ring, tuple((line, stroke.dashes is not None) for line, stroke in inner))


def _with_hole(left: Floats, right: Floats) -> Floats:
    """The ring of a closed road: out along one side, back along the other."""
    outer, inner = (np.concatenate([side, side[:1]]) for side in (left, right))
    ring: Floats = np.concatenate([few_points(outer), few_points(inner)[::-1]])
    return ring


def _flat(points: Floats) -> list[list[int]]:
    return [deltas(points[:, 0], CENTIMETERS), deltas(points[:, 1], CENTIMETERS)]
