"""The state of agents in motion, and its change over some time steps."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..lines.lines import CELL, Lines
from ..shallow_copies import shallow
from .bodies import Bodies
from .path_calls import PathRows
from .vehicle_steps import MOST, VehicleSteps, columns_after


@dataclass
class Motion:
    """Columns (N,) over agents, changed as time goes on. SI units and radians."""

    along: Floats
    """arc length of the foot point on the line"""
    offset: Floats
    """left of the line"""
    speed: Floats
    """along the body"""
    slide: Floats
    """speed to the left of the body"""
    yaw_rate: Floats
    cosine: Floats
    """of the heading from that of the line"""
    sine: Floats
    tangent: Floats
    """of the steering angle"""
    line_heading: Floats
    """at the foot point"""
    acceleration: Floats
    """along the body, in the last step"""

    def take(self, rows: Any) -> Motion:
        """That of some agents, in separate arrays."""
        return Motion(**{name: getattr(self, name)[rows] for name in MOTION_COLUMNS})

    @property
    def columns(self) -> tuple[Floats, ...]:
        """All of them, in their order."""
        return (
            self.along, self.offset, self.speed, self.slide, self.yaw_rate, self.cosine,
            self.sine, self.tangent, self.line_heading, self.acceleration,
        )  # fmt: skip

    def copied(self) -> Motion:
        """The same columns, which may be replaced apart."""
        return shallow(self)

    def put(self, rows: Any, other: Motion) -> None:
        """Some agents move as they do in `other`."""
        if isinstance(rows, np.ndarray) and rows.dtype == np.bool_:
            rows = rows.nonzero()[0]  # once, and not for each column
        for name in MOTION_COLUMNS:
            column = getattr(self, name).copy()
            column[rows] = getattr(other, name)[rows]
            setattr(self, name, column)

    def face(self, turning: Booleans, heading: Floats) -> None:
        """Who is on foot turns to a heading, at once."""
        rows = np.flatnonzero(turning)
        if len(rows):
            error = heading[rows] - self.line_heading[rows]
            self.cosine[rows], self.sine[rows] = np.cos(error), np.sin(error)
            self.tangent[rows] = 0.0

    def halt(self, rows: Any) -> None:
        """Some agents stand still, at once."""
        for column in (self.speed, self.slide, self.yaw_rate, self.acceleration):
            column[rows] = 0.0


MOTION_COLUMNS = tuple(field.name for field in fields(Motion))


_PARTS, _FEW, _SEVERAL = 64, 1024, 8
"""Tracks of some agents that are remembered, and of how many agents at most: with more of them the
look-up takes no time beside all else. Paths that are remembered."""


@dataclass(frozen=True)
class Track:
    """The line of each agent: columns (N,) of `lines` that every step needs."""

    lines: Lines
    row: Any
    first: Any
    last: Floats
    origin: Floats
    spacing: Floats
    per_meter: Floats
    length: Floats
    closed: Booleans
    has_closed: bool

    @classmethod
    def of(cls, lines: Lines, row: Any) -> Track:
        """`row`: (N,) the line of each agent."""
        spacing, closed = lines.spacing[row], lines.closed[row]
        return cls(
            lines,
            row,
            row * lines.cells,
            lines.last[row].astype(np.float64),
            lines.origin[row],
            spacing,
            1.0 / spacing,
            lines.length[row],
            closed,
            bool(closed.any()),
        )

    @cached_property
    def places(self) -> Floats:
        """(4, N) what the compiled motion has to know of the lines."""
        return np.array((self.last, self.origin, self.spacing, self.per_meter))

    @cached_property
    def _starts(self) -> Floats:
        """`first` as numbers."""
        return np.asarray(self.first, dtype=np.float64)

    def __getstate__(self) -> dict[str, Any]:
        """Without what is known by the identity or the memory of arrays, which copies do not
        share."""
        return {name: one for name, one in self.__dict__.items() if name not in _IN_MEMORY}

    def steps(self, walks: Booleans, dt: float) -> VehicleSteps:
        """Those of the agents, of whom some walk."""
        known = self.__dict__.get("_steps")
        if known is None or known[0] is not walks or known[1] != dt:
            places = self.last, self.origin, self.spacing, self.per_meter
            found = VehicleSteps(self.lines.table, self.first, np.array(places), walks, dt)
            known = self.__dict__["_steps"] = walks, dt, found
        steps: VehicleSteps = known[2]
        return steps

    def paths(self, rows: Any, distances: tuple[float, ...]) -> PathRows | None:
        """Those of some agents, with points at some distances. None when the very array that names
        these agents is here for the first time: that may be the only one. All agents have a slice
        for a name, and theirs are made at once."""
        known = self._paths.get(id(rows))
        if known is None or known[1] != distances:
            if len(self._paths) >= _SEVERAL:
                self._paths.clear()
            known = self._paths[id(rows)] = rows, distances, None
            if not isinstance(rows, slice):
                return None
        if known[2] is None:
            part = self.of_rows(rows)
            found = PathRows(part.lines.table, part.first, part.places, distances)
            known = self._paths[id(rows)] = rows, distances, found
        return known[2]

    @cached_property
    def _paths(self) -> dict[int, tuple[Any, tuple[float, ...], PathRows | None]]:
        """As `_parts`."""
        return {}

    def wrap(self, motion: Motion) -> None:
        """On closed lines, arc length begins anew after a lap."""
        if self.has_closed:
            over = np.floor(motion.along / self.length) * self.closed
            motion.along = motion.along - over * self.length
            motion.line_heading = motion.line_heading - over * self.lines.turn[self.row]

    def of_rows(self, rows: Any) -> Track:
        """That of some agents."""
        if isinstance(rows, slice):
            return self
        known = self._parts.get(id(rows))
        if known is not None:
            return known[1]
        closed, places = self.closed[rows], np.ascontiguousarray(self.places[:, rows])
        last, origin, spacing, per_meter = places
        has_closed = self.has_closed and bool(np.count_nonzero(closed))
        part = Track(
            self.lines, self.row[rows], self.first[rows], last, origin, spacing, per_meter,
            self.length[rows], closed, has_closed,
        )  # fmt: skip
        part.__dict__["places"] = places
        if len(closed) <= _FEW:
            if len(self._parts) >= _PARTS:
                self._parts.clear()
            self._parts[id(rows)] = rows, part
        return part

    @cached_property
    def _parts(self) -> dict[int, tuple[Any, Track]]:
        """Tracks of agents by the very arrays that name them: the same in every step, never written
        to. Each is kept with its track, so that its identity remains its own."""
        return {}

    def wrapped(self, along: Floats) -> Floats:
        """Arc lengths, on closed lines within one lap."""
        if not self.has_closed:
            return along
        within: Floats = along - np.floor(along / self.length) * self.closed * self.length
        return within

    def cell(self, along: Floats) -> tuple[Any, Floats]:
        """(N,) the cells at arc lengths, and the distance from where each begins."""
        advance = along - self.origin
        place = np.floor(np.minimum(np.maximum(advance * self.per_meter, 0.0), self.last))
        return (self._starts + place).astype(np.int64), advance - place * self.spacing

    def bend(self, along: Floats) -> tuple[Floats, Floats]:
        """(N,) curvature and heading of the lines at arc lengths."""
        cell, rest = self.cell(along)
        curvature = self.lines.curvature[cell]
        return curvature, self.lines.heading[cell] + curvature * rest

    def bend_of(self, rows: Integers, along: Floats) -> tuple[Floats, Floats]:
        """(n,) the same of some agents, who are others each time: no `Track` is made for them."""
        last, origin, spacing, per_meter = self.places.take(rows, axis=1)
        advance = along - origin
        place = np.floor(np.minimum(np.maximum(advance * per_meter, 0.0), last))
        cell = (place + self._starts.take(rows)).astype(np.int64)
        curvature, heading = self.lines.in_cells(cell, *_BEND)
        return curvature, heading + curvature * (advance - place * spacing)


_BEND = CELL.index("curvature"), CELL.index("heading")
_IN_MEMORY = ("_parts", "_steps", "_paths")


Advance = Callable[[Motion, Bodies, Track, tuple[Floats, Floats], int, float], None]
"""Something that does what `advance` does."""


def advance(
    motion: Motion, car: Bodies, track: Track, wanted: tuple[Floats, Floats], steps: int, dt: float
) -> None:
    """Move on by some steps of `dt` seconds. `wanted`: tangent of the steering angle, held within
    what the agent can steer; acceleration."""
    before = [getattr(motion, name) for name in MOTION_COLUMNS]
    after: Iterable[Floats]
    if len(before[0]) > MOST:
        walks = car.walks if car.walks.any() else None
        after = columns_after(before, car.in_order, wanted, walks, track.bend, steps, dt)
    else:
        after = track.steps(car.walks, dt).drive(before, car, wanted, steps)
    for name, column in zip(MOTION_COLUMNS, after, strict=True):
        setattr(motion, name, column)
