"""The lines between the lanes of roads, as figures of drives and reports draw them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.simplifying import simplified
from ..ir.scene import SceneRoad

TOLERANCE = 0.1
"""How far the drawn line may be from the road's, meters."""


def marked_lines(road: SceneRoad) -> Iterator[tuple[Floats, bool]]:
    """The lines between lanes (n, 2) outside of junctions, in meters with few points, and whether
    each is broken."""
    section, stations = road.cross_section(), np.array(road.stations)
    first, last = road.trim[0], road.length - road.trim[1]
    shown = (stations >= first) & (stations <= last)
    borders = section.border_offsets(stations)
    for border, marking in zip(borders[1:-1], section.markings[1:-1], strict=True):
        if marking == "none" or shown.sum() < 2:
            continue
        part = line_beside(road, border)[shown]
        part = np.concatenate([part, part[:1]]) if road.closed else part
        yield few_points(part), marking == "broken"


def line_beside(road: SceneRoad, offset: Floats) -> Floats:
    """(n, 2) points left of the stations of a road."""
    heading = np.array(road.heading)
    left = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
    return np.asarray(np.stack([road.x, road.y], axis=-1) + offset[:, None] * left)


def few_points(line: Floats) -> Floats:
    """A line with few points, which looks the same."""
    return np.asarray(line[simplified(line, TOLERANCE)])
