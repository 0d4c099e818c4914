"""What an OpenDRIVE file says of roads and junctions, in its own terms: meters and radians."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, TypeAlias

from roadlang_formats.map_xml import MapElement

Contact: TypeAlias = Literal["start", "end"]
OTHER_END: Mapping[Contact, Contact] = {"start": "end", "end": "start"}
Shape: TypeAlias = Literal["line", "arc", "spiral", "poly3", "paramPoly3"]


@dataclass(frozen=True, slots=True)
class Cubic:
    """`a + b t + c t^2 + d t^3`, with t counted from `start`, which is an `s` or an `sOffset`."""

    start: float
    a: float
    b: float
    c: float
    d: float


@dataclass(frozen=True, slots=True)
class GeometryRecord:
    """A piece of a reference line. `numbers` are those of its kind: curvatures, or coefficients."""

    element: MapElement
    kind: Shape
    s: float
    x: float
    y: float
    heading: float
    length: float
    numbers: tuple[float, ...] = ()
    normalized: bool = False


@dataclass(frozen=True, slots=True)
class MarkRecord:
    """From where on a line is of this type."""

    start: float
    type: str


@dataclass(frozen=True, slots=True)
class LaneRecord:
    """A lane in one section. `widths` are across it; `borders`, which only a lane without widths
    has, are from the reference line."""

    element: MapElement
    id: int
    type: str
    direction: str
    widths: tuple[Cubic, ...]
    borders: tuple[Cubic, ...]
    marks: tuple[MarkRecord, ...]
    speed: float | None
    predecessor: int | None
    successor: int | None


@dataclass(frozen=True, slots=True)
class SectionRecord:
    """Lanes by their ids, from `s` on; 0 is the center line."""

    element: MapElement
    s: float
    lanes: Mapping[int, LaneRecord]


@dataclass(frozen=True, slots=True)
class RoadLink:
    """What a road leads to at one of its ends."""

    kind: Literal["road", "junction"]
    id: str
    contact: Contact


@dataclass(frozen=True, slots=True)
class SignalRecord:
    """A light or sign at a road, or a reference to one by its id, which has no type of its own.

    `orientation`: + for traffic in the direction of the road, - for the other, else both.
    """

    id: str
    s: float
    type: str
    is_dynamic: bool
    orientation: str


@dataclass(frozen=True, slots=True)
class RoadRecord:
    """A road. `junction` is empty for a road outside of junctions; `speed` is m/s."""

    element: MapElement
    id: str
    name: str
    length: float
    junction: str
    left_hand: bool
    predecessor: RoadLink | None
    successor: RoadLink | None
    geometry: tuple[GeometryRecord, ...]
    elevation: tuple[Cubic, ...]
    lane_offset: tuple[Cubic, ...]
    sections: tuple[SectionRecord, ...]
    speed: float | None
    signals: tuple[SignalRecord, ...] = ()
    reverse_of: str = ""
    """the id of a road on the same ground with a single lane, which this one has for the other
    direction"""
    left_hand_of: str = ""
    """the id of the road beside this one with the traffic that comes toward it, on its right"""

    def link(self, end: Contact) -> RoadLink | None:
        """What it leads to at this end."""
        return self.predecessor if end == "start" else self.successor


@dataclass(frozen=True, slots=True)
class ConnectionRecord:
    """How a road leads into a connecting road, or, without one, into another road."""

    element: MapElement
    incoming: str
    connecting: str
    contact: Contact
    lanes: tuple[tuple[int, int], ...]
    direct: bool


@dataclass(frozen=True, slots=True)
class JunctionRecord:
    """A junction."""

    element: MapElement
    id: str
    name: str
    connections: tuple[ConnectionRecord, ...]


@dataclass(frozen=True, slots=True)
class OpenDriveRecord:
    """All of a file. `origin`: latitude and longitude of (0, 0) in degrees, where it says so."""

    roads: Mapping[str, RoadRecord]
    junctions: Mapping[str, JunctionRecord]
    origin: tuple[float, float] | None
