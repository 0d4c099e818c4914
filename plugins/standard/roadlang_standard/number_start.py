"""`van.start`: where along its road an agent or object begins."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentOrObject, RoadNumber, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Start(RoadNumber):
    """Arc length at which an agent or object on a road starts."""

    name: ClassVar[str] = "start"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 1.0
    member: ClassVar[bool] = True
    actor: AgentOrObject = option(help="agent or object on a road")

    def values(self) -> Floats:
        start: Floats = self.actor.start
        return start
