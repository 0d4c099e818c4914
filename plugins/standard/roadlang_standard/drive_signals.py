"""What can be said of a drive: `ego.speed`, `distance(ego, walker)`, `time`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, AgentOrObject, DriveSignal, option

from .separation import middles, nearest, outlines, rate

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import Trace

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Speed(DriveSignal):
    """How fast it drives."""

    name: ClassVar[str] = "speed"
    unit: ClassVar[str] = "m/s"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.speed
        return values


@dataclass(frozen=True)
class AccelerationSignal(DriveSignal):
    """How its speed changes; braking is negative."""

    name: ClassVar[str] = "acceleration"
    unit: ClassVar[str] = "m/s^2"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.acceleration
        return values


@dataclass(frozen=True)
class CrossTrack(DriveSignal):
    """Distance from the line it should follow, left positive."""

    name: ClassVar[str] = "cross_track"
    unit: ClassVar[str] = "m"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.cross_track
        return values


@dataclass(frozen=True)
class Progress(DriveSignal):
    """Share of its road that is behind it, from 0 to 1."""

    name: ClassVar[str] = "progress"
    unit: ClassVar[str] = ""
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.progress
        return values


@dataclass(frozen=True)
class Station(DriveSignal):
    """Arc length along its road."""

    name: ClassVar[str] = "station"
    unit: ClassVar[str] = "m"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.station
        return values


@dataclass(frozen=True)
class Steering(DriveSignal):
    """Angle of the front wheels, left positive."""

    name: ClassVar[str] = "steering"
    unit: ClassVar[str] = "rad"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.steering
        return values


@dataclass(frozen=True)
class HeadingSignal(DriveSignal):
    """Where it points, counter-clockwise from east."""

    name: ClassVar[str] = "heading"
    unit: ClassVar[str] = "rad"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.heading
        return values


@dataclass(frozen=True)
class LateralAcceleration(DriveSignal):
    """Speed times rate of turn, left positive."""

    name: ClassVar[str] = "lateral_acceleration"
    unit: ClassVar[str] = "m/s^2"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        return rate(self.agent.heading, self.agent.time) * self.agent.speed


@dataclass(frozen=True)
class JerkSignal(DriveSignal):
    """How its acceleration changes."""

    name: ClassVar[str] = "jerk"
    unit: ClassVar[str] = "m/s^3"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        return rate(self.agent.acceleration, self.agent.time)


@dataclass(frozen=True)
class YawRate(DriveSignal):
    """How fast it turns, left positive."""

    name: ClassVar[str] = "yaw_rate"
    unit: ClassVar[str] = "rad/s"
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        return rate(self.agent.heading, self.agent.time)


@dataclass(frozen=True)
class Contacts(DriveSignal):
    """How many things it touches, the ground apart."""

    name: ClassVar[str] = "contacts"
    unit: ClassVar[str] = ""
    agent: AgentName = option(help="who")

    def values(self) -> Floats:
        values: Floats = self.agent.contacts
        return values


@dataclass(frozen=True)
class DistanceSignal(DriveSignal):
    """Distance between the middles of two agents or objects; of a group, the nearest."""

    name: ClassVar[str] = "distance"
    unit: ClassVar[str] = "m"
    member: ClassVar[bool] = False
    one: AgentOrObject = option(help="one")
    other: AgentOrObject = option(help="the other")

    def values(self) -> Floats:
        return nearest(self.one, self.other, middles)


@dataclass(frozen=True)
class GapSignal(DriveSignal):
    """Free space between the outlines of two agents or objects; of a group, the nearest."""

    name: ClassVar[str] = "gap"
    unit: ClassVar[str] = "m"
    member: ClassVar[bool] = False
    one: AgentOrObject = option(help="one")
    other: AgentOrObject = option(help="the other")

    def values(self) -> Floats:
        return nearest(self.one, self.other, outlines)


@dataclass(frozen=True)
class Time(DriveSignal):
    """Time since the drive began."""

    name: ClassVar[str] = "time"
    unit: ClassVar[str] = "s"
    member: ClassVar[bool] = False

    def values_in(self, trace: Trace) -> Floats:
        return trace.time
