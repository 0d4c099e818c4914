"""Lane types and road marks of OpenDRIVE, mapped to those of roadlang."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class LaneType:
    """The kind of a lane, and what it means. `runs`: as its side says, both ways, or not at all."""

    kind: str
    drivable: bool = False
    runs: Literal["side", "both", "none"] = "none"
    users: tuple[str, ...] = ()
    raised: bool = False


_DRIVE = LaneType("drive", True, "side", ("car", "bus", "bicycle"))
_SHOULDER = LaneType("shoulder")
_GRASS = LaneType("grass")
_MEDIAN = LaneType("median", raised=True)
_SIDEWALK = LaneType("sidewalk", False, "both", ("pedestrian",), True)
_TYPES: Mapping[str, LaneType] = {
    **dict.fromkeys(
        ("driving", "entry", "exit", "onRamp", "offRamp", "connectingRamp", "slipLane", "shared"),
        _DRIVE,
    ),
    **dict.fromkeys(("HOV", "mwyEntry", "mwyExit"), _DRIVE),
    "bidirectional": LaneType("drive", True, "both", _DRIVE.users),
    "bus": LaneType("bus", True, "side", ("bus",)),
    "taxi": LaneType("bus", True, "side", ("bus",)),
    "biking": LaneType("bike", False, "side", ("bicycle",)),
    "parking": LaneType("parking"),
    "sidewalk": _SIDEWALK,
    "walking": _SIDEWALK,
    "median": _MEDIAN,
    "curb": _MEDIAN,
    **dict.fromkeys(("shoulder", "border", "stop", "restricted", "roadWorks"), _SHOULDER),
}
_MARKS: Mapping[str, Literal["solid", "broken", "double", "none", "curb"]] = {
    "solid": "solid",
    "edge": "solid",
    "broken": "broken",
    "botts dots": "broken",
    **dict.fromkeys(("solid solid", "solid broken", "broken solid", "broken broken"), "double"),
    "curb": "curb",
}


def lane_type(written: str) -> LaneType:
    """The lane type for a type of OpenDRIVE; unknown types become grass, where nobody drives."""
    return _TYPES.get(written, _GRASS)


def marking(written: str) -> Literal["solid", "broken", "double", "none", "curb"]:
    """The line that a type of `roadMark` stands for."""
    return _MARKS.get(written, "none")


def direction(
    type: LaneType, id: int, written: str, left_hand: bool
) -> Literal["forward", "backward", "both", "none"]:
    """How traffic runs in a lane: by its side, unless its attribute `direction` says otherwise."""
    if type.runs != "side":
        return type.runs
    if written == "both":
        return "both"
    forward = (id < 0) != left_hand
    return "forward" if forward != (written == "reversed") else "backward"
