"""The lines that agents follow, as tables over arc length: many lines, looked up all at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats, Integers
from ..ir.scene import SceneRoad

SPACING = 0.5
"""Meters between two nodes of a table, at most."""
AROUND = 2.0
"""Meters to each side over which the curvature ahead is averaged, as drivers see it."""


@dataclass(frozen=True)
class LineSource:
    """A line before it is a table: nodes by arc length, in the direction of travel.

    A line without length is a point from which it goes straight on.
    """

    s: Floats
    x: Floats
    y: Floats
    heading: Floats
    width: Floats
    closed: bool = False

    @property
    def length(self) -> float:
        """Meters."""
        return float(self.s[-1])


def road_line(road: SceneRoad, backward: bool) -> LineSource:
    """The center line of a road, in its direction or against it."""
    s, x, y, heading, width = (
        np.array(column, dtype=np.float64)
        for column in (road.stations, road.x, road.y, road.heading, road.width)
    )
    s -= s[0]
    if road.closed and np.hypot(x[0] - x[-1], y[0] - y[-1]) > 1e-6:
        last = s[-1] + float(np.hypot(x[0] - x[-1], y[0] - y[-1]))
        s = np.append(s, max(road.length, last))
        x, y, heading, width = (np.append(c, c[0]) for c in (x, y, heading, width))
    if backward:
        s = s[-1] - s[::-1]
        x, y, heading, width = x[::-1], y[::-1], heading[::-1] + np.pi, width[::-1]
    if np.abs(np.diff(heading)).max(initial=0.0) > np.pi:
        heading = np.unwrap(heading)
    return LineSource(s, x, y, heading, width, road.closed)


def straight_line(x: float, y: float, heading: float) -> LineSource:
    """What an agent follows that is on no road: straight on from where it stands."""
    ahead = np.array([0.0, 1.0])
    zero = np.zeros(2)
    return LineSource(
        ahead, x + np.cos(heading) * ahead, y + np.sin(heading) * ahead, zero + heading, zero
    )


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
    closed: np.ndarray[tuple[int], np.dtype[np.bool_]]
    turn: Floats
    """(L,) by how much a closed line turns in all, radians"""
    heading: Floats
    curvature: Floats
    """1/m, constant in each cell: the slope of the heading"""
    seen_curvature: Floats
    """1/m, averaged over 4 m"""
    place: Floats
    """(L M, 4): x and y where each cell begins, and their slopes along it"""
    width: Floats

    @classmethod
    def of(cls, sources: Sequence[LineSource], margin: float) -> Lines:
        """Tables of lines; closed ones go on for `margin` meters at both ends."""
        counts = [max(2, int(np.ceil(one.length / SPACING))) for one in sources]
        pads = [int(np.ceil(margin / SPACING)) if one.closed else 1 for one in sources]
        cells = max(n + 2 * pad for n, pad in zip(counts, pads, strict=True))
        rows = len(sources)
        table = np.zeros((rows, cells, 8))
        geometry = np.empty((rows, 4))
        last = np.empty(rows, dtype=np.int64)
        for row, (source, count, pad) in enumerate(zip(sources, counts, pads, strict=True)):
            spacing = source.length / count
            _fill(table[row], source, count, pad, spacing)
            last[row] = count + 2 * pad - 1
            turn = float(source.heading[-1] - source.heading[0]) if source.closed else 0.0
            geometry[row] = (-pad * spacing, spacing, source.length, turn)
        columns = np.ascontiguousarray(table.reshape(-1, 8).T)
        closed = np.array([one.closed for one in sources], dtype=bool)
        origin, spacing_, length, turn_ = np.ascontiguousarray(geometry.T)
        return cls(
            cells, origin, spacing_, last, length, closed, turn_,
            columns[0], columns[1], columns[2], table.reshape(-1, 8)[:, 4:].copy(), columns[3],
        )  # fmt: skip

    def column(self, values: Floats) -> Floats:
        """(L, M) of a flat column."""
        return values.reshape(-1, self.cells)


def _fill(table: Floats, source: LineSource, count: int, pad: int, spacing: float) -> None:
    """The cells of one line: heading, curvature, seen curvature, width, x, y and their slopes."""
    s = np.arange(-pad, count + pad + 1) * spacing
    s[pad] = 0.0
    at = s
    turn = np.zeros(1)
    if source.closed:
        laps = np.floor(s / source.length)
        at = s - laps * source.length
        turn = laps * (source.heading[-1] - source.heading[0])
    x, y, heading, width = (
        np.interp(at, source.s, column)
        for column in (source.x, source.y, source.heading, source.width)
    )
    heading = heading + turn
    if not source.closed:
        x[0] -= spacing * np.cos(heading[0])
        y[0] -= spacing * np.sin(heading[0])
        x[-1] += spacing * np.cos(heading[-1])
        y[-1] += spacing * np.sin(heading[-1])
    used = table[: len(s) - 1]
    used[:, 0] = heading[:-1]
    used[:, 1] = np.diff(heading) / spacing
    used[:, 2] = _averaged(heading, spacing)[:-1]
    used[:, 3] = width[:-1]
    used[:, 4], used[:, 5] = x[:-1], y[:-1]
    used[:, 6], used[:, 7] = np.diff(x) / spacing, np.diff(y) / spacing
    table[len(s) - 1 :] = used[-1]


def _averaged(heading: Floats, spacing: float) -> Floats:
    """Curvature at the nodes, over `AROUND` meters to each side."""
    reach = max(1, round(AROUND / spacing))
    wide = np.concatenate([np.full(reach, heading[0]), heading, np.full(reach, heading[-1])])
    return np.asarray((wide[2 * reach :] - wide[: -2 * reach]) / (2.0 * reach * spacing))
