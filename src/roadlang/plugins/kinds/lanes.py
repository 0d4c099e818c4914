"""The base class of lanes: what a strip of a road is for."""

from __future__ import annotations

from typing import ClassVar, Literal, TypeAlias

from ...geometry.lanes.lanes import Marking
from .base import Kind

LaneDirection: TypeAlias = Literal["side", "both", "none"]
LaneMarking: TypeAlias = Marking


class LaneKind(Kind):
    """A lane of a road, written as a call in `left:` or `right:` of a road: `bike(1.5m)`.

    A kind of lane is described by its class attributes and needs no method. Its calls also take the
    options of all lanes: `width`, `speed_limit`, `marking`. The drivable kind with `is_default` is
    used for `lanes: 2`, the other one for `sidewalks: 2m`.
    """

    verb: ClassVar[str] = "lane"
    default_width: ClassVar[float] = 3.0
    """meters, if the scene file gives no width"""
    drivable: ClassVar[bool] = False
    """whether motor vehicles drive on it: the driving area of a road is its drivable lanes"""
    direction: ClassVar[LaneDirection] = "side"
    """of travel: that of its side of the road, both, or none (no traffic)"""
    users: ClassVar[tuple[str, ...]] = ()
    """who may use it: "car", "bus", "bicycle", "pedestrian" """
    raised: ClassVar[bool] = False
    """whether it is above the roadway, behind a curb"""
    default_marking: ClassVar[LaneMarking | Literal["auto"]] = "auto"
    """the line toward the outer neighbor where a scene file says none; `auto`: broken to a
    lane of the same kind and direction, a curb to a raised lane, else solid"""
