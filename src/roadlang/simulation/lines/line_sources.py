"""Lines before they are tables."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...geometry.arrays import Floats
from ...ir.scene import SceneRoad
from ...ir.scene_road import all_numbers_of

SPACING = 1.0
"""Meters between two nodes of a table, at most."""
FINEST = 0.25
"""Meters between two nodes of a table, at least, where the road has them closer."""
_COLUMNS = "stations", "x", "y", "heading", "width"
_AT_ONCE = 64
"""Lines of whose headings one is asked with the others: so few that they fit into the caches."""


@dataclass(frozen=True)
class LineSource:
    """A line before it is a table: nodes by arc length, in the direction of travel."""

    s: Floats
    x: Floats
    y: Floats
    heading: Floats
    width: Floats | float
    closed: bool = False

    @property
    def length(self) -> float:
        """Meters."""
        return float(self.s[-1])

    @property
    def widths(self) -> Floats:
        """At each node."""
        same = not isinstance(self.width, np.ndarray)
        return np.full(len(self.s), self.width) if same else self.width  # type: ignore[return-value]

    @property
    def count(self) -> int:
        """How many cells its table has."""
        length = self.length
        finest = min(len(self.s) - 1, math.ceil(length / FINEST))
        return max(2, math.ceil(length / SPACING), finest)


def road_line(road: SceneRoad, backward: bool) -> LineSource:
    """The center line of a road, in its direction or against it; its heading may jump by a turn
    (see `without_jumps`)."""
    s, x, y, heading, width = all_numbers_of(road, _COLUMNS)
    if s[0] != 0.0:
        s = s - s[0]
    if road.closed and math.hypot(x[0] - x[-1], y[0] - y[-1]) > 1e-6:
        last = float(s[-1]) + math.hypot(x[0] - x[-1], y[0] - y[-1])
        s = np.append(s, max(road.length, last))
        x, y, heading, width = (np.append(column, column[0]) for column in (x, y, heading, width))
    if backward:
        s = s[-1] - s[::-1]
        x, y, heading, width = x[::-1], y[::-1], heading[::-1] + np.pi, width[::-1]
    return LineSource(s, x, y, heading, width, road.closed)


def without_jumps(sources: Sequence[LineSource]) -> list[LineSource]:
    """The lines, whose headings do not jump by a turn."""
    found = list(sources)
    for begin in range(0, len(sources), _AT_ONCE):
        for row in _with_jumps(sources[begin : begin + _AT_ONCE]):
            line = found[begin + row]
            found[begin + row] = replace(line, heading=np.unwrap(line.heading))
    return found


def _with_jumps(sources: Sequence[LineSource]) -> set[int]:
    """The lines whose headings jump: one look at some takes a fifth of the time of one at each."""
    heading = np.concatenate([source.heading for source in sources])
    jumps = np.flatnonzero(np.abs(heading[1:] - heading[:-1]) > np.pi)
    if not len(jumps):
        return set()
    ends = np.cumsum([len(source.heading) for source in sources])
    rows = np.searchsorted(ends, jumps, "right")
    return {*rows[jumps + 1 < ends[rows]].tolist()}


def straight_line(x: float, y: float, heading: float) -> LineSource:
    """What an agent follows that is on no road: straight on from where it stands."""
    ahead = np.array([0.0, 1.0])
    along = np.array([heading, heading])
    return LineSource(ahead, x + np.cos(heading) * ahead, y + np.sin(heading) * ahead, along, 0.0)
