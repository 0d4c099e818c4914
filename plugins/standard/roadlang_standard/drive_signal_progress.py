"""`ego.progress` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Progress(DriveSignal):
    """Share of the path that the agent has completed, from 0 to 1; `route_progress` is the distance
    in meters."""

    name: ClassVar[str] = "progress"
    unit: ClassVar[str] = ""
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.progress
        return values
