"""The lanes of a road in many candidates: where they lie, and the cross-section of one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...diagnostics import Code, DiagnosticError, diagnose
from ...geometry import CrossSection, GeometryError, Lane, OffsetProfile, WidthProfile
from ...geometry.arrays import Floats
from ...geometry.lanes.cross_section import border_offsets, drivable_borders, scaled_widths
from ...ir.scenario import ScenarioNetwork, ScenarioRoad


@dataclass(frozen=True, eq=False)
class LaneBatch:
    """The lanes of a road in V candidates that differ in widths and speed limits alone.

    `pattern` says which lanes there are. `widths` has, by id, columns (V, 1) of those that are
    drawn; `speed_limits`, by id, numbers or columns. All are proportions: the drivable lanes share
    the width of the road, and the others keep theirs.
    """

    pattern: CrossSection
    widths: dict[int, Floats]
    speed_limits: dict[int, Any]
    source: ScenarioRoad | ScenarioNetwork | None = None
    """The statement that is at fault where the lanes do not fit the road."""

    @property
    def variants(self) -> int:
        """V, or 1 where all candidates have the same lanes."""
        columns = (*self.widths.values(), *self.speed_limits.values())
        return max((len(column) for column in map(np.atleast_1d, columns)), default=1)

    def border_offsets(self, width: Floats, s: Floats) -> Floats:
        """(L + 1, V, n) offsets of the borders, from left to right, left positive.

        `width` (V, n) is the width of the road there, `s` (V, n) or (n,) arc length of its root.
        """
        offset = self.pattern.center_offset
        center = sum(id > 0 for id in self.pattern.ids)
        widths = self.lane_widths(width, s)
        return border_offsets(
            widths, self._drivable, center, None if offset is None else offset.at(s)
        )

    def lane_widths(self, width: Floats, s: Floats) -> Floats:
        """(L, V, n) widths of the lanes from left to right, where the road is `width` (V, n).

        Raises RL431 where that leaves the drivable lanes none.
        """
        widths = self._written(width, s)
        try:
            return scaled_widths(widths, self._drivable, np.broadcast_to(width, widths.shape[1:]))
        except GeometryError:
            name, span = (self.source.name, self.source.span) if self.source else ("", None)
            raise DiagnosticError(diagnose(Code.NO_WIDTH_FOR_LANES, span, name=name)) from None

    def extent(self) -> Floats:
        """(V, 1) width of the drivable lanes, with what lies between them, as written."""
        zero = np.zeros((1, 1))
        widths = self._written(zero, zero)
        first, last = drivable_borders(self._drivable)
        return np.asarray(widths[first:last].sum(axis=0))

    @cached_property
    def roadway_borders(self) -> tuple[int, int]:
        """The borders, counted from the left, to the left and to the right of what who crosses the
        road on foot crosses: up to the curb, or where there is none to the outermost lane that
        vehicles or riders use."""
        lanes = self.pattern.lanes
        first, last = drivable_borders(self._drivable)
        return first - _beyond(lanes[:first][::-1]), last + _beyond(lanes[last:])

    def cross_section(self, width: WidthProfile, s: Floats) -> CrossSection:
        """Of a single candidate: `s` (n,) is arc length of the root at the stations of `width`."""
        widths = self.lane_widths(width.widths[None, :], s)[:, 0]
        lanes = []
        for lane, across in zip(self.pattern.lanes, widths, strict=True):
            profile = WidthProfile(width.stations, across, width.period)
            limit = self.speed_limits.get(lane.id, lane.speed_limit)
            limit = None if limit is None else float(np.asarray(limit).reshape(-1)[0])
            lanes.append(replace(lane, width=profile, speed_limit=limit))
        offset = self.pattern.center_offset
        if offset is not None:
            offset = OffsetProfile(width.stations, offset.at(s), width.period)
        return replace(self.pattern, lanes=tuple(lanes), center_offset=offset)

    def take(self, rows: NDArray[np.intp]) -> LaneBatch:
        """The lanes of the candidates at `rows`."""
        widths = {id: column[_rows(column, rows)] for id, column in self.widths.items()}
        limits = {
            id: limit[_rows(limit, rows)] if isinstance(limit, np.ndarray) else limit
            for id, limit in self.speed_limits.items()
        }
        return replace(self, widths=widths, speed_limits=limits)

    def reversed(self, length: float) -> LaneBatch:
        """As seen by who travels the road, `length` meters long, the other way."""
        return replace(
            self,
            pattern=self.pattern.reversed(length),
            widths={-id: width for id, width in self.widths.items()},
            speed_limits={-id: limit for id, limit in self.speed_limits.items()},
        )

    @cached_property
    def _drivable(self) -> NDArray[np.bool_]:
        return np.array([lane.drivable for lane in self.pattern.lanes])

    def _written(self, width: Floats, s: Floats) -> Floats:
        columns = [self.widths.get(lane.id, lane.width.at(s)) for lane in self.pattern.lanes]
        shape = np.broadcast_shapes(np.shape(width), np.shape(s), *map(np.shape, columns))
        return np.stack([np.broadcast_to(column, shape) for column in columns])


def _rows(column: Floats, rows: NDArray[np.intp]) -> NDArray[np.intp] | slice:
    return rows if len(column) > 1 else slice(None)


def _beyond(outward: Sequence[Lane]) -> int:
    """How many lanes beside the drivable ones, from these outward, belong to the roadway."""
    for number, lane in enumerate(outward):
        if lane.raised:
            return number
    return max((number for number, lane in enumerate(outward, 1) if lane.users), default=0)
