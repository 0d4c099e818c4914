"""The lines that agents follow, as tables over arc length: many lines, looked up all at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..recycled_memory import RECYCLED
from .line_nodes import NodesOf, Spacing, line_nodes
from .line_sources import LineSource

AROUND = 2.0
"""Meters to each side over which the curvature ahead is averaged, as drivers see it."""
_AT_ONCE = 24
"""Lines whose nodes are found and tables filled together, so few that they fit into the caches."""


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


def beside_chord(cell: Any, rest: Any, spacing: Any, left: Any) -> tuple[Any, Any]:
    """x and y `rest` meters into a cell and `left` meters beside the line, nearly, without a sine:
    the tangent of the arc turns from before its chord to beyond it. One source for arrays and
    traced columns. `cell`: the first five of `CELL`."""
    x, y, slope_x, slope_y, curvature = cell
    bend = curvature * rest
    bulge = 0.5 * bend * (rest - spacing)
    ahead = rest - left * (bend - 0.5 * curvature * spacing)
    across = bulge + left
    return x + slope_x * ahead - slope_y * across, y + slope_y * ahead + slope_x * across


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
        cls,
        sources: Sequence[LineSource],
        margin: float,
        nodes_of: NodesOf | None = None,
        table_of: TableOf | None = None,
        at_once: int = _AT_ONCE,
    ) -> Lines:
        """Tables of lines; closed ones go on for `margin` meters at both ends. `nodes_of` and
        `table_of`: what finds and fills them, if it is not `line_nodes` and `line_table`, for so
        many lines together that their nodes fit into the caches."""
        spacing = Spacing.of(sources, margin)
        count = spacing.nodes
        table = RECYCLED.empty(len(sources), count, len(CELL))
        for first in range(0, len(sources), at_once):
            rows = slice(first, first + at_once)
            part = spacing.of_rows(rows)
            nodes = (nodes_of or line_nodes)(sources[rows], part, count)
            (table_of or line_table)(nodes, part.meters, table[rows])
        return cls(
            count, -spacing.pads * spacing.meters, spacing.meters, spacing.last - 1,
            spacing.length, spacing.closed, spacing.turn, table.reshape(-1, len(CELL)),
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

    def in_cells(self, cell: Integers, *columns: int) -> list[Floats]:
        """The numbers of columns in cells (...), each side by side in memory: arithmetic of them
        is faster than of rows of the table."""
        begins = cell * len(CELL)
        numbers = self.table.reshape(-1)
        return [numbers[column:].take(begins) for column in columns]

    def column(self, values: Floats) -> Floats:
        """(L, M) of a flat column."""
        return values.reshape(-1, self.cells)


TableOf = Callable[[Floats, Floats, Floats], None]
"""Something that does what `line_table` does."""


def line_table(nodes: Floats, spacing: Floats, out: Floats) -> None:
    """Fill `out` (L, M, 8) from x, y, heading and width (4, L, M) at nodes that are `spacing` (L,)
    apart."""
    columns = _columns(nodes, spacing, cells_around(spacing))
    out[:] = columns.transpose(1, 2, 0)  # one write of each cell, and not one a column


def _columns(nodes: Floats, spacing: Floats, around: Integers) -> Floats:
    """(8, L, M) in the order of `CELL`."""
    x, y, heading, width = nodes
    columns = np.empty((len(CELL), *x.shape))
    columns[0], columns[1], columns[5], columns[7] = x, y, heading, width
    meters = spacing[:, None]
    slope_x, slope_y, curvature = columns[2:5, :, :-1]
    np.multiply(x[:, 1:] - x[:, :-1], 1.0 / meters, out=slope_x)
    np.multiply(y[:, 1:] - y[:, :-1], 1.0 / meters, out=slope_y)
    np.divide(heading[:, 1:] - heading[:, :-1], meters, out=curvature)
    columns[2:5, :, -1] = 0.0
    alike = around.tolist()
    if alike.count(alike[0]) == len(alike):
        columns[6] = _averaged(heading, alike[0], meters)
        return columns
    for cells in {*alike}:
        rows = np.flatnonzero(around == cells)
        columns[6, rows] = _averaged(heading[rows], cells, meters[rows])
    return columns


def _averaged(heading: Floats, cells: int, spacing: Floats) -> Floats:
    """(L, M) curvature at the nodes, over some cells to each side, which are `spacing` (L, 1)
    long."""
    before, after = (np.repeat(end, cells, axis=1) for end in (heading[:, :1], heading[:, -1:]))
    wide = np.concatenate((before, heading, after), axis=1)
    found: Floats = (wide[:, 2 * cells :] - wide[:, : -2 * cells]) / (2.0 * cells * spacing)
    return found


def cells_around(spacing: Floats) -> Integers:
    """(L,) how many cells `AROUND` is, at least one."""
    return np.maximum(np.round(AROUND / spacing), 1.0).astype(np.int64)
