"""Lanelets that follow one another through the junctions of a scene."""

from __future__ import annotations

from roadlang.ir.scene import Scene
from roadlang_formats.lanelet2.document import TOLERANCE, written_lanelets
from roadlang_formats.lanelets.network import lanelet_map


def chains_of(scene: Scene) -> list[list[int]]:
    """Before, in and after each connection of a junction, by their ids in the Lanelet2 file; none
    of lanes for buses alone, which Lanelet2 does not open to vehicles as such."""
    lanelets = lanelet_map(scene, TOLERANCE)
    ids = written_lanelets(lanelets)
    chains = []
    for junction in lanelets.junctions:
        for id, number in junction.connections.items():
            at = junction.connection(id)
            source = lanelets.leaving[at.source.road, at.source.end, at.source.lane]
            target = lanelets.entering[at.target.road, at.target.end, at.target.lane]
            parts = (source, number, target)
            if not any(lanelets.lanelets[part].kind == "bus" for part in parts):
                chains.append([ids[part] for part in parts])
        assert len(junction.connections) == len(junction.junction.connections)
    return chains


def routes_of(scene: Scene) -> list[list[int]]:
    """Of each agent with a route through junctions, the lanelet by which it leaves its first road,
    and that by which it enters its last."""
    lanelets = lanelet_map(scene, TOLERANCE)
    ids = written_lanelets(lanelets)
    routes = []
    for agent in scene.agents:
        steps = agent.route.steps if agent.route is not None else ()
        turns = [place for place, step in enumerate(steps) if step.turn is not None]
        if not turns or turns[-1] + 1 >= len(steps):
            continue
        first, last = steps[turns[0]], steps[turns[-1] + 1]
        ends = ("end", "start") if first.stop >= first.start else ("start", "end")
        source = lanelets.leaving[first.road, ends[0], first.lane]
        ends = ("end", "start") if last.stop >= last.start else ("start", "end")
        routes.append([ids[source], ids[lanelets.entering[last.road, ends[1], last.lane]]])
    return routes
