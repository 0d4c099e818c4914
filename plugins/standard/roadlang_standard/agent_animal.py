"""Agents of the kind `animal`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import AgentKind, Length, Mass, String, option

from .agent_options import color_option


@dataclass(frozen=True)
class Animal(AgentKind):
    """A deer or another animal that runs onto the road."""

    name: ClassVar[str] = "animal"
    category: ClassVar[str] = "animal"
    length: Length = option(1.5, above=0, maximum=4, help="length from head to tail")
    width: Length = option(0.5, above=0, maximum=2, help="width")
    height: Length = option(1.2, above=0, maximum=4, help="height")
    mass: Mass = option(80.0, above=0, help="body mass")
    color: String = color_option("#7a5230")
