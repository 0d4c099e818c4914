"""`ego.yaw_rate` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

from .separation import rate

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class YawRate(DriveSignal):
    """Yaw rate, positive to the left."""

    name: ClassVar[str] = "yaw_rate"
    unit: ClassVar[str] = "rad/s"
    looks_back: ClassVar[float] = 1
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        return rate(self.agent.heading, self.agent)
