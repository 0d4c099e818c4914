"""What may stand behind `agent N is`: sizes, looks and mass of everything that moves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import AgentKind, Angle, Length, Mass, String, option


@dataclass(frozen=True)
class Car(AgentKind):
    """A passenger car."""

    name: ClassVar[str] = "car"
    length: Length = option(4.5, above=0, maximum=40, help="from bumper to bumper")
    width: Length = option(1.8, above=0, maximum=10, help="without mirrors")
    height: Length = option(1.5, above=0, maximum=10, help="over the ground")
    wheelbase: Length = option(2.7, above=0, maximum=20, help="from axle to axle")
    max_steering: Angle = option(0.6109, above=0, maximum=1.5, help="of the front wheels, each way")
    mass: Mass = option(1500.0, above=0, help="with driver")
    color: String = option("#1f5fa8", help="a name or a code: `white`, `#1f5fa8`")


@dataclass(frozen=True)
class Van(AgentKind):
    """A delivery van."""

    name: ClassVar[str] = "van"
    length: Length = option(5.9, above=0, maximum=40, help="from bumper to bumper")
    width: Length = option(2.0, above=0, maximum=10, help="without mirrors")
    height: Length = option(2.5, above=0, maximum=10, help="over the ground")
    wheelbase: Length = option(3.6, above=0, maximum=20, help="from axle to axle")
    max_steering: Angle = option(0.6109, above=0, maximum=1.5, help="of the front wheels, each way")
    mass: Mass = option(2500.0, above=0, help="with driver")
    color: String = option("#e8e8e8", help="a name or a code: `white`, `#1f5fa8`")


@dataclass(frozen=True)
class Truck(AgentKind):
    """A lorry."""

    name: ClassVar[str] = "truck"
    length: Length = option(9.0, above=0, maximum=40, help="from bumper to bumper")
    width: Length = option(2.5, above=0, maximum=10, help="without mirrors")
    height: Length = option(3.5, above=0, maximum=10, help="over the ground")
    wheelbase: Length = option(5.2, above=0, maximum=20, help="from axle to axle")
    max_steering: Angle = option(0.6109, above=0, maximum=1.5, help="of the front wheels, each way")
    mass: Mass = option(12000.0, above=0, help="with driver")
    color: String = option("#8a4b2a", help="a name or a code: `white`, `#1f5fa8`")


@dataclass(frozen=True)
class Bus(AgentKind):
    """A city bus."""

    name: ClassVar[str] = "bus"
    length: Length = option(12.0, above=0, maximum=40, help="from bumper to bumper")
    width: Length = option(2.55, above=0, maximum=10, help="without mirrors")
    height: Length = option(3.1, above=0, maximum=10, help="over the ground")
    wheelbase: Length = option(5.9, above=0, maximum=20, help="from axle to axle")
    max_steering: Angle = option(0.6981, above=0, maximum=1.5, help="of the front wheels, each way")
    mass: Mass = option(14000.0, above=0, help="with driver")
    color: String = option("#c8a415", help="a name or a code: `white`, `#1f5fa8`")


@dataclass(frozen=True)
class Motorcycle(AgentKind):
    """A motorcycle."""

    name: ClassVar[str] = "motorcycle"
    length: Length = option(2.2, above=0, maximum=40, help="from bumper to bumper")
    width: Length = option(0.8, above=0, maximum=10, help="without mirrors")
    height: Length = option(1.4, above=0, maximum=10, help="over the ground")
    wheelbase: Length = option(1.5, above=0, maximum=20, help="from axle to axle")
    max_steering: Angle = option(0.5236, above=0, maximum=1.5, help="of the front wheels, each way")
    mass: Mass = option(280.0, above=0, help="with driver")
    color: String = option("#333333", help="a name or a code: `white`, `#1f5fa8`")


@dataclass(frozen=True)
class Bicycle(AgentKind):
    """A bicycle with its rider."""

    name: ClassVar[str] = "bicycle"
    length: Length = option(1.8, above=0, maximum=40, help="from bumper to bumper")
    width: Length = option(0.6, above=0, maximum=10, help="without mirrors")
    height: Length = option(1.7, above=0, maximum=10, help="over the ground")
    wheelbase: Length = option(1.1, above=0, maximum=20, help="from axle to axle")
    max_steering: Angle = option(0.6109, above=0, maximum=1.5, help="of the front wheels, each way")
    mass: Mass = option(95.0, above=0, help="with driver")
    color: String = option("#3a8f3a", help="a name or a code: `white`, `#1f5fa8`")


@dataclass(frozen=True)
class Pedestrian(AgentKind):
    """Someone on foot."""

    name: ClassVar[str] = "pedestrian"
    length: Length = option(0.4, above=0, maximum=2, help="front to back")
    width: Length = option(0.6, above=0, maximum=2, help="side to side")
    height: Length = option(1.75, above=0, maximum=3, help="tall")
    mass: Mass = option(75.0, above=0, help="weight")
    color: String = option("#b03a2e", help="a name or a code: `white`, `#b03a2e`")


@dataclass(frozen=True)
class Animal(AgentKind):
    """A deer, or what else runs onto roads."""

    name: ClassVar[str] = "animal"
    length: Length = option(1.5, above=0, maximum=4, help="front to back")
    width: Length = option(0.5, above=0, maximum=2, help="side to side")
    height: Length = option(1.2, above=0, maximum=4, help="tall")
    mass: Mass = option(80.0, above=0, help="weight")
    color: String = option("#7a5230", help="a name or a code: `brown`, `#7a5230`")
