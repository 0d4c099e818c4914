"""The lanes of a road in a concrete scene."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True, slots=True)
class SceneLane:
    """A lane of a road."""

    id: int
    """as in OpenDRIVE: -1 first to the right of the reference line, 1 first to the left"""
    kind: str
    """`drive`, `bus`, `bike`, `parking`, `shoulder`, `sidewalk`, `median`,
    `grass`, or a plugin's"""
    direction: Literal["forward", "backward", "both", "none"]
    """of travel, along the road"""
    width: tuple[float, ...] = field(repr=False)
    """meters: one number for all of the road, or one for each of its stations"""
    drivable: bool = True
    """whether motor vehicles drive on it"""
    speed_limit: float | None = None
    """m/s; null where nothing is said"""
    marking: Literal["solid", "broken", "double", "none", "curb"] = "none"
    """the line toward the outer neighbor"""
    users: tuple[str, ...] = ()
    """who may use it, where that is known: `car`, `bus`, `bicycle`, `pedestrian`"""
    raised: bool = False
    """whether it lies above the roadway, behind a curb"""
