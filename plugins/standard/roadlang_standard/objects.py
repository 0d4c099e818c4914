"""Kinds of objects, as in `object oak is tree` and in legends: dimensions and color of what does
not move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from roadlang.api import Length, ObjectKind, String, option


def _length(default: float) -> Any:
    return option(default, above=0, maximum=500, help="dimension along the heading")


def _width(default: float) -> Any:
    return option(default, above=0, maximum=500, help="dimension across the heading")


def _height(default: float) -> Any:
    return option(default, above=0, maximum=500, help="height above the ground")


def _color(default: str) -> Any:
    return option(default, help="color by name or hexadecimal code: `white`, `#2e7d32`")


@dataclass(frozen=True)
class Tree(ObjectKind):
    """A tree."""

    name: ClassVar[str] = "tree"
    length: Length = _length(4.0)
    width: Length = _width(4.0)
    height: Length = _height(8.0)
    color: String = _color("#2e7d32")


@dataclass(frozen=True)
class Bush(ObjectKind):
    """A bush."""

    name: ClassVar[str] = "bush"
    length: Length = _length(1.5)
    width: Length = _width(1.5)
    height: Length = _height(1.2)
    color: String = _color("#558b2f")


@dataclass(frozen=True)
class Building(ObjectKind):
    """A building."""

    name: ClassVar[str] = "building"
    length: Length = _length(12.0)
    width: Length = _width(10.0)
    height: Length = _height(7.0)
    color: String = _color("#b71c1c")


@dataclass(frozen=True)
class Wall(ObjectKind):
    """A wall."""

    name: ClassVar[str] = "wall"
    length: Length = _length(10.0)
    width: Length = _width(0.3)
    height: Length = _height(2.0)
    color: String = _color("#9e9e9e")


@dataclass(frozen=True)
class ParkedCar(ObjectKind):
    """A parked car."""

    name: ClassVar[str] = "parked_car"
    length: Length = _length(4.5)
    width: Length = _width(1.8)
    height: Length = _height(1.5)
    color: String = _color("#607d8b")


@dataclass(frozen=True)
class ParkedVan(ObjectKind):
    """A parked van."""

    name: ClassVar[str] = "parked_van"
    length: Length = _length(5.9)
    width: Length = _width(2.0)
    height: Length = _height(2.5)
    color: String = _color("#eceff1")


@dataclass(frozen=True)
class ParkedTruck(ObjectKind):
    """A parked truck."""

    name: ClassVar[str] = "parked_truck"
    length: Length = _length(9.0)
    width: Length = _width(2.5)
    height: Length = _height(3.5)
    color: String = _color("#795548")


@dataclass(frozen=True)
class Cone(ObjectKind):
    """A traffic cone."""

    name: ClassVar[str] = "cone"
    length: Length = _length(0.35)
    width: Length = _width(0.35)
    height: Length = _height(0.75)
    color: String = _color("#ff6d00")


@dataclass(frozen=True)
class Barrier(ObjectKind):
    """A construction barrier."""

    name: ClassVar[str] = "barrier"
    length: Length = _length(2.0)
    width: Length = _width(0.4)
    height: Length = _height(1.0)
    color: String = _color("#d32f2f")


@dataclass(frozen=True)
class Sign(ObjectKind):
    """A traffic sign on a post."""

    name: ClassVar[str] = "sign"
    length: Length = _length(0.1)
    width: Length = _width(0.7)
    height: Length = _height(2.5)
    color: String = _color("#1565c0")


@dataclass(frozen=True)
class TrafficLight(ObjectKind):
    """A traffic light on a post."""

    name: ClassVar[str] = "traffic_light"
    length: Length = _length(0.3)
    width: Length = _width(0.4)
    height: Length = _height(3.2)
    color: String = _color("#212121")


@dataclass(frozen=True)
class Lamp(ObjectKind):
    """A street lamp."""

    name: ClassVar[str] = "lamp"
    length: Length = _length(0.3)
    width: Length = _width(0.3)
    height: Length = _height(6.0)
    color: String = _color("#757575")


@dataclass(frozen=True)
class Bench(ObjectKind):
    """A bench."""

    name: ClassVar[str] = "bench"
    length: Length = _length(0.6)
    width: Length = _width(1.8)
    height: Length = _height(0.9)
    color: String = _color("#8d6e63")


@dataclass(frozen=True)
class Bin(ObjectKind):
    """A trash can."""

    name: ClassVar[str] = "bin"
    length: Length = _length(0.5)
    width: Length = _width(0.5)
    height: Length = _height(1.0)
    color: String = _color("#455a64")


@dataclass(frozen=True)
class Rock(ObjectKind):
    """A rock."""

    name: ClassVar[str] = "rock"
    length: Length = _length(1.0)
    width: Length = _width(1.0)
    height: Length = _height(0.8)
    color: String = _color("#616161")


@dataclass(frozen=True)
class Box(ObjectKind):
    """A plain box, for anything without a kind."""

    name: ClassVar[str] = "box"
    length: Length = _length(1.0)
    width: Length = _width(1.0)
    height: Length = _height(1.0)
    color: String = _color("#9575cd")
