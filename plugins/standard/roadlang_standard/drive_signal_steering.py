"""`ego.steering` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Steering(DriveSignal):
    """Steering angle of the front wheels, positive to the left."""

    name: ClassVar[str] = "steering"
    unit: ClassVar[str] = "rad"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.steering
        return values
