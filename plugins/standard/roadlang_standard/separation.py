"""Distances between what moves, and rates of change, over the time of a drive."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from roadlang.api import geometry

if TYPE_CHECKING:
    from roadlang.api import AgentTrace
    from roadlang.geometry import Floats

    Separation = Callable[[AgentTrace, AgentTrace], Floats]


def nearest(one: Any, other: Any, separation: Separation) -> Floats:
    """(T,) the least of a measure over two groups; nothing is compared with itself."""
    import numpy as np

    some = one if isinstance(one, tuple) else (one,)
    others = other if isinstance(other, tuple) else (other,)
    pairs = [separation(a, b) for a in some for b in others if a is not b]
    if not pairs:
        return np.full(len((*some, *others)[0].time), np.inf)
    return np.asarray(np.min(pairs, axis=0))


def middles(a: AgentTrace, b: AgentTrace) -> Floats:
    """(T,) meters between the middles."""
    import numpy as np

    return np.asarray(np.hypot(a.x - b.x, a.y - b.y))


def outlines(a: AgentTrace, b: AgentTrace) -> Floats:
    """(T,) meters of free space between two rectangles, 0 where they overlap."""
    import numpy as np

    return np.maximum(geometry.distance_between(footprints(a), footprints(b)), 0.0)


def footprints(agent: AgentTrace) -> geometry.Footprints:
    """(T,) the rectangles that an agent covers."""
    import numpy as np

    size = np.full(len(agent.x), agent.length), np.full(len(agent.x), agent.width)
    return geometry.Footprints(agent.x, agent.y, agent.heading, *size)


def rate(values: Floats, time: Floats) -> Floats:
    """(T,) derivative by central differences."""
    import numpy as np

    return np.asarray(np.gradient(values, time)) if len(time) > 1 else np.zeros(len(time))
