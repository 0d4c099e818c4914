"""The least gap between an agent and the others over a drive."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from ..geometry.areas.footprints import Footprints, distance_between
from ..geometry.arrays import Booleans, Floats
from ..ir.trace import AgentTrace


def least_gap(agent: AgentTrace, others: Iterable[AgentTrace]) -> float:
    """Meters between the outlines of an agent and of the nearest other while both are there; 0
    where they touch, infinite where nobody else is there."""
    # The circles around two are never farther apart than the two: most need no closer look.
    pairs = [(_between_circles(agent, other), other) for other in others]
    least = math.inf
    for bounds, other in sorted(pairs, key=lambda pair: float(pair[0].min(initial=math.inf))):
        nearest = bounds.min(initial=math.inf)
        if nearest >= least:
            break
        least = min(least, _outlines(agent, other, bounds == nearest))
        near = bounds < least
        if near.any():
            least = min(least, _outlines(agent, other, near))
    return least


def _between_circles(agent: AgentTrace, other: AgentTrace) -> Floats:
    """At each time; infinite where one of them has left."""
    radii = sum(math.hypot(actor.length, actor.width) / 2.0 for actor in (agent, other))
    apart = np.hypot(agent.x - other.x, agent.y - other.y) - radii
    is_there = (agent.present != 0.0) & (other.present != 0.0)
    return np.where(is_there & np.isfinite(apart), apart, math.inf)


def _outlines(agent: AgentTrace, other: AgentTrace, at: Booleans) -> float:
    gaps = distance_between(*(_footprints(one, at) for one in (agent, other)))
    return max(float(gaps.min()), 0.0)


def _footprints(agent: AgentTrace, at: Booleans) -> Footprints:
    sizes = (np.asarray(agent.length), np.asarray(agent.width))
    return Footprints(agent.x[at], agent.y[at], agent.heading[at], *sizes)
