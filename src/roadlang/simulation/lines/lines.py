"""The lines that agents follow, as tables over arc length: many lines, looked up all at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import SceneRoad

SPACING = 1.0
"""Meters between two nodes of a table, at most."""
FINEST = 0.25
"""Meters between two nodes of a table, at least, where the road has them closer."""
AROUND = 2.0
"""Meters to each side over which the curvature ahead is averaged, as drivers see it."""
_AT_ONCE = 16
"""Lines whose tables are filled together, so few that they fit into the caches."""


CELL = ("x", "y", "slope_x", "slope_y", "curvature", "heading", "seen_curvature", "width")
"""What is stored for a cell: x and y where it begins, what they and the heading change by for each
meter of it, the heading where it begins, the curvature around there, the width of the road."""


def on_arc(cell: Any, rest: Any, spacing: Any) -> Any:
    """x, y and heading `rest` meters into a cell; within it a line is an arc. One source for
    arrays and numbers, as in `vehicle`."""
    bend = cell[4] * rest
    bulge = 0.5 * bend * (rest - spacing)
    return (
        cell[0] + cell[2] * rest - cell[3] * bulge,
        cell[1] + cell[3] * rest + cell[2] * bulge,
        cell[5] + bend,
    )


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
    def count(self) -> int:
        """How many cells its table has."""
        finest = min(len(self.s) - 1, math.ceil(self.length / FINEST))
        return max(2, math.ceil(self.length / SPACING), finest)


def road_line(road: SceneRoad, backward: bool) -> LineSource:
    """The center line of a road, in its direction or against it."""
    columns = (road.stations, road.x, road.y, road.heading)
    s, x, y, heading = (np.asarray(column, np.float64) for column in columns)
    widths = np.asarray(road.width, np.float64)
    is_constant = not np.count_nonzero(widths != widths[0])
    width: Floats | float = road.width[0] if is_constant else widths
    s = s - s[0]
    if road.closed and math.hypot(x[0] - x[-1], y[0] - y[-1]) > 1e-6:
        last = float(s[-1]) + math.hypot(x[0] - x[-1], y[0] - y[-1])
        s = np.append(s, max(road.length, last))
        x, y, heading = (np.append(column, column[0]) for column in (x, y, heading))
        width = np.append(width, width[0]) if isinstance(width, np.ndarray) else width
    if backward:
        s = s[-1] - s[::-1]
        x, y, heading = x[::-1], y[::-1], heading[::-1] + np.pi
        width = width[::-1] if isinstance(width, np.ndarray) else width
    if np.abs(heading[1:] - heading[:-1]).max() > np.pi:
        heading = np.unwrap(heading)
    return LineSource(s, x, y, heading, width, road.closed)


def straight_line(x: float, y: float, heading: float) -> LineSource:
    """What an agent follows that is on no road: straight on from where it stands."""
    ahead = np.array([0.0, 1.0])
    along = np.array([heading, heading])
    return LineSource(ahead, x + np.cos(heading) * ahead, y + np.sin(heading) * ahead, along, 0.0)


@dataclass(frozen=True)
class Lines:
    """Tables of L lines, each of M cells; `heading[row * M + cell]` is that where a cell begins.

    Cells have one length for each line. The first cell lies before the line, the last goes on
    beyond it, straight; those of a closed line repeat it.
    """

    cells: int
    origin: Floats
    """(L,) arc length where the first cell begins, at most 0"""
    spacing: Floats
    last: Integers
    """(L,) the last cell"""
    length: Floats
    closed: Booleans
    turn: Floats
    """(L,) by how much a closed line turns in all, radians"""
    table: Floats
    """(L M, 8) of each cell, side by side in memory, in the order of `CELL`"""

    @classmethod
    def of(
        cls, sources: Sequence[LineSource], margin: float, table_of: TableOf | None = None
    ) -> Lines:
        """Tables of lines; closed ones go on for `margin` meters at both ends. `table_of`: what
        fills them, if it is not `line_table`."""
        counts = [source.count for source in sources]
        pads = [
            math.ceil(margin * count / source.length) if source.closed else 1
            for source, count in zip(sources, counts, strict=True)
        ]
        nodes = 1 + max(count + 2 * pad for count, pad in zip(counts, pads, strict=True))
        columns = np.empty((4, len(sources), nodes))
        for row, (source, count, pad) in enumerate(zip(sources, counts, pads, strict=True)):
            _fill(columns[:, row], source, count, pad)
        length = np.array([source.length for source in sources])
        spacing = length / np.array(counts)
        ends = [
            source.heading[-1] - source.heading[0] if source.closed else 0.0 for source in sources
        ]
        return cls(
            nodes, -np.array(pads) * spacing, spacing,
            np.array(counts) + 2 * np.array(pads) - 1, length,
            np.array([source.closed for source in sources], dtype=bool),
            np.array(ends, dtype=float), (table_of or line_table)(columns, spacing),
        )  # fmt: skip

    @cached_property
    def x(self) -> Floats:
        """(L M,) where cells begin."""
        return self.table[:, CELL.index("x")]

    @cached_property
    def y(self) -> Floats:
        """(L M,) where cells begin."""
        return self.table[:, CELL.index("y")]

    @cached_property
    def heading(self) -> Floats:
        """(L M,) where cells begin."""
        return self.table[:, CELL.index("heading")]

    @cached_property
    def curvature(self) -> Floats:
        """(L M,) 1/m, constant in each cell: the slope of the heading."""
        return self.table[:, CELL.index("curvature")]

    @cached_property
    def seen_curvature(self) -> Floats:
        """(L M,) 1/m, averaged over 4 m."""
        return self.table[:, CELL.index("seen_curvature")]

    @cached_property
    def width(self) -> Floats:
        """(L M,) of the road."""
        return self.table[:, CELL.index("width")]

    def column(self, values: Floats) -> Floats:
        """(L, M) of a flat column."""
        return values.reshape(-1, self.cells)


TableOf = Callable[[Floats, Floats], Floats]
"""Something that does what `line_table` does."""


def _fill(row: Floats, source: LineSource, count: int, pad: int) -> None:
    """The nodes (4, M) of one line: x, y, heading and width; what is left is like the last."""
    x, y, heading, width = row
    spacing = source.length / count
    s = np.arange(-pad, count + pad + 1) * spacing
    s[pad] = 0.0
    used = len(s)
    laps: Floats | float = 0.0
    if source.closed:
        laps = np.floor(s / source.length)
        s = s - laps * source.length
    x[:used] = np.interp(s, source.s, source.x)
    y[:used] = np.interp(s, source.s, source.y)
    heading[:used] = np.interp(s, source.s, source.heading)
    width[:used] = (
        np.interp(s, source.s, source.width)
        if isinstance(source.width, np.ndarray)
        else source.width
    )
    if source.closed:
        heading[:used] += laps * (source.heading[-1] - source.heading[0])
    else:
        for end, step in ((0, -spacing), (used - 1, spacing)):
            x[end] += step * math.cos(heading[end])
            y[end] += step * math.sin(heading[end])
    row[:, used:] = row[:, used - 1 : used]


def line_table(nodes: Floats, spacing: Floats) -> Floats:
    """(L M, 8) of x, y, heading and width (4, L, M) at nodes that are `spacing` (L,) apart."""
    x, y, heading, width = nodes
    out = np.empty((*x.shape, len(CELL)))
    averaged = _averaged(heading, spacing)
    for first in range(0, len(x), _AT_ONCE):
        rows = slice(first, first + _AT_ONCE)
        cells, per_meter = out[rows], (1.0 / spacing[rows])[:, None]
        cells[:, :, 0], cells[:, :, 1] = x[rows], y[rows]
        cells[:, :-1, 2] = (x[rows, 1:] - x[rows, :-1]) * per_meter
        cells[:, :-1, 3] = (y[rows, 1:] - y[rows, :-1]) * per_meter
        cells[:, :-1, 4] = (heading[rows, 1:] - heading[rows, :-1]) / spacing[rows, None]
        cells[:, -1, 2:5] = 0.0
        cells[:, :, 5], cells[:, :, 6], cells[:, :, 7] = heading[rows], averaged[rows], width[rows]
    return out.reshape(-1, len(CELL))


def _averaged(heading: Floats, spacing: Floats) -> Floats:
    """(L, M) curvature at the nodes, over `AROUND` meters to each side."""
    out = np.zeros_like(heading)
    half_window = cells_around(spacing)
    for cells in np.unique(half_window):
        rows = np.flatnonzero(half_window == cells)
        wide = np.pad(heading[rows], ((0, 0), (cells, cells)), mode="edge")
        over = (2.0 * cells * spacing[rows])[:, None]
        out[rows] = (wide[:, 2 * cells :] - wide[:, : -2 * cells]) / over
    return out


def cells_around(spacing: Floats) -> Integers:
    """(L,) how many cells `AROUND` is, at least one."""
    return np.maximum(np.round(AROUND / spacing), 1.0).astype(np.int64)
