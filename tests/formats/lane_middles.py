"""Points in the middles of the lanes of a scene, and where they are in its OpenDRIVE file."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from roadlang.ir.scene import Scene
from roadlang_formats.opendrive.road_parts import road_parts

LanePoint = tuple[int, int, float, float, float]
"""Numbers of the road and the lane in the file, arc length there, and x and y by the scene."""
_NARROW = 0.1
"""Meters of width below which a lane is about to end, or has just begun."""


def lane_middles(scene: Scene, tolerance: float = 0.005, every: int = 1) -> Iterator[LanePoint]:
    """At every nth station of every lane that is built."""
    for part in road_parts(scene, tolerance, "one_way_roads"):
        stations = part.stations[::every]
        table = np.column_stack((part.road.stations, part.road.x, part.road.y, part.road.heading))
        if part.road.closed:
            table = np.vstack((table, [part.road.length, *table[0, 1:]]))
        at = np.isin(table[:, 0], stations)
        section = part.road.cross_section()
        for station, x, y, heading in table[at].tolist():
            s = float(part.line.at(np.array([station]))[0])
            for id in section.ids:
                if float(section.lane_width(id, np.array(station))) < _NARROW:
                    continue
                t = float(section.offset(id, np.array(station)))
                left = (x - t * np.sin(heading), y + t * np.cos(heading))
                yield part.id, part.numbers.ids[id], s, float(left[0]), float(left[1])
