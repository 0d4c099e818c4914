"""What is in a scenario before anything is drawn, for kinds that cannot express all of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from .read_only import Frozen


@dataclass(frozen=True)
class ScenarioContents(Frozen):
    """The parts of a scenario by name, and its kinds as scenes record them: `sine`, or `acme.mpc`
    for kinds of other plugins. If a kind is random, all possible kinds are listed."""

    networks: tuple[str, ...] = ()
    """names of the networks"""
    roads: tuple[str, ...] = ()
    """names of the roads that are not in networks"""
    agents: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """kinds of each agent: `{"ego": ("car",)}`"""
    objects: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """kinds of each object"""
    controllers: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """controllers of each agent, in order; agents without one have no entry"""
    world: tuple[str, ...] = ()
    """options that `world` sets: `rain`, `time_of_day`, ..."""
    expectations: tuple[str, ...] = ()
    """names of the expectations about drives"""
