"""What is in a scenario before anything is drawn, for kinds that cannot express all of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from .read_only import Frozen


@dataclass(frozen=True)
class ScenarioContents(Frozen):
    """The parts of a scenario by name, and the kinds in it as scenes record them: `sine`, and of
    other plugins `acme.mpc`. Where a kind is drawn at random all that may be drawn are listed."""

    networks: tuple[str, ...] = ()
    """names of the networks"""
    roads: tuple[str, ...] = ()
    """names of the roads, without those of networks"""
    agents: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """kinds of each agent: `{"ego": ("car",)}`"""
    objects: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """kinds of each object"""
    controllers: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """kinds that drive each agent, in order; no entry for one without"""
    world: tuple[str, ...] = ()
    """options that `world` sets: `rain`, `time_of_day`, ..."""
    expectations: tuple[str, ...] = ()
    """names of what drives are judged by"""
