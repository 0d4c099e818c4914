"""`distance(a, b)` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentOrObject, DriveSignal, option

from .separation import middles, nearest

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class DistanceSignal(DriveSignal):
    """Distance between the centers of two agents or objects; for a group, of its nearest member."""

    name: ClassVar[str] = "distance"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    member: ClassVar[bool] = False
    first: AgentOrObject = option(help="an agent, an object or a group of them")
    second: AgentOrObject = option(help="another agent, object or group")

    def values(self) -> Floats:
        return nearest(self.first, self.second, middles)
