"""The JSON document of a trace, for its schema."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .schema import Schema, schema_of_dataclass

TRACE_SCHEMA = "roadlang.trace/2"

COLUMN_UNITS = {
    "time": "s", "x": "m", "y": "m", "heading": "rad", "speed": "m/s", "acceleration": "m/s^2",
    "steering": "rad", "station": "m", "cross_track_error": "m", "progress": "", "contacts": "",
    "road": "", "lane": "", "lane_offset": "m", "route_progress": "m", "speed_limit": "m/s",
    "off_road": "m", "red_light": "", "collision": "m/s", "present": "", "elevation": "m",
}  # fmt: skip
"""What the columns of a trace are in; nothing for plain numbers."""

Column = tuple[float | None, ...]


@dataclass(frozen=True, slots=True)
class AgentColumns:
    """One agent, or a copy of a group; a value for each time, null where none was recorded."""

    x: Column
    """meters east, of the center of the footprint"""
    y: Column
    """meters north"""
    heading: Column
    """radians counter-clockwise from east"""
    speed: Column
    """m/s"""
    acceleration: Column
    """m/s2 along the heading"""
    steering: Column
    """radians, of the front wheels, left positive"""
    station: Column
    """meters along the road of the agent"""
    cross_track_error: Column
    """meters from the line that it should follow, left positive"""
    progress: Column
    """the share of the road that is driven, 0 to 1"""
    contacts: Column
    """how many bodies it touches, without the ground"""
    length: float
    """meters"""
    width: float
    """meters"""
    road: Column = ()
    """number of the road in the scene, -1 inside a junction"""
    lane: Column = ()
    """id of the lane of its center, in a junction of the lane that it comes from"""
    lane_offset: Column = ()
    """meters from the middle of that lane, positive to the left of the agent"""
    route_progress: Column = ()
    """meters driven along its route or road"""
    speed_limit: Column = ()
    """m/s, of the lane; null where there is none"""
    off_road: Column = ()
    """meters by which the footprint sticks out of the drivable area, negative within"""
    red_light: Column = ()
    """how many stop lines it has crossed at red so far"""
    collision: Column = ()
    """m/s, relative speed of its hardest impact so far, 0 before the first"""
    present: Column = ()
    """1, and 0 once it has left at the end of its road or route"""
    elevation: Column = ()
    """meters, of the ground below it; only where roads of the scene have heights"""


@dataclass(frozen=True, slots=True)
class TraceDocument:
    """A drive of one scene, as `roadlang run` writes it. SI units and radians."""

    engine: str
    """the simulator, as it calls itself"""
    time: Column
    """seconds from the start"""
    agents: Mapping[str, AgentColumns]
    """by name; the third of the group `oncoming` is `oncoming[2]`"""
    events: tuple[Mapping[str, Any], ...]
    """what else happened: contacts, and controllers that failed while the drive went on"""
    schema: str = TRACE_SCHEMA


def trace_schema() -> Schema:
    """The JSON Schema of a trace."""
    return schema_of_dataclass(TraceDocument)
