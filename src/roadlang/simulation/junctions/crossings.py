"""The junctions that agents cross, along their lines."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ...geometry.arrays import Floats, Integers
from ...ir.scene_junctions import SceneJunction

STOP_GAP = 0.6
"""Meters before a stop line at which cars stop."""


@dataclass(frozen=True)
class Crossings:
    """The crossings of N agents, at most X each, in the order of their lines: arrays (N, X).

    Arc lengths are those of the lines; those of crossings that an agent does not have are infinite.
    """

    stop: Floats
    """where the connection begins: the stop line"""
    exit: Floats
    """where it ends"""
    junction: Integers
    """number in `junctions`, -1 for none"""
    connection: Integers
    """place in `SceneJunction.connections`"""
    junctions: tuple[SceneJunction, ...]
    """of all scenes"""

    def take(self, agents: Integers) -> Crossings:
        """Those of some agents."""
        return replace(
            self,
            stop=self.stop[agents],
            exit=self.exit[agents],
            junction=self.junction[agents],
            connection=self.connection[agents],
        )
