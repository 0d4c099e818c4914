"""Kinds of lanes: `drive(3.25m)`, `bike(1.5m)`, `sidewalk(2m)`, ..."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from roadlang.api import LaneKind


@dataclass(frozen=True)
class DriveLane(LaneKind):
    """A lane for all vehicles, 3.25 m wide."""

    name: ClassVar[str] = "drive"
    is_default: ClassVar[bool] = True
    default_width: ClassVar[float] = 3.25
    drivable: ClassVar[bool] = True
    users: ClassVar[tuple[str, ...]] = ("car", "bus", "bicycle")


@dataclass(frozen=True)
class BusLane(LaneKind):
    """A lane for buses, 3.5 m wide."""

    name: ClassVar[str] = "bus"
    default_width: ClassVar[float] = 3.5
    drivable: ClassVar[bool] = True
    users: ClassVar[tuple[str, ...]] = ("bus",)


@dataclass(frozen=True)
class BikeLane(LaneKind):
    """A lane for bicycles, 1.5 m wide."""

    name: ClassVar[str] = "bike"
    also_called: ClassVar[tuple[str, ...]] = ("bicycle", "cycle")
    default_width: ClassVar[float] = 1.5
    users: ClassVar[tuple[str, ...]] = ("bicycle",)


@dataclass(frozen=True)
class ParkingLane(LaneKind):
    """A strip for parked vehicles, 2.3 m wide."""

    name: ClassVar[str] = "parking"
    default_width: ClassVar[float] = 2.3
    direction: ClassVar[Literal["none"]] = "none"


@dataclass(frozen=True)
class ShoulderLane(LaneKind):
    """A paved strip beside the outer lane, 1.5 m wide."""

    name: ClassVar[str] = "shoulder"
    also_called: ClassVar[tuple[str, ...]] = ("hard_shoulder", "emergency")
    default_width: ClassVar[float] = 1.5
    direction: ClassVar[Literal["none"]] = "none"
    default_marking: ClassVar[Literal["none"]] = "none"


@dataclass(frozen=True)
class SidewalkLane(LaneKind):
    """A sidewalk behind a curb, 2 m wide."""

    name: ClassVar[str] = "sidewalk"
    also_called: ClassVar[tuple[str, ...]] = ("pavement", "footpath", "footway")
    is_default: ClassVar[bool] = True
    default_width: ClassVar[float] = 2.0
    direction: ClassVar[Literal["both"]] = "both"
    users: ClassVar[tuple[str, ...]] = ("pedestrian",)
    raised: ClassVar[bool] = True


@dataclass(frozen=True)
class MedianLane(LaneKind):
    """A paved island behind curbs, 2 m wide."""

    name: ClassVar[str] = "median"
    default_width: ClassVar[float] = 2.0
    direction: ClassVar[Literal["none"]] = "none"
    raised: ClassVar[bool] = True


@dataclass(frozen=True)
class GrassLane(LaneKind):
    """A strip of grass, 2 m wide."""

    name: ClassVar[str] = "grass"
    default_width: ClassVar[float] = 2.0
    direction: ClassVar[Literal["none"]] = "none"
    default_marking: ClassVar[Literal["none"]] = "none"
