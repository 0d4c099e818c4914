"""Kinds of objects, as in `object oak is tree` and in legends: dimensions and color of what does
not move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Length, ObjectKind, String

from .object_options import color_option, height_option, length_option, width_option


@dataclass(frozen=True)
class Tree(ObjectKind):
    """A tree."""

    name: ClassVar[str] = "tree"
    category: ClassVar[str] = "tree"
    length: Length = length_option(4.0)
    width: Length = width_option(4.0)
    height: Length = height_option(8.0)
    color: String = color_option("#2e7d32")


@dataclass(frozen=True)
class Bush(ObjectKind):
    """A bush."""

    name: ClassVar[str] = "bush"
    category: ClassVar[str] = "bush"
    length: Length = length_option(1.5)
    width: Length = width_option(1.5)
    height: Length = height_option(1.2)
    color: String = color_option("#558b2f")


@dataclass(frozen=True)
class Building(ObjectKind):
    """A building."""

    name: ClassVar[str] = "building"
    also_called: ClassVar[tuple[str, ...]] = ("house",)
    category: ClassVar[str] = "building"
    length: Length = length_option(12.0)
    width: Length = width_option(10.0)
    height: Length = height_option(7.0)
    color: String = color_option("#b71c1c")


@dataclass(frozen=True)
class Wall(ObjectKind):
    """A wall."""

    name: ClassVar[str] = "wall"
    category: ClassVar[str] = "wall"
    length: Length = length_option(10.0)
    width: Length = width_option(0.3)
    height: Length = height_option(2.0)
    color: String = color_option("#9e9e9e")


@dataclass(frozen=True)
class ParkedCar(ObjectKind):
    """A parked car."""

    name: ClassVar[str] = "parked_car"
    category: ClassVar[str] = "car"
    length: Length = length_option(4.5)
    width: Length = width_option(1.8)
    height: Length = height_option(1.5)
    color: String = color_option("#607d8b")


@dataclass(frozen=True)
class ParkedVan(ObjectKind):
    """A parked van."""

    name: ClassVar[str] = "parked_van"
    category: ClassVar[str] = "van"
    length: Length = length_option(5.9)
    width: Length = width_option(2.0)
    height: Length = height_option(2.5)
    color: String = color_option("#eceff1")


@dataclass(frozen=True)
class ParkedTruck(ObjectKind):
    """A parked truck."""

    name: ClassVar[str] = "parked_truck"
    category: ClassVar[str] = "truck"
    length: Length = length_option(9.0)
    width: Length = width_option(2.5)
    height: Length = height_option(3.5)
    color: String = color_option("#795548")


@dataclass(frozen=True)
class Cone(ObjectKind):
    """A traffic cone."""

    name: ClassVar[str] = "cone"
    also_called: ClassVar[tuple[str, ...]] = ("pylon", "traffic_cone")
    category: ClassVar[str] = "cone"
    length: Length = length_option(0.35)
    width: Length = width_option(0.35)
    height: Length = height_option(0.75)
    color: String = color_option("#ff6d00")


@dataclass(frozen=True)
class Barrier(ObjectKind):
    """A construction barrier."""

    name: ClassVar[str] = "barrier"
    category: ClassVar[str] = "barrier"
    length: Length = length_option(2.0)
    width: Length = width_option(0.4)
    height: Length = height_option(1.0)
    color: String = color_option("#d32f2f")


@dataclass(frozen=True)
class Sign(ObjectKind):
    """A traffic sign on a post."""

    name: ClassVar[str] = "sign"
    category: ClassVar[str] = "sign"
    length: Length = length_option(0.1)
    width: Length = width_option(0.7)
    height: Length = height_option(2.5)
    color: String = color_option("#1565c0")


@dataclass(frozen=True)
class TrafficLight(ObjectKind):
    """A traffic light on a post."""

    name: ClassVar[str] = "traffic_light"
    category: ClassVar[str] = "traffic_light"
    length: Length = length_option(0.3)
    width: Length = width_option(0.4)
    height: Length = height_option(3.2)
    color: String = color_option("#212121")


@dataclass(frozen=True)
class Lamp(ObjectKind):
    """A street lamp."""

    name: ClassVar[str] = "lamp"
    also_called: ClassVar[tuple[str, ...]] = (
        "street_light",
        "street_lamp",
        "streetlight",
        "lamp_post",
    )
    category: ClassVar[str] = "lamp"
    length: Length = length_option(0.3)
    width: Length = width_option(0.3)
    height: Length = height_option(6.0)
    color: String = color_option("#757575")


@dataclass(frozen=True)
class Bench(ObjectKind):
    """A bench."""

    name: ClassVar[str] = "bench"
    length: Length = length_option(0.6)
    width: Length = width_option(1.8)
    height: Length = height_option(0.9)
    color: String = color_option("#8d6e63")


@dataclass(frozen=True)
class Bin(ObjectKind):
    """A trash can."""

    name: ClassVar[str] = "bin"
    length: Length = length_option(0.5)
    width: Length = width_option(0.5)
    height: Length = height_option(1.0)
    color: String = color_option("#455a64")


@dataclass(frozen=True)
class Rock(ObjectKind):
    """A rock."""

    name: ClassVar[str] = "rock"
    length: Length = length_option(1.0)
    width: Length = width_option(1.0)
    height: Length = height_option(0.8)
    color: String = color_option("#616161")


@dataclass(frozen=True)
class Box(ObjectKind):
    """A plain box, for anything without a kind."""

    name: ClassVar[str] = "box"
    length: Length = length_option(1.0)
    width: Length = width_option(1.0)
    height: Length = height_option(1.0)
    color: String = color_option("#9575cd")
