"""Kinds of agents, as in `agent ego is car`: dimensions, mass and color of what moves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from roadlang.api import AgentKind, Angle, Length, Mass, String, option


def _length(default: float) -> Any:
    return option(default, above=0, maximum=40, help="length from bumper to bumper")


def _width(default: float) -> Any:
    return option(default, above=0, maximum=10, help="width without mirrors")


def _height(default: float) -> Any:
    return option(default, above=0, maximum=10, help="height above the ground")


def _wheelbase(default: float) -> Any:
    return option(default, above=0, maximum=20, help="distance between the axles")


def _max_steering(default: float) -> Any:
    help = "maximum steering angle of the front wheels, to either side"
    return option(default, above=0, maximum=1.5, help=help)


def _mass(default: float) -> Any:
    return option(default, above=0, help="total mass, including driver or rider")


def _color(default: str) -> Any:
    return option(default, help="color by name or hexadecimal code: `white`, `#1f5fa8`")


@dataclass(frozen=True)
class Car(AgentKind):
    """A passenger car."""

    name: ClassVar[str] = "car"
    category: ClassVar[str] = "car"
    length: Length = _length(4.5)
    width: Length = _width(1.8)
    height: Length = _height(1.5)
    wheelbase: Length = _wheelbase(2.7)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(1500.0)
    color: String = _color("#1f5fa8")


@dataclass(frozen=True)
class Van(AgentKind):
    """A delivery van."""

    name: ClassVar[str] = "van"
    category: ClassVar[str] = "van"
    length: Length = _length(5.9)
    width: Length = _width(2.0)
    height: Length = _height(2.5)
    wheelbase: Length = _wheelbase(3.6)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(2500.0)
    color: String = _color("#e8e8e8")


@dataclass(frozen=True)
class Truck(AgentKind):
    """A truck."""

    name: ClassVar[str] = "truck"
    category: ClassVar[str] = "truck"
    length: Length = _length(9.0)
    width: Length = _width(2.5)
    height: Length = _height(3.5)
    wheelbase: Length = _wheelbase(5.2)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(12000.0)
    color: String = _color("#8a4b2a")


@dataclass(frozen=True)
class Bus(AgentKind):
    """A city bus."""

    name: ClassVar[str] = "bus"
    category: ClassVar[str] = "bus"
    length: Length = _length(12.0)
    width: Length = _width(2.55)
    height: Length = _height(3.1)
    wheelbase: Length = _wheelbase(5.9)
    max_steering: Angle = _max_steering(0.6981)
    mass: Mass = _mass(14000.0)
    color: String = _color("#c8a415")


@dataclass(frozen=True)
class Motorcycle(AgentKind):
    """A motorcycle."""

    name: ClassVar[str] = "motorcycle"
    category: ClassVar[str] = "motorcycle"
    length: Length = _length(2.2)
    width: Length = _width(0.8)
    height: Length = _height(1.4)
    wheelbase: Length = _wheelbase(1.5)
    max_steering: Angle = _max_steering(0.5236)
    mass: Mass = _mass(280.0)
    color: String = _color("#333333")


@dataclass(frozen=True)
class Bicycle(AgentKind):
    """A bicycle with its rider."""

    name: ClassVar[str] = "bicycle"
    category: ClassVar[str] = "bicycle"
    length: Length = _length(1.8)
    width: Length = _width(0.6)
    height: Length = _height(1.7)
    wheelbase: Length = _wheelbase(1.1)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(95.0)
    color: String = _color("#3a8f3a")


@dataclass(frozen=True)
class Pedestrian(AgentKind):
    """A pedestrian."""

    name: ClassVar[str] = "pedestrian"
    category: ClassVar[str] = "pedestrian"
    length: Length = option(0.4, above=0, maximum=2, help="front-to-back depth")
    width: Length = option(0.6, above=0, maximum=2, help="shoulder width")
    height: Length = option(1.75, above=0, maximum=3, help="height")
    mass: Mass = option(75.0, above=0, help="body mass")
    color: String = _color("#b03a2e")


@dataclass(frozen=True)
class Animal(AgentKind):
    """A deer or another animal that runs onto the road."""

    name: ClassVar[str] = "animal"
    category: ClassVar[str] = "animal"
    length: Length = option(1.5, above=0, maximum=4, help="length from head to tail")
    width: Length = option(0.5, above=0, maximum=2, help="width")
    height: Length = option(1.2, above=0, maximum=4, help="height")
    mass: Mass = option(80.0, above=0, help="body mass")
    color: String = _color("#7a5230")


@dataclass(frozen=True)
class Taxi(AgentKind):
    """A taxi."""

    name: ClassVar[str] = "taxi"
    category: ClassVar[str] = "car"
    role: ClassVar[str] = "taxi"
    length: Length = _length(4.6)
    width: Length = _width(1.85)
    height: Length = _height(1.5)
    wheelbase: Length = _wheelbase(2.75)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(1600.0)
    color: String = _color("#e8b71a")


@dataclass(frozen=True)
class PoliceCar(AgentKind):
    """A police car."""

    name: ClassVar[str] = "police_car"
    category: ClassVar[str] = "car"
    role: ClassVar[str] = "police"
    length: Length = _length(4.8)
    width: Length = _width(1.85)
    height: Length = _height(1.5)
    wheelbase: Length = _wheelbase(2.85)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(1800.0)
    color: String = _color("#1565c0")


@dataclass(frozen=True)
class Ambulance(AgentKind):
    """An ambulance."""

    name: ClassVar[str] = "ambulance"
    category: ClassVar[str] = "van"
    role: ClassVar[str] = "ambulance"
    length: Length = _length(6.2)
    width: Length = _width(2.1)
    height: Length = _height(2.7)
    wheelbase: Length = _wheelbase(3.7)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(3800.0)
    color: String = _color("#f5f5f5")


@dataclass(frozen=True)
class FireTruck(AgentKind):
    """A fire truck."""

    name: ClassVar[str] = "fire_truck"
    category: ClassVar[str] = "truck"
    role: ClassVar[str] = "fire"
    length: Length = _length(8.5)
    width: Length = _width(2.5)
    height: Length = _height(3.3)
    wheelbase: Length = _wheelbase(4.8)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(14000.0)
    color: String = _color("#c62828")


@dataclass(frozen=True)
class Tractor(AgentKind):
    """A farm tractor."""

    name: ClassVar[str] = "tractor"
    category: ClassVar[str] = "tractor"
    length: Length = _length(4.6)
    width: Length = _width(2.3)
    height: Length = _height(2.9)
    wheelbase: Length = _wheelbase(2.6)
    max_steering: Angle = _max_steering(0.7)
    mass: Mass = _mass(6000.0)
    color: String = _color("#2e7d32")


@dataclass(frozen=True)
class Scooter(AgentKind):
    """An electric kick scooter with its rider."""

    name: ClassVar[str] = "scooter"
    category: ClassVar[str] = "bicycle"
    length: Length = _length(1.2)
    width: Length = _width(0.6)
    height: Length = _height(1.75)
    wheelbase: Length = _wheelbase(0.95)
    max_steering: Angle = _max_steering(0.6109)
    mass: Mass = _mass(90.0)
    color: String = _color("#455a64")


@dataclass(frozen=True)
class Child(AgentKind):
    """A child on foot."""

    name: ClassVar[str] = "child"
    category: ClassVar[str] = "pedestrian"
    length: Length = option(0.3, above=0, maximum=2, help="front-to-back depth")
    width: Length = option(0.4, above=0, maximum=2, help="shoulder width")
    height: Length = option(1.1, above=0, maximum=3, help="height")
    mass: Mass = option(25.0, above=0, help="body mass")
    color: String = _color("#ef6c00")


@dataclass(frozen=True)
class Dog(AgentKind):
    """A dog."""

    name: ClassVar[str] = "dog"
    category: ClassVar[str] = "animal"
    length: Length = option(0.9, above=0, maximum=2, help="length from head to tail")
    width: Length = option(0.3, above=0, maximum=2, help="width")
    height: Length = option(0.6, above=0, maximum=3, help="height")
    mass: Mass = option(25.0, above=0, help="body mass")
    color: String = _color("#6d4c41")
