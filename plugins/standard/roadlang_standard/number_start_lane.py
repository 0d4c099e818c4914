"""`ego.start_lane`: the lane in which an agent or object begins."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentOrObject, RoadNumber, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class StartLane(RoadNumber):
    """Id of the lane in which an agent or object on a road starts; 0 for none."""

    name: ClassVar[str] = "start_lane"
    cost: ClassVar[float] = 1.0
    member: ClassVar[bool] = True
    is_integer: ClassVar[bool] = True
    actor: AgentOrObject = option(help="agent or object on a road")

    def values(self) -> Floats:
        """The ids, as in OpenDRIVE."""
        lane: Floats = self.actor.lane.astype(float)
        return lane
