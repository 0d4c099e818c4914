"""The base class of lanes: what a strip of a road is for."""

from __future__ import annotations

from typing import ClassVar, Literal, TypeAlias

from ...geometry.lanes import Marking
from .base import Kind

LaneDirection: TypeAlias = Literal["side", "both", "none"]
LaneMarking: TypeAlias = Marking


class LaneKind(Kind):
    """A lane of a road, written as a call in `left:` or `right:` of a road: `bike(1.5m)`.

    A kind of lane says what it is by its class attributes and needs no method. Its calls also
    take the options of every lane: `width`, `speed_limit`, `marking`. The drivable kind that
    `is_default` is that of `lanes: 2`, the other one that of `sidewalks: 2m`.
    """

    verb: ClassVar[str] = "lane"
    default_width: ClassVar[float] = 3.0
    """meters, where a scene file says none"""
    drivable: ClassVar[bool] = False
    """whether motor vehicles drive on it: the driving area of a road is its drivable lanes"""
    direction: ClassVar[LaneDirection] = "side"
    """of travel: as on its side of the road, both, or none (nobody travels along it)"""
    users: ClassVar[tuple[str, ...]] = ()
    """who may use it: "car", "bus", "bicycle", "pedestrian" """
    raised: ClassVar[bool] = False
    """whether it is above the roadway, behind a curb"""
    default_marking: ClassVar[LaneMarking | Literal["auto"]] = "auto"
    """the line toward the outer neighbor where a scene file says none; `auto`: broken to a
    lane of the same kind and direction, a curb to a raised lane, else solid"""
