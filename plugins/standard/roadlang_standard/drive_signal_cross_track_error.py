"""`ego.cross_track_error` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class CrossTrack(DriveSignal):
    """Lateral distance from the path that the agent follows, such as the middle of its lane,
    positive to the left."""

    name: ClassVar[str] = "cross_track_error"
    unit: ClassVar[str] = "m"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.cross_track_error
        return values
