"""Lanelet2 files, by its own reader and routing graph. Runs with their Python.

Question: by file, the latitude and longitude of its (0, 0), chains of lanelets, each of which leads
into the next, and routes: from which lanelet to which. Answer: by file, what is wrong with it.
"""

from __future__ import annotations

import json
import sys
from itertools import pairwise
from typing import Any

import lanelet2
from lanelet2.projection import LocalCartesianProjector

_CLOSE = 0.01
"""Meters between a point as it is projected and its local coordinates."""


def faults(
    file: str, origin: list[float], chains: list[list[int]], routes: list[list[int]]
) -> list[str]:
    """Of one file."""
    projector = LocalCartesianProjector(lanelet2.io.Origin(*origin))
    found, errors = lanelet2.io.loadRobust(file, projector)
    report = [str(error) for error in errors]
    for point in found.pointLayer:
        away = max(
            abs(point.x - float(point.attributes["local_x"])),
            abs(point.y - float(point.attributes["local_y"])),
        )
        if away > _CLOSE:
            report.append(f"point {point.id} is {away:.3f} m off")
    rules = lanelet2.traffic_rules.create(
        lanelet2.traffic_rules.Locations.Germany, lanelet2.traffic_rules.Participants.Vehicle
    )
    graph = lanelet2.routing.RoutingGraph(found, rules)
    report += [str(error) for error in graph.checkValidity()]
    report += [_broken(found, graph, rules, chain) for chain in chains]
    for start, goal in routes:
        ends = [found.laneletLayer[id] for id in (start, goal)]
        if not graph.getRoute(*ends, 0, True):
            report.append(f"no vehicle gets from lanelet {start} to {goal}")
    return [fault for fault in report if fault]


def _broken(found: Any, graph: Any, rules: Any, chain: list[int]) -> str:
    """Where a vehicle cannot go on from lanelet to lanelet."""
    lanelets = [found.laneletLayer[id] for id in chain]
    for one, other in pairwise(lanelets):
        if not rules.canPass(one):
            return f"vehicles may not pass lanelet {one.id}"
        following = [lanelet.id for lanelet in graph.following(one)]
        if other.id not in following:
            return f"lanelet {one.id} leads into {following}, not into {other.id}"
    route = graph.getRoute(lanelets[0], lanelets[-1], 0, False)
    return "" if route else f"there is no route from {chain[0]} to {chain[-1]}"


def main() -> None:
    """Answer the question on standard input."""
    question = json.load(sys.stdin)
    print(json.dumps({file: faults(file, *given) for file, given in question.items()}))


if __name__ == "__main__":
    main()
