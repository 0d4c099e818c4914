"""Agents of the kind `dog`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import AgentKind, Length, Mass, String, option

from .agent_options import color_option


@dataclass(frozen=True)
class Dog(AgentKind):
    """A dog."""

    name: ClassVar[str] = "dog"
    category: ClassVar[str] = "animal"
    length: Length = option(0.9, above=0, maximum=2, help="length from head to tail")
    width: Length = option(0.3, above=0, maximum=2, help="width")
    height: Length = option(0.6, above=0, maximum=3, help="height")
    mass: Mass = option(25.0, above=0, help="body mass")
    color: String = color_option("#6d4c41")
