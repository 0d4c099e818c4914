"""Signals over the time of a drive: `ego.speed`, `distance(ego, walker)`, `time`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, AgentOrObject, DriveSignal, option

from .separation import middles, nearest, outlines, rate

if TYPE_CHECKING:
    from roadlang.api import Trace
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Speed(DriveSignal):
    """Speed."""

    name: ClassVar[str] = "speed"
    unit: ClassVar[str] = "m/s"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.speed
        return values


@dataclass(frozen=True)
class AccelerationSignal(DriveSignal):
    """Longitudinal acceleration; negative when braking."""

    name: ClassVar[str] = "acceleration"
    unit: ClassVar[str] = "m/s^2"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.acceleration
        return values


@dataclass(frozen=True)
class CrossTrack(DriveSignal):
    """Lateral distance from the path that the agent follows, positive to the left."""

    name: ClassVar[str] = "cross_track_error"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.cross_track_error
        return values


@dataclass(frozen=True)
class Progress(DriveSignal):
    """Share of the path that the agent has completed, from 0 to 1; `route_progress` is the distance
    in meters."""

    name: ClassVar[str] = "progress"
    unit: ClassVar[str] = ""
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.progress
        return values


@dataclass(frozen=True)
class Station(DriveSignal):
    """Arc length along the road of the agent."""

    name: ClassVar[str] = "station"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.station
        return values


@dataclass(frozen=True)
class Steering(DriveSignal):
    """Steering angle of the front wheels, positive to the left."""

    name: ClassVar[str] = "steering"
    unit: ClassVar[str] = "rad"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.steering
        return values


@dataclass(frozen=True)
class East(DriveSignal):
    """Position east of the origin, of the center of the agent."""

    name: ClassVar[str] = "x"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.x
        return values


@dataclass(frozen=True)
class North(DriveSignal):
    """Position north of the origin, of the center of the agent."""

    name: ClassVar[str] = "y"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.y
        return values


@dataclass(frozen=True)
class HeadingSignal(DriveSignal):
    """Heading, counter-clockwise from east."""

    name: ClassVar[str] = "heading"
    unit: ClassVar[str] = "rad"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.heading
        return values


@dataclass(frozen=True)
class LateralAcceleration(DriveSignal):
    """Lateral acceleration: speed times yaw rate, positive to the left."""

    name: ClassVar[str] = "lateral_acceleration"
    unit: ClassVar[str] = "m/s^2"
    looks_back: ClassVar[float] = 1
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        return rate(self.agent.heading, self.agent.time) * self.agent.speed


@dataclass(frozen=True)
class JerkSignal(DriveSignal):
    """Jerk: rate of change of the acceleration."""

    name: ClassVar[str] = "jerk"
    unit: ClassVar[str] = "m/s^3"
    looks_back: ClassVar[float] = 1
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        return rate(self.agent.acceleration, self.agent.time)


@dataclass(frozen=True)
class YawRate(DriveSignal):
    """Yaw rate, positive to the left."""

    name: ClassVar[str] = "yaw_rate"
    unit: ClassVar[str] = "rad/s"
    looks_back: ClassVar[float] = 1
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        return rate(self.agent.heading, self.agent.time)


@dataclass(frozen=True)
class Contacts(DriveSignal):
    """Number of bodies in contact with the agent, not counting the ground."""

    name: ClassVar[str] = "contacts"
    unit: ClassVar[str] = ""
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.contacts
        return values


@dataclass(frozen=True)
class Present(DriveSignal):
    """1 while the agent is there, 0 once it has left at the end of its road or route."""

    name: ClassVar[str] = "present"
    unit: ClassVar[str] = ""
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.present
        return values


@dataclass(frozen=True)
class DistanceSignal(DriveSignal):
    """Distance between the centers of two agents or objects; for a group, of its nearest member."""

    name: ClassVar[str] = "distance"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    member: ClassVar[bool] = False
    first: AgentOrObject = option(help="an agent, an object or a group of them")
    second: AgentOrObject = option(help="another agent, object or group")

    def values(self) -> Floats:
        return nearest(self.first, self.second, middles)


@dataclass(frozen=True)
class GapSignal(DriveSignal):
    """Gap between the outlines of two agents or objects; for a group, of its nearest member."""

    name: ClassVar[str] = "gap"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    member: ClassVar[bool] = False
    first: AgentOrObject = option(help="an agent, an object or a group of them")
    second: AgentOrObject = option(help="another agent, object or group")

    def values(self) -> Floats:
        return nearest(self.first, self.second, outlines)


@dataclass(frozen=True)
class Time(DriveSignal):
    """Time since the start of the drive."""

    name: ClassVar[str] = "time"
    unit: ClassVar[str] = "s"
    looks_back: ClassVar[float] = 0
    member: ClassVar[bool] = False

    def values_in(self, trace: Trace) -> Floats:
        return trace.time
