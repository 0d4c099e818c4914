"""Sensors of the agents of a concrete scene."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from .read_only import Frozen


@dataclass(frozen=True, slots=True)
class SceneSensor(Frozen):
    """A sensor of an agent, with every option concrete."""

    name: str
    """what its readings are called, unique in the agent: `front`, or the name of its kind"""
    kind: str
    """`camera`, `ranges`, ...; of another plugin with the plugin's name, `acme.radar`"""
    options: Mapping[str, Any] = field(default_factory=dict)
    """those of the kind and of every sensor (`every`, `delay`, `dropout`), by name, in SI units and
    radians"""
