"""What may stand behind `object N is` and in a legend: sizes and looks of what does not move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Length, ObjectKind, String, option


@dataclass(frozen=True)
class Tree(ObjectKind):
    """A tree."""

    name: ClassVar[str] = "tree"
    length: Length = option(4.0, above=0, maximum=500, help="along its heading")
    width: Length = option(4.0, above=0, maximum=500, help="across its heading")
    height: Length = option(8.0, above=0, maximum=500, help="over the ground")
    color: String = option("#2e7d32", help="a name or a code: `white`, `#2e7d32`")


@dataclass(frozen=True)
class Bush(ObjectKind):
    """A bush."""

    name: ClassVar[str] = "bush"
    length: Length = option(1.5, above=0, maximum=500, help="along its heading")
    width: Length = option(1.5, above=0, maximum=500, help="across its heading")
    height: Length = option(1.2, above=0, maximum=500, help="over the ground")
    color: String = option("#558b2f", help="a name or a code: `white`, `#558b2f`")


@dataclass(frozen=True)
class Building(ObjectKind):
    """A building."""

    name: ClassVar[str] = "building"
    length: Length = option(12.0, above=0, maximum=500, help="along its heading")
    width: Length = option(10.0, above=0, maximum=500, help="across its heading")
    height: Length = option(7.0, above=0, maximum=500, help="over the ground")
    color: String = option("#b71c1c", help="a name or a code: `white`, `#b71c1c`")


@dataclass(frozen=True)
class Wall(ObjectKind):
    """A wall."""

    name: ClassVar[str] = "wall"
    length: Length = option(10.0, above=0, maximum=500, help="along its heading")
    width: Length = option(0.3, above=0, maximum=500, help="across its heading")
    height: Length = option(2.0, above=0, maximum=500, help="over the ground")
    color: String = option("#9e9e9e", help="a name or a code: `white`, `#9e9e9e`")


@dataclass(frozen=True)
class ParkedCar(ObjectKind):
    """A car that stays where it is."""

    name: ClassVar[str] = "parked_car"
    length: Length = option(4.5, above=0, maximum=500, help="along its heading")
    width: Length = option(1.8, above=0, maximum=500, help="across its heading")
    height: Length = option(1.5, above=0, maximum=500, help="over the ground")
    color: String = option("#607d8b", help="a name or a code: `white`, `#607d8b`")


@dataclass(frozen=True)
class ParkedVan(ObjectKind):
    """A van that stays where it is."""

    name: ClassVar[str] = "parked_van"
    length: Length = option(5.9, above=0, maximum=500, help="along its heading")
    width: Length = option(2.0, above=0, maximum=500, help="across its heading")
    height: Length = option(2.5, above=0, maximum=500, help="over the ground")
    color: String = option("#eceff1", help="a name or a code: `white`, `#eceff1`")


@dataclass(frozen=True)
class ParkedTruck(ObjectKind):
    """A lorry that stays where it is."""

    name: ClassVar[str] = "parked_truck"
    length: Length = option(9.0, above=0, maximum=500, help="along its heading")
    width: Length = option(2.5, above=0, maximum=500, help="across its heading")
    height: Length = option(3.5, above=0, maximum=500, help="over the ground")
    color: String = option("#795548", help="a name or a code: `white`, `#795548`")


@dataclass(frozen=True)
class Cone(ObjectKind):
    """A traffic cone."""

    name: ClassVar[str] = "cone"
    length: Length = option(0.35, above=0, maximum=500, help="along its heading")
    width: Length = option(0.35, above=0, maximum=500, help="across its heading")
    height: Length = option(0.75, above=0, maximum=500, help="over the ground")
    color: String = option("#ff6d00", help="a name or a code: `white`, `#ff6d00`")


@dataclass(frozen=True)
class Barrier(ObjectKind):
    """A road-works barrier."""

    name: ClassVar[str] = "barrier"
    length: Length = option(2.0, above=0, maximum=500, help="along its heading")
    width: Length = option(0.4, above=0, maximum=500, help="across its heading")
    height: Length = option(1.0, above=0, maximum=500, help="over the ground")
    color: String = option("#d32f2f", help="a name or a code: `white`, `#d32f2f`")


@dataclass(frozen=True)
class Sign(ObjectKind):
    """A traffic sign on a post."""

    name: ClassVar[str] = "sign"
    length: Length = option(0.1, above=0, maximum=500, help="along its heading")
    width: Length = option(0.7, above=0, maximum=500, help="across its heading")
    height: Length = option(2.5, above=0, maximum=500, help="over the ground")
    color: String = option("#1565c0", help="a name or a code: `white`, `#1565c0`")


@dataclass(frozen=True)
class TrafficLight(ObjectKind):
    """A traffic light on a post."""

    name: ClassVar[str] = "traffic_light"
    length: Length = option(0.3, above=0, maximum=500, help="along its heading")
    width: Length = option(0.4, above=0, maximum=500, help="across its heading")
    height: Length = option(3.2, above=0, maximum=500, help="over the ground")
    color: String = option("#212121", help="a name or a code: `white`, `#212121`")


@dataclass(frozen=True)
class Lamp(ObjectKind):
    """A street lamp."""

    name: ClassVar[str] = "lamp"
    length: Length = option(0.3, above=0, maximum=500, help="along its heading")
    width: Length = option(0.3, above=0, maximum=500, help="across its heading")
    height: Length = option(6.0, above=0, maximum=500, help="over the ground")
    color: String = option("#757575", help="a name or a code: `white`, `#757575`")


@dataclass(frozen=True)
class Bench(ObjectKind):
    """A bench."""

    name: ClassVar[str] = "bench"
    length: Length = option(0.6, above=0, maximum=500, help="along its heading")
    width: Length = option(1.8, above=0, maximum=500, help="across its heading")
    height: Length = option(0.9, above=0, maximum=500, help="over the ground")
    color: String = option("#8d6e63", help="a name or a code: `white`, `#8d6e63`")


@dataclass(frozen=True)
class Bin(ObjectKind):
    """A rubbish bin."""

    name: ClassVar[str] = "bin"
    length: Length = option(0.5, above=0, maximum=500, help="along its heading")
    width: Length = option(0.5, above=0, maximum=500, help="across its heading")
    height: Length = option(1.0, above=0, maximum=500, help="over the ground")
    color: String = option("#455a64", help="a name or a code: `white`, `#455a64`")


@dataclass(frozen=True)
class Rock(ObjectKind):
    """A rock."""

    name: ClassVar[str] = "rock"
    length: Length = option(1.0, above=0, maximum=500, help="along its heading")
    width: Length = option(1.0, above=0, maximum=500, help="across its heading")
    height: Length = option(0.8, above=0, maximum=500, help="over the ground")
    color: String = option("#616161", help="a name or a code: `white`, `#616161`")


@dataclass(frozen=True)
class Box(ObjectKind):
    """A plain box, for whatever has no kind of its own."""

    name: ClassVar[str] = "box"
    length: Length = option(1.0, above=0, maximum=500, help="along its heading")
    width: Length = option(1.0, above=0, maximum=500, help="across its heading")
    height: Length = option(1.0, above=0, maximum=500, help="over the ground")
    color: String = option("#9575cd", help="a name or a code: `white`, `#9575cd`")
