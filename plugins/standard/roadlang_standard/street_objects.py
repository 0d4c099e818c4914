"""Kinds of objects that stand along streets or lie in them, beside those of `objects`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Length, ObjectKind, String

from .object_options import color_option, height_option, length_option, width_option


@dataclass(frozen=True)
class BusStop(ObjectKind):
    """The shelter of a bus stop."""

    name: ClassVar[str] = "bus_stop"
    category: ClassVar[str] = "shelter"
    length: Length = length_option(4.0)
    width: Length = width_option(1.5)
    height: Length = height_option(2.5)
    color: String = color_option("#4fc3f7")


@dataclass(frozen=True)
class Fence(ObjectKind):
    """A fence."""

    name: ClassVar[str] = "fence"
    category: ClassVar[str] = "fence"
    length: Length = length_option(10.0)
    width: Length = width_option(0.1)
    height: Length = height_option(1.2)
    color: String = color_option("#8d8d8d")


@dataclass(frozen=True)
class Guardrail(ObjectKind):
    """A guardrail."""

    name: ClassVar[str] = "guardrail"
    category: ClassVar[str] = "guardrail"
    length: Length = length_option(20.0)
    width: Length = width_option(0.4)
    height: Length = height_option(0.8)
    color: String = color_option("#b0bec5")


@dataclass(frozen=True)
class Hedge(ObjectKind):
    """A hedge."""

    name: ClassVar[str] = "hedge"
    category: ClassVar[str] = "hedge"
    length: Length = length_option(5.0)
    width: Length = width_option(1.0)
    height: Length = height_option(1.5)
    color: String = color_option("#4c7a34")


@dataclass(frozen=True)
class Pole(ObjectKind):
    """A pole."""

    name: ClassVar[str] = "pole"
    category: ClassVar[str] = "pole"
    length: Length = length_option(0.3)
    width: Length = width_option(0.3)
    height: Length = height_option(7.0)
    color: String = color_option("#9e9e9e")


@dataclass(frozen=True)
class Bollard(ObjectKind):
    """A bollard."""

    name: ClassVar[str] = "bollard"
    category: ClassVar[str] = "pole"
    length: Length = length_option(0.2)
    width: Length = width_option(0.2)
    height: Length = height_option(1.0)
    color: String = color_option("#ffca28")


@dataclass(frozen=True)
class Hydrant(ObjectKind):
    """A fire hydrant."""

    name: ClassVar[str] = "hydrant"
    length: Length = length_option(0.4)
    width: Length = width_option(0.4)
    height: Length = height_option(0.8)
    color: String = color_option("#e53935")


@dataclass(frozen=True)
class Dumpster(ObjectKind):
    """A dumpster or a skip."""

    name: ClassVar[str] = "dumpster"
    length: Length = length_option(3.5)
    width: Length = width_option(1.8)
    height: Length = height_option(1.6)
    color: String = color_option("#33691e")


@dataclass(frozen=True)
class Trailer(ObjectKind):
    """A trailer that was left standing."""

    name: ClassVar[str] = "trailer"
    category: ClassVar[str] = "trailer"
    length: Length = length_option(7.5)
    width: Length = width_option(2.5)
    height: Length = height_option(3.2)
    color: String = color_option("#90a4ae")


@dataclass(frozen=True)
class ParkedBus(ObjectKind):
    """A parked bus."""

    name: ClassVar[str] = "parked_bus"
    category: ClassVar[str] = "bus"
    length: Length = length_option(12.0)
    width: Length = width_option(2.55)
    height: Length = height_option(3.1)
    color: String = color_option("#bfa14a")


@dataclass(frozen=True)
class ParkedBicycle(ObjectKind):
    """A parked bicycle."""

    name: ClassVar[str] = "parked_bicycle"
    category: ClassVar[str] = "bicycle"
    length: Length = length_option(1.8)
    width: Length = width_option(0.6)
    height: Length = height_option(1.1)
    color: String = color_option("#3a8f3a")


@dataclass(frozen=True)
class ParkedMotorcycle(ObjectKind):
    """A parked motorcycle."""

    name: ClassVar[str] = "parked_motorcycle"
    category: ClassVar[str] = "motorcycle"
    length: Length = length_option(2.2)
    width: Length = width_option(0.8)
    height: Length = height_option(1.2)
    color: String = color_option("#333333")


@dataclass(frozen=True)
class CarDoor(ObjectKind):
    """The open door of a parked car: `length` is its thickness, `width` how far it sticks out."""

    name: ClassVar[str] = "car_door"
    length: Length = length_option(0.2)
    width: Length = width_option(1.0)
    height: Length = height_option(1.2)
    color: String = color_option("#607d8b")


@dataclass(frozen=True)
class Debris(ObjectKind):
    """Debris on the road."""

    name: ClassVar[str] = "debris"
    length: Length = length_option(0.8)
    width: Length = width_option(0.8)
    height: Length = height_option(0.3)
    color: String = color_option("#6d4c41")


@dataclass(frozen=True)
class Pallet(ObjectKind):
    """A lost pallet."""

    name: ClassVar[str] = "pallet"
    length: Length = length_option(1.2)
    width: Length = width_option(0.8)
    height: Length = height_option(0.15)
    color: String = color_option("#a1887f")


@dataclass(frozen=True)
class Tire(ObjectKind):
    """A lost tire."""

    name: ClassVar[str] = "tire"
    length: Length = length_option(0.6)
    width: Length = width_option(0.6)
    height: Length = height_option(0.25)
    color: String = color_option("#212121")


@dataclass(frozen=True)
class Stroller(ObjectKind):
    """A stroller."""

    name: ClassVar[str] = "stroller"
    length: Length = length_option(1.0)
    width: Length = width_option(0.6)
    height: Length = height_option(1.0)
    color: String = color_option("#5e35b1")
