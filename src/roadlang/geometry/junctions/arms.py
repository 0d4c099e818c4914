"""Arms: the ends of roads that meet at a place, as polylines that lead away from it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeAlias

import numpy as np

from ..arrays import Floats
from ..lanes.cross_section import CrossSection
from ..networks.junction_model import End
from ..networks.network import Edge
from .folds import Span, folded_spans, past

ArmKey: TypeAlias = tuple[int, End]

FARTHEST_TRIM = 110.0
"""Meters: roads that still touch there overlap, and no junction hides that."""
DEFAULT_TRIM = 60.0
"""Meters: the trim of arms that still touch there, and the farthest that a tight turn pushes."""
SPACING = 0.5
_OWN_SHARE = 0.45
ARM_LENGTH = 120.0
"""Meters of an arm that are looked at."""


@dataclass(frozen=True, slots=True)
class ArmLane:
    """A lane for motor vehicles at the face of an arm, seen from the junction along the road."""

    id: int
    offset: float
    """of its middle, left positive"""
    width: float
    inbound: bool
    outbound: bool


@dataclass(frozen=True, eq=False)
class ArmLine:
    """An arm, sampled from its node outwards: (n,) stations, (n, 2) points and left normals, and
    how far the road extends to the left and to the right."""

    edge: Edge
    end: End
    section: CrossSection
    s: Floats
    points: Floats
    heading: Floats
    left: Floats
    right: Floats
    _faces: dict[float, Face] = field(default_factory=dict, repr=False)

    @classmethod
    def of(cls, edge: Edge, end: End, section: CrossSection) -> ArmLine:
        """The first `ARM_LENGTH` meters, or half of a loop."""
        length = min(edge.length / (2.0 if edge.start == edge.end else 1.0), ARM_LENGTH)
        s = np.linspace(0.0, length, max(3, int(np.ceil(length / SPACING)) + 1))
        along = s if end == "start" else edge.length - s
        heading = edge.curve.heading(along)
        left, right = section.half_widths(along)
        if end == "end":
            heading, left, right = heading + np.pi, right, left
        return cls(edge, end, section, s, edge.curve.at(along), heading, left, right)

    def near_half(self) -> ArmLine:
        """Nearly to the middle of the road: what is its own where both its ends enter one place."""
        near = slice(0, max(3, int(np.searchsorted(self.s, _OWN_SHARE * self.length))))
        s, points, heading, left, right = (
            column[near] for column in (self.s, self.points, self.heading, self.left, self.right)
        )
        return ArmLine(self.edge, self.end, self.section, s, points, heading, left, right)

    @property
    def key(self) -> ArmKey:
        """The edge and which of its ends."""
        return self.edge.id, self.end

    @property
    def node(self) -> int:
        """Where it begins."""
        return self.edge.start if self.end == "start" else self.edge.end

    @property
    def length(self) -> float:
        """Meters of the whole road."""
        return self.edge.length

    @cached_property
    def normal(self) -> Floats:
        """(n, 2) to the left."""
        return np.stack([-np.sin(self.heading), np.cos(self.heading)], axis=-1)

    @cached_property
    def _folds(self) -> tuple[Span, ...]:
        borders = self.normal * self.left[:, None], -self.normal * self.right[:, None]
        return folded_spans(
            self.s, self.points, (self.points + borders[0], self.points + borders[1])
        )

    def past_folds(self, trim: float) -> float:
        """The least trim, no smaller than this one, from which on the road does not run back over
        what lies before its face."""
        return past(self._folds, trim)

    def along(self, trim: float) -> float:
        """The arc length of the road at a distance from the node."""
        return trim if self.end == "start" else self.length - trim

    def lanes(self, trim: float) -> tuple[ArmLane, ...]:
        """The lanes for motor vehicles, from left to right."""
        borders = self.section.border_offsets(self.along(trim)).tolist()
        sign, out = (1.0, "forward") if self.end == "start" else (-1.0, "backward")
        found = []
        for lane, left, right in zip(self.section.lanes, borders, borders[1:], strict=False):
            if not lane.drivable or lane.direction == "none":
                continue
            outbound = lane.direction in (out, "both")
            inbound = lane.direction == "both" or not outbound
            offset = sign * (left + right) / 2.0
            found.append(ArmLane(lane.id, offset, left - right, inbound, outbound))
        return tuple(found if self.end == "start" else reversed(found))

    def face(self, trim: float) -> Face:
        """Where the road begins, exactly."""
        if trim not in self._faces:
            self._faces[trim] = self._face(trim)
        return self._faces[trim]

    def _face(self, trim: float) -> Face:
        s = self.along(trim)
        (x, y), heading = self.edge.curve.at(s), float(self.edge.curve.heading(s))
        left, right = (float(half) for half in self.section.half_widths(s))
        if self.end == "end":
            return Face(float(x), float(y), heading + math.pi, right, left)
        return Face(float(x), float(y), heading, left, right)

    def borders(self, start: float, stop: float) -> tuple[Floats, Floats]:
        """The left and right border (n, 2) between two distances from the node: exact at faces that
        were requested before, and at samples."""
        s = self.s[(self.s > start + 1e-6) & (self.s < stop - 1e-6)]
        s = np.concatenate([[start], s, [stop]])
        columns = [self.points, self.normal, self.left[:, None], self.right[:, None]]
        points, normal, left, right = (_at(self.s, s, column) for column in columns)
        first, last = points + normal * left, points - normal * right
        for place, trim in ((0, start), (-1, stop)):
            if trim in self._faces:
                first[place], last[place] = (self._faces[trim].corner(side) for side in (1, -1))
        return first, last


def _at(s: Floats, wanted: Floats, values: Floats) -> Floats:
    """Columns (n, k) at stations between those at `s` (n,), linear."""
    return np.column_stack([np.interp(wanted, s, column) for column in values.T])


@dataclass(frozen=True, slots=True)
class Face:
    """The cross-section where an arm's road begins, seen from the junction along the road."""

    x: float
    y: float
    heading: float
    left: float
    right: float

    def beside(self, offset: float) -> tuple[float, float]:
        """The point `offset` meters to the left of the middle."""
        return (
            float(self.x - offset * np.sin(self.heading)),
            float(self.y + offset * np.cos(self.heading)),
        )

    def corner(self, side: int) -> tuple[float, float]:
        """The left (1) or the right (-1) end."""
        return self.beside(self.left if side > 0 else -self.right)


def nearest_on(points: Floats, line: Floats) -> tuple[Floats, Floats]:
    """The distance (n,) of points (n, 2) to a polyline (m, 2), and the place of the nearest point:
    (n,) vertex number, with the share of the step that follows."""
    start, step = line[:-1], np.diff(line, axis=0)
    squared = np.maximum((step**2).sum(axis=1), 1e-18)
    dx = points[:, None, 0] - start[None, :, 0]
    dy = points[:, None, 1] - start[None, :, 1]
    share = np.clip((dx * step[:, 0] + dy * step[:, 1]) / squared, 0.0, 1.0)
    gap = (dx - share * step[:, 0]) ** 2 + (dy - share * step[:, 1]) ** 2
    best = gap.argmin(axis=1)
    rows = np.arange(len(points))
    return np.sqrt(gap[rows, best]), best + share[rows, best]
