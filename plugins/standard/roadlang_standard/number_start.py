"""`van.start`: where along its road an agent or object begins."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import AgentOrObject, RoadNumber, option


@dataclass(frozen=True)
class Start(RoadNumber):
    """Arc length at which an agent or object on a road begins."""

    name: ClassVar[str] = "start"
    unit: ClassVar[str] = "m"
    member: ClassVar[bool] = True
    actor: AgentOrObject = option(help="who, or what")
