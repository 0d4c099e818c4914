"""The surfaces of a road between junctions: its roadway, and the lanes beside and in it that look
different, as figures of drives and reports draw them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.cross_section import drivable_borders
from ..ir.scene import SceneRoad
from .lane_lines import few_points, shown_part


@dataclass(frozen=True, eq=False)
class LaneBand:
    """A lane that nobody drives on."""

    ring: Floats
    """(n, 2) around it, meters"""
    raised: bool
    """behind a curb"""
    inner: bool
    """between drivable lanes"""


def lane_bands(road: SceneRoad) -> Iterator[LaneBand]:
    """The lanes that are no roadway; none of a road inside a junction."""
    section = road.cross_section()
    drivable = np.array([lane.drivable for lane in section.lanes])
    part = None if drivable.all() else shown_part(road)
    if part is None:
        return
    first, last = drivable_borders(drivable)
    borders = section.border_offsets(part.stations)
    for place, lane in enumerate(section.lanes):
        if not lane.drivable:
            sides = few_points(*(part.beside(borders[place + side]) for side in (0, 1)))
            yield LaneBand(_around(*sides), lane.raised, first <= place < last)


def roadway(road: SceneRoad) -> Floats | None:
    """(n, 2) around the drivable lanes and what lies between them; None of a road inside a
    junction."""
    part, section = shown_part(road), road.cross_section()
    if part is None:
        return None
    edges = drivable_borders(np.array([lane.drivable for lane in section.lanes]))
    return _around(*map(part.beside, section.border_offsets(part.stations)[list(edges)]))


def _around(left: Floats, right: Floats) -> Floats:
    return np.concatenate([left, right[::-1]])
