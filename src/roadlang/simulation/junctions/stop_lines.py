"""The stop lines with signals before agents, and who crosses them at red."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene
from .crossings import Crossings
from .signal_lights import Lights


@dataclass(frozen=True)
class StopLines:
    """Of N agents, at most X each, in the order of their lines."""

    along: Floats
    """(N, X) arc lengths of the lines of the agents; infinite where there are fewer"""
    connection: Integers
    """(N, X) numbers in `lights` of the connections that begin there"""
    lights: Lights

    @classmethod
    def of(cls, crossings: Crossings) -> StopLines:
        """Those of crossings whose junctions have signals."""
        lights = Lights.of(crossings.junctions)
        has_signals = np.append(lights.has_signals, False)[crossings.junction]
        if not has_signals.any():
            return cls.none(len(has_signals))
        first = np.append(lights.first, 0)[crossings.junction]
        along = np.where(has_signals, crossings.stop, math.inf)
        return cls(along, np.where(has_signals, first + crossings.connection, 0), lights)

    @classmethod
    def none(cls, agents: int) -> StopLines:
        """Where no junction has signals."""
        return cls(np.zeros((agents, 0)), np.zeros((agents, 0), dtype=np.int64), Lights.of(()))

    @property
    def is_empty(self) -> bool:
        """Whether no agent has one."""
        return not self.along.size

    def take(self, agents: Integers) -> StopLines:
        """Those of some agents."""
        return replace(self, along=self.along[agents], connection=self.connection[agents])

    def may_cross(self, front: Floats, moved: Floats) -> bool:
        """Whether any of all agents, whose lines are open, has crossed one: `crossed_at_red` says
        who did at red."""
        ahead = self.along - front[:, None]
        return bool(np.count_nonzero((ahead > 0.0) & (ahead <= moved[:, None])))

    def crossed_at_red(
        self,
        agents: Integers,
        front: Floats,
        moved: Floats,
        lap: Floats,
        span: tuple[Floats, Floats | float],
    ) -> Booleans:
        """(n,) which of some agents have crossed one at red in a `span`: times (n,) at its begin,
        and the seconds since.

        `front` (n,): arc lengths of their fronts at its begin, `moved` (n,) how far they have come
        since, `lap` (n,) the lengths of closed lines, infinite for others. Who is over the line at
        the begin does not cross it.
        """
        begin, seconds = span
        ahead = self.along[agents] - front[:, None]
        closed = np.isfinite(lap) & (moved > 0.0)
        if closed.any():
            laps = np.floor(ahead[closed] / lap[closed, None])
            ahead[closed] -= np.where(np.isfinite(laps), laps, 0.0) * lap[closed, None]
        crossed = np.zeros(len(agents), dtype=bool)
        agent, column = np.nonzero((ahead > 0.0) & (ahead <= moved[:, None]))
        if not len(agent):
            return crossed
        passed = ahead[agent, column] / moved[agent]
        time = begin[agent] + passed * np.broadcast_to(seconds, begin.shape)[agent]
        is_red = self.lights.is_red(self.connection[agents[agent], column], time)
        crossed[agent[is_red]] = True
        return crossed


def has_signals(scene: Scene) -> bool:
    """Whether a junction of a scene has signals."""
    return any(
        junction.control.kind == "signals"
        for network in scene.networks
        for junction in network.junctions
    )
