"""Fits the connections of a place, and moves its trims outward where they are too tight."""

from __future__ import annotations

import math
from collections.abc import Mapping, MutableMapping
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Booleans, Floats
from .arms import DEFAULT_TRIM, ArmKey, ArmLine, Face
from .connection_curves import ConnectionEnds, Fits, fitted
from .lane_pairs import ArmLanes, LanePair, lane_pairs
from .places import SHORTEST_ROAD, SHORTEST_STUB, JunctionSite
from .sweeping import swept_arms

ROUNDS = 7
SHARPEST = math.radians(150.0)
"""Turns beyond it are driven only where they happen to fit."""
_FURTHER, _AND = 1.25, 0.5
_MARGIN = 1.0


@dataclass(frozen=True, eq=False)
class Connected:
    """The turns of a place: the faces of its arms, which lanes pair, and the curves.

    `found_sweeps` are those of `swept`, once they are known.
    """

    arms: tuple[ArmLine, ...]
    faces: tuple[Face, ...]
    lanes: tuple[ArmLanes, ...]
    pairs: tuple[LanePair, ...]
    fits: Fits
    found_sweeps: Booleans | None = None

    @property
    def swept(self) -> Booleans:
        """(N, arms) which arms a curve drives over beyond their faces."""
        assert self.found_sweeps is not None
        return self.found_sweeps

    @property
    def usable(self) -> Booleans:
        """(N,) the curves that can be driven and drive over no arm beyond its face."""
        return np.asarray(self.fits.drivable & ~self.swept.any(axis=1))

    @property
    def refused(self) -> Booleans:
        """(N,) the turns that are not too sharp, but have no room."""
        angles = np.array([pair.angle for pair in self.pairs])
        return np.asarray(~self.usable & (np.abs(angles) <= SHARPEST))


def connected(place: JunctionSite, trims: MutableMapping[ArmKey, float]) -> Connected:
    """The turns of a place. Moves trims in place: 25 % and half a meter a round, up to what the
    roads leave. Of all rounds the first one counts in which the fewest turns have no room."""
    best = found = _with_sweeps(_fitted(place, trims), trims)
    least = {arm.key: trims[arm.key] for arm in found.arms}
    for _ in range(ROUNDS):
        pushed = _too_tight(found) or _swept_over(found)
        moved = [push(place, key, trims) for key in sorted(pushed)]
        if not any(moved):
            break
        found = _with_sweeps(_fitted(place, trims), trims)
        if found.refused.sum() < best.refused.sum():
            best, least = found, {arm.key: trims[arm.key] for arm in found.arms}
    trims.update(least)
    return best


def _too_tight(found: Connected) -> set[ArmKey]:
    return {
        found.arms[arm].key
        for pair, drivable in zip(found.pairs, found.fits.drivable, strict=True)
        if not drivable and abs(pair.angle) <= SHARPEST and not _is_return(found, pair)
        for arm in (pair.source, pair.target)
    }


def _swept_over(found: Connected) -> set[ArmKey]:
    onward = np.array([not _is_return(found, pair) for pair in found.pairs], dtype=bool)
    return {found.arms[arm].key for arm in np.flatnonzero(found.swept[onward].any(axis=0))}


def _is_return(found: Connected, pair: LanePair) -> bool:
    """Whether a turn leads back into the road that it comes from, at another node of the place."""
    source, target = found.arms[pair.source], found.arms[pair.target]
    return source.edge is target.edge and source.node != target.node


def push(place: JunctionSite, key: ArmKey, trims: MutableMapping[ArmKey, float]) -> bool:
    """Moves a trim outward by 25 % and half a meter; False if the road leaves no room."""
    arm = next(arm for arm in place.arms.arms if arm.key == key)
    other: ArmKey = (key[0], "end" if key[1] == "start" else "start")
    least = SHORTEST_ROAD if other in trims else SHORTEST_STUB
    room = arm.length - trims.get(other, 0.0) - least
    limit = min(DEFAULT_TRIM, room, float(arm.s[-1]))
    wanted = arm.past_folds(min(trims[key] * _FURTHER + _AND, limit))
    if not trims[key] + 1e-6 < wanted <= limit:
        return False
    trims[key] = wanted
    return True


def _fitted(place: JunctionSite, trims: Mapping[ArmKey, float]) -> Connected:
    arms = place.arms.arms
    faces = tuple(arm.face(trims[arm.key]) for arm in arms)
    lanes = tuple(
        ArmLanes.of(
            arm.lanes(trims[arm.key]),
            face.heading,
            arm.edge.id in place.ring,
            {lane: aims for end, lane, aims in arm.edge.lane_arrows if end == arm.key[1]},
        )
        for arm, face in zip(arms, faces, strict=True)
    )
    places = {arm.key: number for number, arm in enumerate(arms)}
    banned = {
        (source, places[edge, into])
        for source, arm in enumerate(arms)
        for end, edge, into in arm.edge.no_turns
        if end == arm.key[1] and (edge, into) in places
    }
    pairs = lane_pairs(lanes, banned)
    fits = fitted(_ends(place, faces, lanes, pairs), _hull(arms, faces))
    return Connected(arms, faces, lanes, pairs, fits)


def _with_sweeps(found: Connected, trims: Mapping[ArmKey, float]) -> Connected:
    """The same, with what the curves drive over."""
    if found.found_sweeps is not None:
        return found
    swept = np.zeros((len(found.pairs), len(found.arms)), dtype=bool)
    if len(found.pairs) and len(found.arms) > 2:
        widths = np.array([pair_widths(found, pair) for pair in found.pairs])
        swept = swept_arms(found.arms, trims, found.fits, widths)
        swept &= found.fits.drivable[:, None]
    return replace(found, found_sweeps=swept)


def pair_widths(found: Connected, pair: LanePair) -> tuple[float, float]:
    """Of the two lanes of a turn, meters."""
    source = found.lanes[pair.source].inbound[pair.source_lane]
    return source.width, found.lanes[pair.target].outbound[pair.target_lane].width


def _ends(
    place: JunctionSite,
    faces: tuple[Face, ...],
    lanes: tuple[ArmLanes, ...],
    pairs: tuple[LanePair, ...],
) -> ConnectionEnds:
    curbs = {(corner.arm, corner.neighbor): corner.lane_radius for corner in place.arms.corners}
    rows = []
    for pair in pairs:
        source, target = faces[pair.source], faces[pair.target]
        start = source.beside(lanes[pair.source].inbound[pair.source_lane].offset)
        stop = target.beside(lanes[pair.target].outbound[pair.target_lane].offset)
        at_curb = pair.source_lane == pair.target_lane == 0 and pair.angle < 0.0
        most = curbs.get((pair.source, pair.target), math.inf) if at_curb else math.inf
        rows.append((*start, source.heading + math.pi, *stop, target.heading, most))
    table = np.array(rows, dtype=np.float64).reshape(-1, 7)
    return ConnectionEnds(table[:, 0:2], table[:, 2], table[:, 3:5], table[:, 5], table[:, 6])


def _hull(arms: tuple[ArmLine, ...], faces: tuple[Face, ...]) -> Floats:
    """(k, 3) half-planes round the faces and the nodes, a meter away from them."""
    from scipy.spatial import ConvexHull

    points = [face.corner(side) for face in faces for side in (1, -1)]
    points += [(float(arm.points[0, 0]), float(arm.points[0, 1])) for arm in arms]
    if len(faces) < 2:
        return np.zeros((0, 3))
    equations = ConvexHull(np.array(points)).equations
    return np.column_stack([equations[:, :2], _MARGIN - equations[:, 2]])
