"""`ego.jerk` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

from .separation import rate

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class JerkSignal(DriveSignal):
    """Jerk: rate of change of the acceleration."""

    name: ClassVar[str] = "jerk"
    unit: ClassVar[str] = "m/s^3"
    looks_back: ClassVar[float] = 1
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        return rate(self.agent.acceleration, self.agent)
