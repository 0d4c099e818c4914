"""Where agents are in the plane, from where they are along their lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..lines.lines import CELL, beside_chord, on_arc
from ..tapes.traced import TracedColumn
from . import compiled
from .motion import Motion, Track


@dataclass(frozen=True)
class Poses:
    """Columns (N,) over agents: center of the footprint, heading. Meters and radians."""

    x: Floats
    y: Floats
    heading: Floats
    road_width: Floats

    def take(self, rows: Any) -> Poses:
        """Those of some agents."""
        return Poses(self.x[rows], self.y[rows], self.heading[rows], self.road_width[rows])

    def put(self, rows: Any, other: Poses) -> Poses:
        """These, but some agents as in `other`."""
        columns = [np.array(each) for each in (self.x, self.y, self.heading, self.road_width)]
        others = (other.x, other.y, other.heading, other.road_width)
        for column, there in zip(columns, others, strict=True):
            column[rows] = there[rows]
        return Poses(*columns)


def poses_of(motion: Motion, track: Track) -> Poses:
    """Where agents in motion are."""
    x, y, width = _places(track, motion.along)
    along = motion.line_heading
    heading = along + np.arctan2(motion.sine, motion.cosine)
    return Poses(
        x - np.sin(along) * motion.offset, y + np.cos(along) * motion.offset, heading, width
    )


def _places(track: Track, along: Floats) -> Sequence[Floats]:
    """x, y and width (N,) of `line_frames`."""
    if compiled.is_loaded() or isinstance(along, TracedColumn):
        x, y, _, _, width = line_frames(track, along)
        return x, y, width
    cell, rest = track.cell(along)
    *columns, width = track.lines.in_cells(cell, *_PLACE)
    x, y, _ = on_arc(columns, rest, track.spacing)
    return x, y, width


_PLACE = (*range(CELL.index("heading") + 1), CELL.index("width"))


def line_frames(track: Track, along: Floats) -> Floats:
    """(5, N) x, y, heading, curvature around there and width of the road, at arc lengths of lines;
    within a cell a line is an arc."""
    if isinstance(along, TracedColumn):
        return along.line_frames(track)
    if compiled.is_loaded():
        return compiled.line_frames(track, along)
    return frames_in(track, *track.cell(along))


def frames_ahead(track: Track, along: Floats) -> tuple[Integers, Floats]:
    """(K, N) the cells at arc lengths (K, N) of lines, and (5, K, N) what `line_frames` gives."""
    if compiled.is_loaded():
        return compiled.frames_ahead(track, along)
    cell, rest = track.cell(along)
    return cell, frames_in(track, cell, rest)


def points_beside(track: Track, along: Floats, left: Floats) -> tuple[Floats, Floats]:
    """(K, N) x and y at arc lengths (K, N) of lines, `left` (N,) or (K, N) meters beside them."""
    if compiled.is_loaded():
        return compiled.points_beside(track, along, left)
    cell, rest = track.cell(along)
    return beside_chord(track.lines.in_cells(cell, *range(5)), rest, track.spacing, left)


def line_widths(track: Track, along: Floats) -> Floats:
    """(N,) widths of the roads at arc lengths of lines."""
    widths: Floats = track.lines.width[track.cell(along)[0]]
    return widths


def frames_in(track: Track, cell: Any, rest: Floats) -> Floats:
    """(5, ...) the same `rest` meters into cells."""
    *columns, seen_curvature, width = track.lines.in_cells(cell, *range(len(CELL)))
    out = np.empty((5, *cell.shape))
    out[0], out[1], out[2] = on_arc(columns, rest, track.spacing)
    out[3], out[4] = seen_curvature, width
    return out


def foot_points(track: Track, x: Floats, y: Floats, along: Floats) -> tuple[Floats, Floats, Floats]:
    """(N,) arc lengths of the foot points of places on lines, found from `along`, which is nearly
    that; the distances left of the lines, and the headings of the lines there."""
    offset = np.zeros(len(along))
    for _ in range(2):
        cell, rest = track.cell(along)
        line_x, line_y, heading, _, _ = frames_in(track, cell, rest)
        curvature = track.lines.curvature[cell]
        off_x, off_y = x - line_x, y - line_y
        cosine, sine = np.cos(heading), np.sin(heading)
        offset = cosine * off_y - sine * off_x
        ahead = cosine * off_x + sine * off_y
        along = along + ahead / np.maximum(1.0 - offset * curvature, 0.5)
    cell, rest = track.cell(along)
    return along, offset, track.lines.heading[cell] + track.lines.curvature[cell] * rest
