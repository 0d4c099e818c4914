"""Streets: parts of ways between the nodes where they meet."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from .records import OsmNode
from .way_lanes import Tags

Place = tuple[float, float]
_FARTHEST = 2.0
"""Lengths of the shortest street between two nodes that may become one: of several in a row, the
others stay."""


@dataclass(frozen=True)
class Street:
    """A part of a way, or of several that go on as one, between junctions or changes of lanes.

    `ways`: the ids of the ways at its start and at its end. `level`: 0 on the ground. `arrows`: the
    markings of its lanes before its start and before its end, as `turn:lanes` has them.
    """

    nodes: tuple[str, ...]
    tags: Tags
    ways: tuple[str, str]
    level: int
    arrows: tuple[str, str]

    @property
    def reversed(self) -> Street:
        """The same street against its direction."""
        return replace(self, nodes=self.nodes[::-1], ways=self.ways[::-1], arrows=self.arrows[::-1])

    def and_then(self, other: Street) -> Street:
        """This street and one that begins where it ends, with the tags of this one."""
        level = max(self.level, other.level, key=abs)
        ways, arrows = (self.ways[0], other.ways[1]), (self.arrows[0], other.arrows[1])
        return Street(self.nodes + other.nodes[1:], self.tags, ways, level, arrows)


def contracted(
    streets: Sequence[Street],
    points: Mapping[str, Place],
    nodes: Mapping[str, OsmNode],
    shortest: float,
) -> list[Street]:
    """The streets, of which none is shorter than `shortest` meters: both ends of such a street are
    one node, where all streets of both meet. The one with a tag stays, such as a signal."""
    became: dict[str, str] = {}

    def now(node: str) -> str:
        while node in became:
            node = became[node]
        return node

    kept = []
    for street in streets:
        ends = now(street.nodes[0]), now(street.nodes[-1])
        length = sum(math.dist(points[a], points[b]) for a, b in pairwise(street.nodes))
        apart = math.dist(points[ends[0]], points[ends[1]])
        if length >= shortest or apart >= _FARTHEST * shortest or ends[0] == ends[1]:
            kept.append(street)
            continue
        stays, goes = ends if "highway" in nodes[ends[0]].tags else ends[::-1]
        if "highway" not in nodes[stays].tags:
            stays, goes = ends
        became[goes] = stays
    return [
        replace(street, nodes=(now(street.nodes[0]), *street.nodes[1:-1], now(street.nodes[-1])))
        for street in kept
    ]
