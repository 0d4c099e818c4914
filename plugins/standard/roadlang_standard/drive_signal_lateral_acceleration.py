"""`ego.lateral_acceleration` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

from .separation import rate

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class LateralAcceleration(DriveSignal):
    """Lateral acceleration: speed times yaw rate, positive to the left."""

    name: ClassVar[str] = "lateral_acceleration"
    unit: ClassVar[str] = "m/s^2"
    looks_back: ClassVar[float] = 1
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        return rate(self.agent.heading, self.agent) * self.agent.speed
