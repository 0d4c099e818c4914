"""Distances between what moves, and rates of change: columns over time, or over agents too."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from roadlang.api import geometry

if TYPE_CHECKING:
    from roadlang.api import AgentTrace
    from roadlang.geometry import Floats

    Separation = Callable[[AgentTrace, AgentTrace], Floats]


def nearest(group: Any, other: Any, separation: Separation) -> Floats:
    """The least of a measure over two groups; nothing is compared with itself. It is infinite where
    one of the two has left, or is on another level than the other."""
    import numpy as np

    some = group if isinstance(group, tuple) else (group,)
    others = other if isinstance(other, tuple) else (other,)
    pairs = [_while_present(a, b, separation) for a in some for b in others if a is not b]
    if not pairs:
        return np.full(np.shape((*some, *others)[0].x), np.inf)
    return np.asarray(np.min(pairs, axis=0))


def _while_present(a: AgentTrace, b: AgentTrace, separation: Separation) -> Floats:
    import numpy as np

    absent = (a.present == 0.0) | (b.present == 0.0)
    apart = separation(a, b)
    levels = geometry.are_apart(a.elevation, b.elevation, middles(a, b))
    absent = absent | levels if levels.any() else absent
    return np.where(absent, np.inf, apart) if absent.any() else apart


def middles(a: AgentTrace, b: AgentTrace) -> Floats:
    """Meters between the middles."""
    import numpy as np

    return np.asarray(np.hypot(a.x - b.x, a.y - b.y))


def outlines(a: AgentTrace, b: AgentTrace) -> Floats:
    """Meters of free space between two rectangles, 0 where they overlap."""
    import numpy as np

    return np.maximum(geometry.distance_between(footprints(a), footprints(b)), 0.0)


def footprints(agent: AgentTrace) -> geometry.Footprints:
    """The rectangles that an agent covers."""
    import numpy as np

    length, width = (np.broadcast_to(size, agent.x.shape) for size in (agent.length, agent.width))
    return geometry.Footprints(agent.x, agent.y, agent.heading, length, width)


def rate(values: Floats, agent: AgentTrace) -> Floats:
    """Derivative of something of an agent by central differences in time, along the first axis; of
    who has left as it was last."""
    import numpy as np

    found = _derivative(values, agent.time)
    gone = (agent.present == 0.0).reshape(len(values), -1)
    if gone.any():
        columns, of_columns = values.reshape(len(values), -1), found.reshape(len(values), -1)
        for column in np.flatnonzero(gone.any(axis=0) & ~gone.all(axis=0)):
            there = int(gone[:, column].argmax())
            of_columns[:there, column] = _derivative(columns[:there, column], agent.time[:there])
            of_columns[there:, column] = of_columns[there - 1, column]
    return found


def _derivative(values: Floats, time: Floats) -> Floats:
    import numpy as np

    return np.gradient(values, time, axis=0) if len(time) > 1 else np.zeros_like(values)
