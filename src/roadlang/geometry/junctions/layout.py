"""The places of a network with their turns; places too close to have room for turns are merged."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..lanes.cross_section import CrossSection
from ..networks.network import Edge, RoadNetwork
from .arms import ArmKey
from .connecting import Connected, connected
from .places import SHORTEST_ROAD, JunctionSite, PlaceFinder, all_trims

_MOST_TRIES = 8
_LONGEST = 30.0
"""Meters of a road whose ends are made one place for the sake of turns; where they are one place
already, of what this leaves of it."""


@dataclass(frozen=True)
class PlaceLayout:
    """Places, the trims of all their arms, and the turns of each place. `joined` are the roads
    whose places were merged for the sake of the turns."""

    finder: PlaceFinder
    places: tuple[JunctionSite, ...]
    trims: Mapping[ArmKey, float]
    turns: tuple[Connected, ...]
    joined: frozenset[int]

    @property
    def refused(self) -> int:
        """How many turns that are not too sharp have no room."""
        return sum(int(turns.refused.sum()) for turns in self.turns)

    @property
    def cramped(self) -> tuple[int, ...]:
        """The short roads between two places at which turns have no room, the shortest first."""
        found = set()
        for turns in self.turns:
            for row in np.flatnonzero(turns.refused).tolist():
                pair = turns.pairs[row]
                arms = {pair.source, pair.target, *np.flatnonzero(turns.swept[row]).tolist()}
                found |= {turns.arms[arm].edge for arm in arms}
        lengths = {edge.id: edge.length for edge in found if self._is_short_between(edge)}
        return tuple(sorted(lengths, key=lambda id: (round(lengths[id], 6), id)))

    def _is_short_between(self, edge: Edge) -> bool:
        ends: tuple[ArmKey, ArmKey] = (edge.id, "start"), (edge.id, "end")
        ring = any(edge.id in place.ring for place in self.places)
        if ring or not all(end in self.trims for end in ends):
            return False
        both = any(edge.start in place.nodes and edge.end in place.nodes for place in self.places)
        trims = sum(self.trims[end] for end in ends)
        return edge.length - (trims if both else 0.0) <= _LONGEST


def laid_out(
    network: RoadNetwork, sections: Mapping[int, CrossSection], ring: Mapping[int, bool]
) -> PlaceLayout:
    """The places of a network, merged until they have room for as many turns as that can give.

    `ring` are the roads of roundabouts.
    """
    best = _layout(network, sections, ring, frozenset())
    tried: set[int] = set()
    for _ in range(_MOST_TRIES):
        edge = next((edge for edge in best.cramped if edge not in tried), None)
        if edge is None:
            break
        tried.add(edge)
        other = _layout(network, sections, ring, best.joined | {edge})
        if other.refused >= best.refused and other.cramped:
            # What had no room moves on to roads beside it, which may go with it.
            other = _layout(network, sections, ring, other.joined | {*other.cramped})
        best = other if other.refused < best.refused else best
    return best


def _layout(
    network: RoadNetwork,
    sections: Mapping[int, CrossSection],
    ring: Mapping[int, bool],
    joined: frozenset[int],
) -> PlaceLayout:
    finder = PlaceFinder(network, sections, ring, joined)
    places = finder.find()
    trims = all_trims(places)
    _make_room(network, trims)
    turns = tuple(connected(place, trims) for place in places)
    return PlaceLayout(finder, places, trims, turns, joined)


def _make_room(network: RoadNetwork, trims: dict[ArmKey, float]) -> None:
    """Shortens the trims of short roads that are never swallowed, in proportion."""
    for edge in network.edges:
        start, end = trims.get((edge.id, "start"), 0.0), trims.get((edge.id, "end"), 0.0)
        room = max(edge.length - SHORTEST_ROAD, 0.5 * edge.length)
        if start + end > room:
            for key in ((edge.id, "start"), (edge.id, "end")):
                if key in trims:
                    trims[key] *= room / (start + end)
