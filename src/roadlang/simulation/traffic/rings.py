"""Roundabouts: which connections lead into a ring, and how many cars it has room for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...ir.scene import Scene, SceneNetwork
from ...ir.scene_junctions import SceneJunction

CAR_SPACE = 6.5
"""Meters that a standing car takes of a lane."""
SHARE = 0.5
"""Share of a ring that cars may fill: more of them block its exits."""


@dataclass(frozen=True)
class Rings:
    """Rings by number; arrays over the C connections of some junctions, one junction after another,
    with -1 for none."""

    into: Integers
    """(C,) the ring that a connection leads into from outside"""
    onward: Integers
    """(C,) the ring on which it leads on, from outside too"""
    capacity: Floats
    """of each ring, in cars"""

    @classmethod
    def of(cls, junctions: Sequence[SceneJunction], scenes: Sequence[Scene]) -> Rings:
        """The rings of the junctions of some scenes."""
        numbers = {id(junction): number for number, junction in enumerate(junctions)}
        ring_of: dict[tuple[int, str], int] = {}
        capacity: list[float] = []
        for scene in scenes:
            lengths = {road.name: road.length for road in scene.roads}
            for network in scene.networks:
                for ring in _rings(network):
                    members = [numbers[id(node)] for node in ring[0] if id(node) in numbers]
                    if not members or (members[0], next(iter(ring[1]), "")) in ring_of:
                        continue
                    ring_of |= {(m, road): len(capacity) for m in members for road in ring[1]}
                    around = sum(lengths[road] for road in ring[1])
                    capacity.append(max(2.0, math.floor(SHARE * around / CAR_SPACE)))
        into, onward = [], []
        for number, junction in enumerate(junctions):
            for connection in junction.connections:
                leads = ring_of.get((number, connection.target.road), -1)
                onward.append(leads)
                into.append(-1 if (number, connection.source.road) in ring_of else leads)
        return cls(
            np.array(into, dtype=np.int64), np.array(onward, dtype=np.int64), np.array(capacity)
        )


def _rings(network: SceneNetwork) -> list[tuple[list[SceneJunction], list[str]]]:
    """The junctions of each ring, and its roads."""
    left = [junction for junction in network.junctions if junction.kind == "roundabout"]
    found = []
    while left:
        members, roads = [left.pop(0)], set[str]()
        for member in members:
            roads |= _ring_roads(member)
            mates = [junction for junction in left if _ring_roads(junction) & roads]
            members += mates
            left = [junction for junction in left if junction not in mates]
        found.append((members, sorted(roads)))
    return found


def _ring_roads(junction: SceneJunction) -> set[str]:
    """Those whose traffic yields to nobody although others yield to it, and where who enters goes
    on."""
    by_id = {connection.id: connection for connection in junction.connections}
    yielding = {id_ for id_, _ in junction.yields}
    entering = {by_id[id_].source.road for id_ in yielding}
    inner = {by_id[other].source.road for _, other in junction.yields if other not in yielding}
    onward = {by_id[id_].target.road for id_ in yielding}
    return (inner | onward) - entering
