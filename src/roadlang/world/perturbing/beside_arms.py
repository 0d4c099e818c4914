"""How far a road of a network may be moved beside another that leaves the same junction at a small
angle."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from ...geometry import Edge, RoadNetwork
from ...geometry.arrays import Floats, wrapped
from ...geometry.curves.window import ease
from ...geometry.junctions.arms import nearest_on
from ...geometry.networks.junction_model import Arm, Junction, JunctionPlan

CLOSE = math.radians(35.0)
"""Roads that leave a junction with a smaller angle between them are beside each other."""
MARGIN = 0.05
"""Meters that remain between the two, at least."""
WHOLE = 1.2
"""Times a displacement, from which on the room beside a road does not change it:
`ease(t / WHOLE) <= t`."""
_SAMPLES = 400


def room_beside(
    network: RoadNetwork, plans: Iterable[JunctionPlan], edge: Edge, stations: Floats
) -> Floats | None:
    """(S,) meters to each side that a road may be moved, if all others are moved no farther than
    they may be: half of the gap to the nearest road beside it. None where none is beside it."""
    rooms = []
    for junction in (junction for plan in plans for junction in plan.junctions):
        own = [arm for arm in junction.arms if arm.edge == edge.id]
        for arm in own:
            for other in junction.arms:
                if other.edge != edge.id and _angle(network, arm, other) < CLOSE:
                    widths = (_width(junction, arm) + _width(junction, other)) / 2.0
                    gap = _distance(edge, network.edge(other.edge), stations) - widths
                    rooms.append((gap - MARGIN) / 2.0)
    return np.maximum(np.min(rooms, axis=0), 0.0) if rooms else None


def kept_beside(displacement: Floats, room: Floats) -> Floats:
    """A displacement (V, S), smaller where there is less room (S,) than its greatest value."""
    most = np.abs(displacement).max(axis=-1, keepdims=True)
    share = np.minimum(room / np.maximum(WHOLE * most, 1e-9), 1.0)
    return np.asarray(displacement * ease(share))


def _angle(network: RoadNetwork, arm: Arm, other: Arm) -> float:
    difference = _heading(network, arm) - _heading(network, other)
    return abs(float(wrapped(np.array(difference))))


def _heading(network: RoadNetwork, arm: Arm) -> float:
    """Of a road where it leaves the junction, away from it."""
    edge = network.edge(arm.edge)
    if arm.end == "start":
        return float(edge.curve.heading(arm.trim))
    return float(edge.curve.heading(edge.length - arm.trim)) + math.pi


def _width(junction: Junction, arm: Arm) -> float:
    return math.dist(junction.area[arm.left], junction.area[arm.right])


def _distance(edge: Edge, other: Edge, stations: Floats) -> Floats:
    """(S,) meters from a road to another."""
    line = other.curve.at(np.linspace(0.0, other.length, _SAMPLES))
    return nearest_on(edge.curve.at(stations), line)[0]
