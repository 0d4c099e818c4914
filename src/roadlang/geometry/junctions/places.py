"""Places: nodes whose junctions touch are one place, and the roads between them lie inside it."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from ..lanes.cross_section import CrossSection
from ..networks.junction_model import Problem
from ..networks.network import Edge, RoadNetwork
from .arms import ArmKey, ArmLine
from .corners import CurbSize
from .trims import Trimmed, trimmed

SHORTEST_ROAD = 2.0
"""Meters of a road between two places; what would be shorter is swallowed."""
SHORTEST_DETOUR = 12.0
"""Meters of a road between two nodes of one place; what would be shorter is swallowed."""
SHORTEST_STUB = 0.5
"""Meters that a tight turn leaves of a dead end."""
_LONGEST_STUB, _LONGEST_INSIDE = 30.0, 60.0
"""Meters: longer dead ends, and roads between two places, are not swallowed. Where no room is left
of them, the roads of the drawing overlap."""
_LONGEST_COVERED = 200.0
"""Meters: longer dead ends stay, though they lie on another road."""


@dataclass(frozen=True)
class JunctionSite:
    """Nodes that make one junction, its arms, and the roads inside it."""

    nodes: tuple[int, ...]
    arms: Trimmed
    inside: tuple[int, ...]
    ring: frozenset[int] = frozenset()
    """the roads of roundabouts"""
    covered: frozenset[int] = frozenset()
    """dead ends among `inside` that lie on another road, and not on the surface of the place"""

    @property
    def id(self) -> int:
        """That of the first node."""
        return self.nodes[0]

    def halves(self, lines: Mapping[ArmKey, ArmLine]) -> list[ArmLine]:
        """Both ends of each road that is part of its surface."""
        built = [edge for edge in self.inside if edge not in self.covered]
        return [line for edge in built for line in (lines[edge, "start"], lines[edge, "end"])]


class PlaceFinder:
    """Merges the nodes of a network until every road that is left between two places is long
    enough. `ring` are the roads of roundabouts, which are never swallowed, `joined` roads that are
    swallowed whatever their length."""

    def __init__(
        self,
        network: RoadNetwork,
        sections: Mapping[int, CrossSection],
        ring: Mapping[int, bool],
        joined: Collection[int] = (),
    ) -> None:
        self._network = network
        self._ring = ring
        self._edges = {edge.id: edge for edge in sorted(network.edges, key=lambda e: e.id)}
        self.arms: dict[ArmKey, ArmLine] = {}
        """both ends of every road"""
        for edge in self._edges.values():
            for end in ("start", "end"):
                self.arms[edge.id, end] = ArmLine.of(edge, end, sections[edge.id])
        self._curbs: dict[int, CurbSize] = {}
        self._inside: set[int] = set()
        self._vanished: set[int] = set()
        self._covered: set[int] = set()
        self._place: dict[int, int] = {}
        for node in sorted(node.id for node in network.nodes):
            ends = network.edges_at(node)
            lone_ring = len(ends) == 2 and ends[0] is ends[1]
            if len(ends) >= 2 and not lone_ring:
                self._place[node] = node
        for id in sorted(joined):
            self._inside.add(id)
            self._merge({self._place[node] for node in self._ends(id) if node in self._place})

    def _ends(self, edge: int) -> tuple[int, int]:
        return self._edges[edge].start, self._edges[edge].end

    def find(self) -> tuple[JunctionSite, ...]:
        """The places by their ids."""
        found: dict[int, JunctionSite] = {}
        changed = set(self._place.values())
        while changed:
            found = {id: place for id, place in found.items() if id in self._place.values()}
            for id in sorted(changed):
                if id in self._place.values():
                    found[id] = self._trim(id)
            changed = self._swallow(found)
        return tuple(found[id] for id in sorted(found))

    def vanished(self) -> tuple[Problem, ...]:
        """The dead ends that lie inside places, once these are found."""
        edges = [self._edges[id] for id in sorted(self._vanished)]
        return tuple(
            Problem("vanished", self._place_of(edge), (edge.id,), edge.length) for edge in edges
        )

    def _place_of(self, edge: Edge) -> int:
        return self._place.get(edge.start, self._place.get(edge.end, -1))

    def _trim(self, id: int) -> JunctionSite:
        nodes = tuple(sorted(node for node, place in self._place.items() if place == id))
        arms, inside, lines = [], [], []
        for edge in self._edges.values():
            ends = [
                end for end, node in (("start", edge.start), ("end", edge.end)) if node in nodes
            ]
            if edge.id in self._inside:
                if ends:
                    inside.append(edge.id)
                if ends and edge.id not in self._covered:
                    lines += [self.arms[edge.id, "start"], self.arms[edge.id, "end"]]
            else:
                found = [self.arms[edge.id, end] for end in ends]  # type: ignore[index]
                arms += [arm.near_half() for arm in found] if len(found) == 2 else found
        trims = trimmed(arms, lines, self._curbs)
        covered = frozenset(self._covered.intersection(inside))
        return JunctionSite(nodes, trims, tuple(inside), frozenset(self._ring), covered)

    def _swallow(self, found: Mapping[int, JunctionSite]) -> set[int]:
        """Merges what the trims leave no road between; the ids of the places that changed."""
        trims = {key: trim for place in found.values() for key, trim in place.arms.trims.items()}
        covered = {edge for place in found.values() for edge, _ in place.arms.covered}
        changed: set[int] = set()
        lying_on_others = []
        for edge in self._edges.values():
            ends: tuple[ArmKey, ArmKey] = (edge.id, "start"), (edge.id, "end")
            if edge.id in self._inside or not any(end in trims for end in ends):
                continue
            left = edge.length - sum(trims.get(end, 0.0) for end in ends)
            is_stub = any(end not in trims for end in ends)
            places = {self._place[n] for n in self._ends(edge.id) if n in self._place}
            is_detour = len(places) == 1 and not is_stub and edge.start != edge.end
            if left >= (SHORTEST_DETOUR if is_detour else SHORTEST_ROAD) and not (
                is_stub and edge.id in covered
            ):
                continue
            least = CurbSize.NOSE if is_stub or edge.id in self._ring else CurbSize.LEAST
            if self._curbs.get(edge.id) != least:
                self._curbs[edge.id] = least
                changed |= places
            elif edge.id in self._ring:
                continue
            elif edge.length <= (_LONGEST_STUB if is_stub else _LONGEST_INSIDE):
                self._inside.add(edge.id)
                if is_stub:
                    self._vanished.add(edge.id)
                changed |= self._merge(places)
            elif is_stub and edge.length <= _LONGEST_COVERED:
                lying_on_others.append(edge)
        return changed or self._leave_out(lying_on_others)

    def _leave_out(self, edges: Sequence[Edge]) -> set[int]:
        """Takes the narrowest of these dead ends away, and whatever lay on it has room; the places
        that changed."""
        if not edges:
            return set()
        edge = min(edges, key=lambda edge: (round(float(self._width(edge)), 6), -edge.id))
        for found in (self._inside, self._vanished, self._covered):
            found.add(edge.id)
        return {self._place[n] for n in self._ends(edge.id) if n in self._place}

    def _width(self, edge: Edge) -> float:
        line = self.arms[edge.id, "start"]
        return float(line.left.mean() + line.right.mean())

    def _merge(self, places: set[int]) -> set[int]:
        """One place of several; the ids that changed or are gone."""
        first = min(places)
        for node, place in self._place.items():
            if place in places:
                self._place[node] = first
        return places


def all_trims(places: Sequence[JunctionSite]) -> dict[ArmKey, float]:
    """The trims of all arms of all places."""
    return {key: trim for place in places for key, trim in place.arms.trims.items()}
