"""`ego.contacts` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentName, DriveSignal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Contacts(DriveSignal):
    """Number of agents and objects that the agent has touched so far."""

    name: ClassVar[str] = "contacts"
    unit: ClassVar[str] = ""
    is_integer: ClassVar[bool] = True
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        values: Floats = self.agent.contacts
        return values
