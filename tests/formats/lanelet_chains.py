"""Lanelets that follow one another through the junctions of a scene."""

from __future__ import annotations

from roadlang.ir.scene import Scene
from roadlang_formats.lanelet2.document import TOLERANCE, written_lanelets
from roadlang_formats.lanelets.network import lanelet_map


def chains_of(scene: Scene) -> list[list[int]]:
    """Before, in and after each connection of a junction, by their ids in the Lanelet2 file."""
    lanelets = lanelet_map(scene, TOLERANCE)
    ids = written_lanelets(lanelets)
    chains = []
    for junction in lanelets.junctions:
        for id, number in junction.connections.items():
            at = junction.connection(id)
            source = lanelets.leaving[at.source.road, at.source.end, at.source.lane]
            target = lanelets.entering[at.target.road, at.target.end, at.target.lane]
            chains.append([ids[source], ids[number], ids[target]])
        assert len(junction.connections) == len(junction.junction.connections)
    return chains
