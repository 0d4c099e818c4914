"""`ego.acceleration` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class AccelerationSignal(DriveSignal):
    """Longitudinal acceleration; negative when braking."""

    name: ClassVar[str] = "acceleration"
    unit: ClassVar[str] = "m/s^2"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.acceleration
        return values
