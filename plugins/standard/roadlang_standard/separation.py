"""Distances between what moves, and rates of change, over the time of a drive."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import AgentTrace

    Floats = NDArray[np.float64]
    Separation = Callable[[AgentTrace, AgentTrace], Floats]


def nearest(one: Any, other: Any, separation: Separation) -> Floats:
    """(T,) meters between the nearest two of two groups; nobody is near to itself."""
    import numpy as np

    some = one if isinstance(one, tuple) else (one,)
    others = other if isinstance(other, tuple) else (other,)
    pairs = [separation(a, b) for a in some for b in others if a is not b]
    if not pairs:
        return np.full(len(some[0].time), np.inf)
    return np.asarray(np.min(pairs, axis=0))


def middles(a: AgentTrace, b: AgentTrace) -> Floats:
    """(T,) meters between the middles."""
    import numpy as np

    return np.asarray(np.hypot(a.x - b.x, a.y - b.y))


def outlines(a: AgentTrace, b: AgentTrace) -> Floats:
    """(T,) meters of free space between two rectangles, 0 where they overlap."""
    import numpy as np

    corners_a, corners_b = _corners(a), _corners(b)
    to_b, apart_b = _outside(corners_a, b)
    to_a, apart_a = _outside(corners_b, a)
    return np.where(apart_a | apart_b, np.minimum(to_a, to_b), 0.0)


def rate(values: Floats, time: Floats) -> Floats:
    """(T,) derivative by central differences."""
    import numpy as np

    return np.asarray(np.gradient(values, time)) if len(time) > 1 else np.zeros(len(time))


def _corners(agent: AgentTrace) -> Floats:
    """(T, 4, 2) corners of the outline."""
    import numpy as np

    along = np.stack([np.cos(agent.heading), np.sin(agent.heading)], axis=-1)
    across = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    middle = np.stack([agent.x, agent.y], axis=-1)
    signs = ((1, 1), (1, -1), (-1, -1), (-1, 1))
    return np.stack(
        [middle + along * i * agent.length / 2 + across * j * agent.width / 2 for i, j in signs],
        axis=1,
    )


def _outside(corners: Floats, agent: AgentTrace) -> tuple[Floats, NDArray[np.bool_]]:
    """(T,) distance of the nearest corner from an outline; whether its axes separate them."""
    import numpy as np

    away = corners - np.stack([agent.x, agent.y], axis=-1)[:, None]
    cosine, sine = np.cos(agent.heading)[:, None], np.sin(agent.heading)[:, None]
    along = away[..., 0] * cosine + away[..., 1] * sine
    across = away[..., 1] * cosine - away[..., 0] * sine
    half = np.array([agent.length / 2, agent.width / 2])
    beyond = np.maximum(np.abs(np.stack([along, across], axis=-1)) - half, 0.0)
    apart = (
        (along.min(axis=1) > half[0])
        | (along.max(axis=1) < -half[0])
        | (across.min(axis=1) > half[1])
        | (across.max(axis=1) < -half[1])
    )
    return np.hypot(beyond[..., 0], beyond[..., 1]).min(axis=1), apart
