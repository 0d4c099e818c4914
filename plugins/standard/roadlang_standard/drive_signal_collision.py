"""`ego.collision` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Collision(DriveSignal):
    """Relative speed of the hardest impact of the agent so far; 0 before the first."""

    name: ClassVar[str] = "collision"
    unit: ClassVar[str] = "m/s"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.collision
        return values
