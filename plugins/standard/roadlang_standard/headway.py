"""How far ahead in its lane another agent is, and in what time it is there."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .separation import rate

if TYPE_CHECKING:
    from roadlang.api import AgentTrace
    from roadlang.geometry import Floats


def time_headway(a: AgentTrace, b: AgentTrace) -> Floats:
    """Seconds until the front of `a` is where that of `b` is now, distance over speed (Treiber and
    Kesting, Traffic Flow Dynamics, ch. 2); infinite where `b` is not ahead in the lane of `a`."""
    import numpy as np

    same_road = (a.road == b.road) & (a.road >= 0.0)
    on_road = np.where(a.lane == b.lane, _along_road(a, b), np.inf)
    apart = np.where(same_road, on_road, _along_arc(a, b)) + 0.5 * (b.length - a.length)
    ahead = (apart > 0.0) & (a.speed > 0.0)
    return np.where(ahead, apart / np.where(ahead, a.speed, 1.0), np.inf)


def _along_road(a: AgentTrace, b: AgentTrace) -> Floats:
    """Meters of arc length from `a` to `b` on one road, in the direction in which the station of
    `a` changes; over the seam of a closed road, those of `_along_arc`."""
    import numpy as np

    change = rate(a.station, a)
    is_known = np.abs(change) < 2.0 * a.speed + 1.0  # a closed road begins anew at its seam
    apart = np.sign(change) * is_known * (b.station - a.station)
    return np.where(apart > 0.0, apart, _along_arc(a, b))


def _along_arc(a: AgentTrace, b: AgentTrace) -> Floats:
    """Meters of the circle that touches the heading of `a` and passes through `b`; infinite where
    `b` is not headed along it.

    A chord at the angle `p` to the tangent turns the circle by `2 p`. Whoever is in another lane
    beside the circle, `o` from it, is headed otherwise by about `2 o / chord`.
    """
    import numpy as np

    cosine, sine = np.cos(a.heading), np.sin(a.heading)
    ahead = (b.x - a.x) * cosine + (b.y - a.y) * sine
    left = (b.y - a.y) * cosine - (b.x - a.x) * sine
    chord = np.hypot(ahead, left)
    angle = np.arctan2(left, ahead)
    turned = b.heading - a.heading - 2.0 * angle
    turned = np.abs(turned - np.round(turned / math.tau) * math.tau)
    is_ahead = (ahead > 0.0) & (turned < math.pi / 2)
    is_along = is_ahead & (0.5 * turned * chord < 0.5 * (a.width + b.width))
    return np.where(is_along, chord / np.maximum(np.sinc(angle / math.pi), 1e-3), np.inf)
