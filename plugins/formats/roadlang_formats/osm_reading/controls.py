"""Traffic signals, and stop and yield signs, of an extract of OpenStreetMap."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Literal

from roadlang.geometry import MapControl

from .records import OsmNode

Rule = Literal["signals", "stop", "yield"]
End = Literal["start", "end"]
Arm = tuple[int, End]
Place = tuple[float, float]
_RULES: dict[str, Rule] = {"traffic_signals": "signals", "stop": "stop", "give_way": "yield"}
_AHEAD: Mapping[str, tuple[End, ...]] = {"forward": ("end",), "backward": ("start",)}
_FARTHEST = 40.0
"""Meters along a street from a signal or sign to the junction that it is for."""
_MEETING = 3
"""Ends of streets from which on a node is a junction."""


def map_controls(
    streets: Mapping[int, Sequence[str]], nodes: Mapping[str, OsmNode], points: Mapping[str, Place]
) -> tuple[MapControl, ...]:
    """Of streets, by the numbers of their edges: the nodes that they run through.

    Signals stand at the node of a junction, or before it like signs, in the direction that their
    tag says, else before the nearer junction.
    """
    at: dict[str, list[Arm]] = {}
    for edge, ids in streets.items():
        at.setdefault(ids[0], []).append((edge, "start"))
        at.setdefault(ids[-1], []).append((edge, "end"))
    found: list[MapControl] = []
    for id, arms in at.items():
        tags = nodes[id].tags
        rule = _RULES.get(tags.get("highway", ""))
        if rule and len(arms) >= _MEETING and (rule == "signals" or tags.get("stop") == "all"):
            found.append(MapControl(rule, tuple(arms)))
    for edge, ids in streets.items():
        ends: dict[End, bool] = {
            "start": len(at[ids[0]]) >= _MEETING,
            "end": len(at[ids[-1]]) >= _MEETING,
        }
        for rule, end in _on_the_way(ids, nodes, points, ends):
            found.append(MapControl(rule, ((edge, end),)))
    return tuple(found)


def _on_the_way(
    ids: Sequence[str],
    nodes: Mapping[str, OsmNode],
    points: Mapping[str, Place],
    meets: Mapping[End, bool],
) -> Iterator[tuple[Rule, End]]:
    """Rules of nodes between the ends of a street, each with the end that it is for."""
    steps = [math.dist(points[one], points[other]) for one, other in pairwise(ids)]
    for place, id in enumerate(ids[1:-1], 1):
        tags = nodes[id].tags
        rule = _RULES.get(tags.get("highway", ""))
        if rule is None:
            continue
        away: dict[End, float] = {"start": sum(steps[:place]), "end": sum(steps[place:])}
        written = tags.get("traffic_signals:direction", tags.get("direction", ""))
        wanted = _AHEAD.get(written, ("start", "end"))
        near = [end for end in wanted if meets[end] and away[end] <= _FARTHEST]
        if near:
            yield rule, min(near, key=lambda end: away[end])
