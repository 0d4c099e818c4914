"""Nodes of lines, evenly spaced, from the points of their sources."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields

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

    def of_rows(self, rows: slice) -> Spacing:
        """That of some lines."""
        return Spacing(*(getattr(self, field.name)[rows] for field in fields(self)))

    @property
    def last(self) -> Integers:
        """(L,) the number of the last node."""
        return self.counts + 2 * self.pads

    @property
    def nodes(self) -> int:
        """How many the line with the most has."""
        return 1 + int(self.last.max())


NodesOf = Callable[[Sequence[LineSource], Spacing, int], Floats]
"""Something that does what `line_nodes` does."""


def line_nodes(sources: Sequence[LineSource], spacing: Spacing, nodes: int) -> Floats:
    """(4, L, M) x, y, heading and width of lines at their nodes, of which each row has `nodes`.
    Beyond its ends an open line goes straight on; what is left of a row is like its last node."""
    out = np.empty((4, len(sources), nodes))
    at = (np.arange(out.shape[2]) - spacing.pads[:, None]) * spacing.meters[:, None]
    laps = None
    if spacing.closed.any():
        laps = np.floor(at / spacing.length[:, None]) * spacing.closed[:, None]
        at = at - laps * spacing.length[:, None]
    _put_between(out, at, sources)
    if laps is not None:
        around = spacing.closed.nonzero()[0]
        out[2, around] += laps[around] * spacing.turn[around, None]
    rows = np.flatnonzero(~spacing.closed)
    _go_straight_on(out, rows, np.zeros(len(rows), dtype=np.int64), -spacing.meters[rows])
    _go_straight_on(out, rows, spacing.last[rows], spacing.meters[rows])
    for row, used in enumerate(spacing.last.tolist()):
        if used + 1 < nodes:
            out[:, row, used + 1 :] = out[:, row, used : used + 1]
    return out


def _go_straight_on(out: Floats, rows: Integers, nodes: Integers, meters: Floats) -> None:
    """Move nodes of some lines ahead, one of each line. The sines are those of single numbers, as
    in the compiled loop."""
    headings = out[2, rows, nodes].tolist()
    out[0, rows, nodes] += meters * np.array([math.cos(heading) for heading in headings])
    out[1, rows, nodes] += meters * np.array([math.sin(heading) for heading in headings])


def _put_between(out: Floats, at: Floats, sources: Sequence[LineSource]) -> None:
    """Fill `out` (4, L, M) with what lines are at arc lengths (L, M), linear between their points,
    and beyond these as at the ends. Sums and products of single numbers, as in the compiled
    loop."""
    s = np.concatenate([source.s for source in sources])
    ends = np.cumsum([len(source.s) for source in sources])
    begins = np.append(0, ends[:-1])
    cell = np.empty(at.shape, dtype=np.int64)
    for row, source in enumerate(sources):
        cell[row] = source.s.searchsorted(at[row], "right")
    cell = np.maximum(cell - 1, 0) + begins[:, None]
    rest = np.maximum(at, s[begins][:, None]) - s.take(cell)
    is_there = rest == 0.0
    run = s[1:] - s[:-1]
    run[ends[:-1] - 1] = 1.0  # from one line to the next
    for column, values in enumerate(_columns(sources, ends)):
        if values.ndim == 2:  # the same all along
            out[column] = values
            continue
        slopes = np.zeros_like(values)
        np.divide(values[1:] - values[:-1], run, out=slopes[:-1])
        slopes[ends - 1] = 0.0
        there = values.take(cell)
        found = slopes.take(cell)
        found *= rest
        found += there
        np.copyto(found, there, where=is_there)
        out[column] = found


def _columns(sources: Sequence[LineSource], ends: Integers) -> list[Floats]:
    """(P,) x, y, heading and width at the points of lines; (L, 1) widths that are the same all
    along. `ends`: (L,) of their points."""
    columns = [
        np.concatenate([getattr(source, name) for source in sources])
        for name in ("x", "y", "heading")
    ]
    widths = np.concatenate([one.widths for one in sources])
    changes = widths[1:] != widths[:-1]
    changes[ends[:-1] - 1] = False
    if np.count_nonzero(changes):
        return [*columns, widths]
    return [*columns, widths[ends - 1][:, None]]
