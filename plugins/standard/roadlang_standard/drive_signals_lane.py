"""Where an agent is on its road: `ego.lane`, `ego.off_road`, `ego.speed_limit`, `ego.red_light`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class LaneSignal(DriveSignal):
    """Id of the lane in which the center of the agent is, as in OpenDRIVE; beside the road that of
    the outermost lane, in a junction that of the lane from which the agent comes."""

    name: ClassVar[str] = "lane"
    unit: ClassVar[str] = ""
    is_integer: ClassVar[bool] = True
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.lane
        return values


@dataclass(frozen=True)
class LaneOffset(DriveSignal):
    """Lateral distance of the agent from the middle of its lane, positive to its left."""

    name: ClassVar[str] = "lane_offset"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.lane_offset
        return values


@dataclass(frozen=True)
class RouteProgress(DriveSignal):
    """Distance that the agent has driven along its route or road since the start, in meters;
    `progress` is the share of its path, from 0 to 1."""

    name: ClassVar[str] = "route_progress"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.route_progress
        return values


@dataclass(frozen=True)
class SpeedLimitSignal(DriveSignal):
    """Speed limit of the lane in which the agent is; infinite where there is none."""

    name: ClassVar[str] = "speed_limit"
    unit: ClassVar[str] = "m/s"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.speed_limit
        return values


@dataclass(frozen=True)
class OffRoad(DriveSignal):
    """How far the footprint of the agent sticks out of the drivable area, at its worst corner;
    negative while all of it is within."""

    name: ClassVar[str] = "off_road"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.off_road
        return values


@dataclass(frozen=True)
class RedLight(DriveSignal):
    """Number of stop lines that the front of the agent has crossed at a red light so far."""

    name: ClassVar[str] = "red_light"
    unit: ClassVar[str] = ""
    is_integer: ClassVar[bool] = True
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.red_light
        return values
