"""The cross-section of a road: its lanes from left to right."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Booleans, Floats, Integers
from ..curves.profile import OffsetProfile
from ..curves.width import WidthProfile
from ..errors import GeometryError
from .lane import Lane
from .lanes import Direction, Marking, lane_ids


def border_offsets(
    widths: Floats, drivable: Booleans, center: int, offset: Floats | None
) -> Floats:
    """(L + 1, ...) lateral offsets of the borders of lanes, from left to right, left positive.

    `widths` (L, ...) and `drivable` (L,) are those of the lanes from left to right. `center` is the
    index of the border that lies `offset` meters left of the curve; without an offset the curve
    runs in the middle of the drivable lanes (of all, if none is drivable).
    """
    from_left = np.concatenate([np.zeros_like(widths[:1]), np.cumsum(widths, axis=0)])
    if offset is None:
        first, last = drivable_borders(drivable)
        return np.asarray((from_left[first] + from_left[last]) / 2.0 - from_left)
    return np.asarray(from_left[center] + offset - from_left)


def scaled_widths(widths: Floats, drivable: Booleans, total: Floats) -> Floats:
    """Widths (L, ...) with the drivable lanes stretched in proportion, until these and what lies
    between them are `total` (...) wide. All are stretched, if none is drivable.

    Raises GeometryError where what lies between them leaves them no width.
    """
    first, last = drivable_borders(drivable)
    stretched = drivable if drivable.any() else ~drivable
    stretched_width = widths[stretched].sum(axis=0)
    left = total - (widths[first:last].sum(axis=0) - stretched_width)
    if not (left > 0.0).all():
        raise GeometryError("the lanes between drivable lanes are wider than the road")
    with np.errstate(divide="ignore", invalid="ignore"):
        factor = left / stretched_width
    if not np.isfinite(factor).all():
        raise GeometryError("drivable lanes without width cannot be stretched")
    choice = stretched.reshape(-1, *(1,) * (widths.ndim - 1))
    return np.where(choice, widths * factor, widths)


def drivable_borders(drivable: Booleans) -> tuple[int, int]:
    """Indices of the outer borders of the drivable lanes; of all lanes if none is drivable."""
    places = np.flatnonzero(drivable)
    if len(places) == 0:
        return 0, len(drivable)
    return int(places[0]), int(places[-1]) + 1


@dataclass(frozen=True, eq=False)
class CrossSection:
    """The lanes of a road from left to right: ids n to 1, then -1 to -m.

    `center_marking` is the line between lanes 1 and -1, at the reference line; on a road whose
    lanes are all on one side it is their inner edge. `center_offset` is how far left of the curve
    the reference line lies (OpenDRIVE's laneOffset); without it the curve runs in the middle of
    the drivable lanes, as a center line read from a picture does. All arc lengths `s` are along
    the curve and may be arrays of any shape, which the results have too. Raises GeometryError for
    no lanes and for ids that do not run as above.
    """

    lanes: tuple[Lane, ...]
    center_marking: Marking = "none"
    center_offset: OffsetProfile | None = None

    def __post_init__(self) -> None:
        left, right = self._count_left, len(self.lanes) - self._count_left
        if not self.lanes:
            raise GeometryError("a road needs at least one lane")
        if self.ids != (*range(left, 0, -1), *range(-1, -right - 1, -1)):
            found = ", ".join(map(str, self.ids))
            raise GeometryError(
                f"from left to right the ids of lanes are n to 1, -1 to -m: {found}"
            )

    @classmethod
    def of_lane_count(
        cls, count: int, width: WidthProfile, *, oneway: bool = False
    ) -> CrossSection:
        """`count` driving lanes of equal width that share `width`, for right-hand traffic.

        Of an odd count the extra lane is on the right. A single lane lies on the curve and is
        for both directions; with `oneway` all lanes are on the right and run forward. Raises
        GeometryError for a count below 1.
        """
        if count < 1:
            raise GeometryError("a road needs at least one lane")
        ids = tuple(range(-1, -count - 1, -1)) if oneway else lane_ids(count)
        share = WidthProfile(width.stations, width.widths / count, width.period)
        lanes = []
        for id in ids:
            direction: Direction = "backward" if id > 0 else "forward"
            outermost = id in (ids[0], ids[-1]) and (id > 0 or id == ids[-1])
            marking: Marking = "solid" if outermost else "broken"
            lane = Lane(id, "drive", share, direction, marking=marking)
            lanes.append(replace(lane, direction="both") if count == 1 and not oneway else lane)
        two_way: Marking = "broken" if count < 4 else "double"
        return cls(tuple(lanes), "solid" if oneway or count == 1 else two_way)

    @property
    def ids(self) -> tuple[int, ...]:
        """From left to right."""
        return tuple(lane.id for lane in self.lanes)

    def lane(self, id: int) -> Lane:
        """The lane with this id. Raises GeometryError, which lists the ids, if there is none."""
        return self.lanes[self._place(id)]

    def border_offsets(self, s: ArrayLike) -> Floats:
        """(L + 1, ...) offsets of all borders from left to right, left positive, at `s` (...)."""
        s = np.asarray(s, dtype=np.float64)
        widths = np.stack([lane.width.at(s) for lane in self.lanes])
        offset = None if self.center_offset is None else self.center_offset.at(s)
        return border_offsets(widths, self._drivable, self._count_left, offset)

    @property
    def markings(self) -> tuple[Marking, ...]:
        """(L + 1) lines at the borders, in the order of `border_offsets`."""
        left = tuple(lane.marking for lane in self.lanes if lane.id > 0)
        right = tuple(lane.marking for lane in self.lanes if lane.id < 0)
        return (*left, self.center_marking, *right)

    def borders(self, id: int, s: ArrayLike) -> tuple[Floats, Floats]:
        """The offsets of the left and of the right border of a lane. Raises GeometryError."""
        place = self._place(id)
        borders = self.border_offsets(s)
        return borders[place], borders[place + 1]

    def offset(self, id: int, s: ArrayLike) -> Floats:
        """The lateral offset of the middle of a lane, left positive. Raises GeometryError."""
        left, right = self.borders(id, s)
        return np.asarray((left + right) / 2.0)

    def lane_width(self, id: int, s: ArrayLike) -> Floats:
        """The width of a lane. Raises GeometryError."""
        return self.lane(id).width.at(s)

    def width(self, s: ArrayLike) -> Floats:
        """The width of all lanes together."""
        left, right = self.half_widths(s)
        return np.asarray(left + right)

    def half_widths(self, s: ArrayLike) -> tuple[Floats, Floats]:
        """How far the road extends to the left and to the right of the curve."""
        borders = self.border_offsets(s)
        return borders[0], -borders[-1]

    def drivable_extent(self, s: ArrayLike) -> tuple[Floats, Floats]:
        """The offsets of the left and the right edge of the drivable lanes, left positive.

        Of all lanes, where none is drivable. What lies between drivable lanes counts too.
        """
        first, last = drivable_borders(self._drivable)
        borders = self.border_offsets(s)
        return borders[first], borders[last]

    def drivable_width(self, s: ArrayLike) -> Floats:
        """From the left to the right edge of the drivable lanes: what a road's width means."""
        left, right = self.drivable_extent(s)
        return np.asarray(left - right)

    def drivable_profile(self) -> WidthProfile:
        """`drivable_width` at the stations of all widths."""
        periods = [lane.width.period for lane in self.lanes if lane.width.period is not None]
        period = min(periods, default=None)
        stations = self.stations
        return WidthProfile(stations, self.drivable_width(stations), period)

    @property
    def lane_count(self) -> int:
        """How many lanes are drivable; of all lanes, if none is."""
        return int(self._drivable.sum()) or len(self.lanes)

    def driving_ids(self, direction: Direction | None = None) -> tuple[int, ...]:
        """Ids of drivable lanes, innermost first, right before left.

        With a `direction` only those that may be used that way: lanes for both count for either.
        """
        wanted = (direction, "both")
        ids = [
            lane.id
            for lane in self.lanes
            if lane.drivable and (direction is None or lane.direction in wanted)
        ]
        return tuple(sorted(ids, key=lambda id: (abs(id), id)))

    def runs_backward(self, id: int) -> bool:
        """Whether traffic in a lane runs against the road; in a lane without a direction, such as
        one for parking, that of the driving lanes on its side. Raises GeometryError."""
        own = self.lane(id)
        beside = [lane.direction for lane in self.lanes if lane.drivable and lane.id * id > 0]
        directions = beside if own.direction == "none" and beside else [own.direction]
        return all(direction == "backward" for direction in directions)

    def entered_from(self, offset: float, s: float, *, backward: bool) -> float:
        """The offset of the middle of the driving lane for a direction that is nearest to a place
        beside the road; 0 where no lane is for that direction."""
        ids = self.driving_ids("backward" if backward else "forward")
        middles = [float(self.offset(id, s)) for id in ids]
        return min(middles, key=lambda middle: abs(middle - offset), default=0.0)

    def lane_at(self, offset: ArrayLike, s: ArrayLike) -> Integers:
        """The id of the lane at each lateral offset, 0 beside the road. The two broadcast.

        A border belongs to the lane on its right, the right edge of the road to its last lane.
        """
        away, at = np.broadcast_arrays(np.asarray(offset, float), np.asarray(s, float))
        borders = self.border_offsets(at)
        place = (borders[1:-1] >= away).sum(axis=0)
        inside = (away <= borders[0]) & (away >= borders[-1])
        return np.where(inside, np.array(self.ids, dtype=np.int64)[place], 0)

    def reversed(self, length: float) -> CrossSection:
        """As seen by who travels the road, `length` meters long, the other way."""
        lanes = tuple(
            replace(
                lane,
                id=-lane.id,
                width=lane.width.reversed(length),
                direction=lane.opposite_direction,
            )
            for lane in reversed(self.lanes)
        )
        offset = None if self.center_offset is None else self.center_offset.reversed(length)
        return CrossSection(lanes, self.center_marking, offset)

    def mirrored(self) -> CrossSection:
        """Left and right exchanged, so that right-hand traffic becomes left-hand traffic."""
        lanes = tuple(replace(lane, id=-lane.id) for lane in reversed(self.lanes))
        offset = None if self.center_offset is None else self.center_offset.mirrored()
        return CrossSection(lanes, self.center_marking, offset)

    def scaled(self, factor: float, width_factor: float | None = None) -> CrossSection:
        """Arc lengths times `factor`, widths and offsets times `width_factor` or the same."""
        lanes = (
            replace(lane, width=lane.width.scaled(factor, width_factor)) for lane in self.lanes
        )
        offset = self.center_offset
        if offset is not None:
            offset = offset.scaled(factor, width_factor)
        return replace(self, lanes=tuple(lanes), center_offset=offset)

    def scaled_to(self, width: WidthProfile) -> CrossSection:
        """Drivable lanes stretched in proportion, so that `drivable_width` becomes this.

        All other lanes keep their width. Where no lane is drivable, all are stretched. Raises
        GeometryError where lanes between drivable ones leave those no width.
        """
        stations = np.union1d(width.stations, self.stations)
        if width.period is not None:
            stations = np.unique(np.mod(stations, width.period))
        widths = np.stack([lane.width.at(stations) for lane in self.lanes])
        scaled = scaled_widths(widths, self._drivable, width.at(stations))
        fixed = self._drivable.any() & ~self._drivable
        lanes = (
            lane if keeps else replace(lane, width=WidthProfile(stations, new, width.period))
            for lane, new, keeps in zip(self.lanes, scaled, fixed, strict=True)
        )
        return replace(self, lanes=tuple(lanes))

    @cached_property
    def _count_left(self) -> int:
        return sum(lane.id > 0 for lane in self.lanes)

    @cached_property
    def stations(self) -> Floats:
        """(n,) at which the widths of its lanes are given."""
        return np.unique(np.concatenate([lane.width.stations for lane in self.lanes]))

    @cached_property
    def _drivable(self) -> Booleans:
        return np.array([lane.drivable for lane in self.lanes], dtype=bool)

    def _place(self, id: int) -> int:
        if id not in self.ids:
            known = ", ".join(map(str, self.ids))
            raise GeometryError(f"the road has no lane {id}; its lanes are {known}")
        return self.ids.index(id)
