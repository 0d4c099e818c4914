"""Phases of signals: groups of connections that may have green together."""

from __future__ import annotations

import math

from .model import Arm, Junction

_OPPOSITE = math.radians(135.0)


def signal_phases(junction: Junction) -> tuple[tuple[int, ...], ...]:
    """The ids of the connections of each phase, in the order of the arms.

    Two arms that face each other share a phase, every other arm has its own. So within a phase
    the only conflicts are between what comes from opposite arms, where who turns further left
    yields.
    """
    headings = {_key(arm): _heading(junction, arm) for arm in junction.arms}
    sources: dict[tuple[int, str], list[int]] = {}
    for connection in junction.connections:
        source = connection.source.edge, connection.source.end
        sources.setdefault(source, []).append(connection.id)
    phases: list[tuple[int, ...]] = []
    left = sorted(sources)
    while left:
        first = left.pop(0)
        facing = [(abs(_wrapped(headings[key] - headings[first])), key) for key in left]
        turned, partner = max(facing, default=(0.0, first))
        group = sources[first]
        if turned > _OPPOSITE:
            left.remove(partner)
            group = group + sources[partner]
        phases.append(tuple(sorted(group)))
    return tuple(phases)


def _heading(junction: Junction, arm: Arm) -> float:
    (xl, yl), (xr, yr) = junction.area[arm.left], junction.area[arm.right]
    return math.atan2(xr - xl, yl - yr)


def _key(arm: Arm) -> tuple[int, str]:
    return arm.edge, arm.end


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2.0 * math.pi) - math.pi
