"""The places of a network with their turns; places so close that turns have no room are one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..arrays import Booleans
from ..cross_section import CrossSection
from ..network import RoadNetwork
from .arms import ArmKey
from .connecting import SHARPEST, Connected, connected
from .places import LONGEST_INSIDE, SHORTEST_ROAD, JunctionSite, PlaceFinder, all_trims

_MOST_TRIES = 8
_CLOSE = 0.01


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
        return sum(int(_refused(turns).sum()) for turns in self.turns)

    @property
    def cramped(self) -> tuple[int, ...]:
        """The roads between two places of which nothing is left, at which turns have no room."""
        found = set()
        for turns in self.turns:
            for row in np.flatnonzero(_refused(turns)).tolist():
                pair = turns.pairs[row]
                arms = {pair.source, pair.target, *np.flatnonzero(turns.swept[row]).tolist()}
                found |= {turns.arms[arm].edge for arm in arms}
        return tuple(sorted(edge.id for edge in found if self._is_used_up(edge.id, edge.length)))

    def _is_used_up(self, edge: int, length: float) -> bool:
        start, end = self.trims.get((edge, "start")), self.trims.get((edge, "end"))
        if start is None or end is None or length > LONGEST_INSIDE:
            return False
        ring = any(edge in place.ring for place in self.places)
        return not ring and length - start - end <= SHORTEST_ROAD + _CLOSE


def _refused(turns: Connected) -> Booleans:
    angles = np.array([pair.angle for pair in turns.pairs])
    return np.asarray(~turns.usable & (np.abs(angles) <= SHARPEST))


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
