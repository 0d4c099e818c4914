"""A road of a concrete scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from .read_only import Floats, packed_row, row_of, unpacked_row
from .scene_lane import SceneLane
from .scene_surface import SurfaceName, SurfacePatch

if TYPE_CHECKING:
    from ..geometry import CrossSection


@dataclass(frozen=True, slots=True)
class RoadPart:
    """A part of a road of a network, in the direction in which another runs over it."""

    road: str
    """name of the road"""
    start: float
    """arc length where the part begins, meters"""
    stop: float
    """arc length where it ends; less than `start` against the direction of the road"""


@dataclass(frozen=True, slots=True)
class SpeedZone:
    """From where on a speed limit holds, up to the next zone or the end of the road."""

    start: float
    """arc length along the road, meters"""
    speed_limit: float | None
    """m/s, of lanes that have none of their own; null for none"""


class _OfRows:
    __slots__ = ("_rows",)

    _rows: Mapping[str, Any]
    """of a road of `with_rows`"""


@dataclass(frozen=True, slots=True)
class SceneRoad(_OfRows):
    """One curve. The tuples have a number for each of its stations."""

    name: str
    """as declared; `town/3` for edge 3 of network `town`"""
    stations: tuple[float, ...] = field(repr=False)
    """arc length along this road, meters"""
    reference_stations: tuple[float, ...] = field(repr=False)
    """arc length of the root road at the same points, meters: the positions of the requirements"""
    x: tuple[float, ...] = field(repr=False)
    """meters east"""
    y: tuple[float, ...] = field(repr=False)
    """meters north"""
    heading: tuple[float, ...] = field(repr=False)
    """radians, counter-clockwise from east"""
    curvature: tuple[float, ...] = field(repr=False)
    """1/m, positive to the left"""
    width: tuple[float, ...] = field(repr=False)
    """of the drivable lanes, from edge to edge, meters"""
    lanes: int
    """how many drivable ones, both directions together"""
    closed: bool
    """whether the end joins the start"""
    length: float
    """meters; the last of the stations, and on a closed road from there on to the first"""
    root: str
    """the road that this one was perturbed from; itself, if none"""
    network: str | None = None
    """the network this is an edge of, else null"""
    edge: int | None = None
    """its number in the network"""
    derived: bool = False
    """true for what is drawn in full and built: the last road of a chain, and the roads of a
    network; not for what only runs over roads that are"""
    trim: tuple[float, float] = (0.0, 0.0)
    """of a road of a network: how far from its start and from its end the junctions there reach,
    meters of its `stations`; between lies the road. `SceneArm.trim` has the same place in its
    `reference_stations`"""
    lane_list: tuple[SceneLane, ...] = field(default=(), repr=False)
    """its lanes from left to right; empty in a scene of an earlier version: `lanes` equal ones"""
    center_marking: Literal["solid", "broken", "double", "none", "curb"] = "broken"
    """the line between lanes 1 and -1"""
    center_offset: tuple[float, ...] = field(default=(), repr=False)
    """how far left of the curve that line lies, meters: one number, or one for each station; empty:
    the drivable lanes lie in the middle"""
    speed_limit: float | None = None
    """m/s, of lanes that have none of their own; null where nothing is said"""
    speed_zones: tuple[SpeedZone, ...] = ()
    """of a road joined of several: where another `speed_limit` begins, in order; empty: it is the
    same everywhere"""
    street: str = ""
    """its name in the map that it is from"""
    elevation: tuple[float, ...] = field(default=(), repr=False)
    """meters above the origin at each station, where the map has it or roads pass over others; with
    it the embedded engine tells the levels of roads apart"""
    along: tuple[RoadPart, ...] = ()
    """of a road that was selected from a network and not perturbed itself: what it runs over"""
    surface: SurfaceName | None = None
    """what it is made of or covered by; null: asphalt, as the weather leaves it"""
    surface_patches: tuple[SurfacePatch, ...] = ()
    """stretches of other surfaces; where some overlap the last one counts"""

    def zones(self) -> tuple[SpeedZone, ...]:
        """At least one, the first from the start of the road."""
        return self.speed_zones or (SpeedZone(0.0, self.speed_limit),)

    def limit_at(self, station: float, of_lane: float | None = None) -> float | None:
        """m/s: the limit of a lane if it has its own (`of_lane`), else that of the road at an arc
        length; None where nothing is said."""
        zones = self.zones()
        there = [zone.speed_limit for zone in zones if zone.start <= station or zone is zones[0]]
        return there[-1] if of_lane is None else of_lane

    def cross_section(self) -> CrossSection:
        """The lanes as geometry has them, by arc length along this road.

        Raises GeometryError for lanes that cannot be.
        """
        from .scene_section import equal_lanes, listed_lanes

        period = self.length if self.closed else None
        if not self.lane_list:
            return equal_lanes(self.lanes, self.stations, self.width, period)
        marking, offset = self.center_marking, self.center_offset
        return listed_lanes(self.lane_list, marking, offset, self.stations, period)

    def __reduce__(self) -> tuple[Any, ...]:
        # With the arrays: tuples are made of them where they are read.
        rows = _rows_of(self)
        others = {n: getattr(self, n) for n in self.__dataclass_fields__ if n not in rows}
        return _unpickled, (others, {name: packed_row(row) for name, row in rows.items()})

    if not TYPE_CHECKING:  # where it would hide what is no member

        def __getattr__(self, name: str) -> Floats:
            row = _rows_of(self).get(name) if name != "_rows" else None
            if row is None:
                raise AttributeError(f"a road of a scene has no member `{name}`")
            numbers = Floats.of_row(row.tolist(), row)
            object.__setattr__(self, name, numbers)
            return numbers


def with_rows(road: SceneRoad, rows: Mapping[str, Any], **others: Any) -> SceneRoad:
    """The road with other members. Those that are tuples of numbers are given as read-only arrays
    in `rows`, and are made of these when they are first read: few of the many scenes that a search
    drives are ever written."""
    names = SceneRoad.__dataclass_fields__.keys() - rows.keys()
    return _road({n: others[n] if n in others else getattr(road, n) for n in names}, rows)


def _road(members: Mapping[str, Any], rows: Mapping[str, Any]) -> SceneRoad:
    found = object.__new__(SceneRoad)
    for name, value in members.items():
        object.__setattr__(found, name, value)
    object.__setattr__(found, "_rows", rows)
    return found


def _unpickled(members: Mapping[str, Any], rows: Mapping[str, bytes]) -> SceneRoad:
    return _road(members, {name: unpacked_row(content) for name, content in rows.items()})


def numbers_of(road: SceneRoad, name: str) -> Any:
    """The numbers of a member as an array to read (S,), without a tuple of them."""
    return all_numbers_of(road, (name,))[0]


def all_numbers_of(road: SceneRoad, names: Sequence[str]) -> list[Any]:
    """Those of several members."""
    rows = _rows_of(road)
    return [rows[name] if name in rows else row_of(getattr(road, name)) for name in names]


def _rows_of(road: SceneRoad) -> Mapping[str, Any]:
    return getattr(road, "_rows", {})
