"""Nodes of lines, evenly spaced, from the points of their sources."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from .line_sources import LineSource


@dataclass(frozen=True)
class Spacing:
    """How the nodes of L lines are spaced, (L,) each."""

    counts: Integers
    """intervals between the ends of a line"""
    pads: Integers
    """intervals before it, and beyond it"""
    length: Floats
    closed: Booleans
    turn: Floats
    """by how much a closed line turns in all, radians"""
    meters: Floats
    """from one node to the next"""

    @classmethod
    def of(cls, sources: Sequence[LineSource], margin: float) -> Spacing:
        """Closed lines go on for `margin` meters at both ends, others for one interval."""
        lengths = [source.length for source in sources]
        counts = [source.count for source in sources]
        pads = [
            math.ceil(margin * count / length) if source.closed else 1
            for source, count, length in zip(sources, counts, lengths, strict=True)
        ]
        turn = [
            float(source.heading[-1] - source.heading[0]) if source.closed else 0.0
            for source in sources
        ]
        closed = np.array([source.closed for source in sources], dtype=bool)
        length, count = np.array(lengths), np.array(counts, dtype=np.int64)
        pad = np.array(pads, dtype=np.int64)
        return cls(count, pad, length, closed, np.array(turn), length / count)

    @property
    def last(self) -> Integers:
        """(L,) the number of the last node."""
        return self.counts + 2 * self.pads


NodesOf = Callable[[Sequence[LineSource], Spacing], Floats]
"""Something that does what `line_nodes` does."""


def line_nodes(sources: Sequence[LineSource], spacing: Spacing) -> Floats:
    """(4, L, M) x, y, heading and width of lines at their nodes. Beyond its ends an open line goes
    straight on; what is left of a row is like its last node."""
    out = np.empty((4, len(sources), 1 + int(spacing.last.max())))
    for row, source in enumerate(sources):
        pad, count = int(spacing.pads[row]), int(spacing.counts[row])
        turn = float(spacing.turn[row])
        _fill(out[:, row], source, (pad, count, float(spacing.meters[row])), turn)
    return out


def _fill(row: Floats, source: LineSource, places: tuple[int, int, float], turn: float) -> None:
    """The nodes (4, M) of one line. `places`: intervals before it and between its ends, meters of
    each."""
    pad, count, meters = places
    s = np.arange(-pad, count + pad + 1).astype(np.float64) * meters
    used = len(s)
    laps: Floats | float = 0.0
    if source.closed:
        laps = np.floor(s / source.length)
        s = s - laps * source.length
    columns = [source.x, source.y, source.heading]
    if isinstance(source.width, np.ndarray):
        columns.append(source.width)
    else:
        row[3] = source.width
    row[: len(columns), :used] = _between(s, source.s, np.stack(columns))
    if source.closed:
        row[2, :used] += laps * turn
    else:
        for end, step in ((0, -meters), (used - 1, meters)):
            row[0, end] += step * math.cos(row[2, end])
            row[1, end] += step * math.sin(row[2, end])
    row[:, used:] = row[:, used - 1 : used]


def _between(at: Floats, s: Floats, columns: Floats) -> Floats:
    """(K, M) columns (K, n) at arc lengths (M,), linear between the points at `s` (n,), and beyond
    these as at the ends. Sums and products of single numbers, as in the compiled loop."""
    cell = np.maximum(s.searchsorted(at, "right") - 1, 0)
    rest = np.maximum(at, s[0]) - s[cell]
    slopes = np.zeros_like(columns)
    np.divide(columns[:, 1:] - columns[:, :-1], s[1:] - s[:-1], out=slopes[:, :-1])
    there = columns.take(cell, axis=1)
    found: Floats = np.where(rest == 0.0, there, slopes.take(cell, axis=1) * rest + there)
    return found
