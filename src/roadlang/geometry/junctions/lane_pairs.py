"""Which lane of an arm leads into which lane of another."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

from ..networks.junction_model import Turn
from .arms import ArmLane

STRAIGHT, U_TURN = math.radians(35.0), math.radians(165.0)
_OFF = math.radians(75.0)
"""How far a turn may be from where a marking points that means it."""


@dataclass(frozen=True, slots=True)
class ArmLanes:
    """The lanes into and out of a place at one arm, each from the curb to the middle of the road,
    and the heading at its face away from the place."""

    inbound: tuple[ArmLane, ...]
    outbound: tuple[ArmLane, ...]
    heading: float
    circles: bool = False
    """whether it is a road of a roundabout, all lanes of which lead on round it"""
    marked: Mapping[int, tuple[float, ...]] = field(default_factory=dict)
    """where the markings of inbound lanes point, by their indices: changes of heading, radians"""

    @classmethod
    def of(
        cls,
        lanes: Sequence[ArmLane],
        heading: float,
        circles: bool = False,
        markings: Mapping[int, tuple[float, ...]] | None = None,
    ) -> ArmLanes:
        """`lanes` from left to right, seen from the place; `markings` by their ids."""
        inbound = tuple(lane for lane in lanes if lane.inbound)
        outbound = tuple(lane for lane in reversed(lanes) if lane.outbound)
        ids = {lane.id: place for place, lane in enumerate(inbound)}
        marked = {ids[id]: found for id, found in (markings or {}).items() if id in ids}
        return cls(inbound, outbound, heading, circles, marked)


@dataclass(frozen=True, slots=True)
class LanePair:
    """From a lane of the arm `source` to one of the arm `target`, by indices of the arms and of
    their lanes from the curb; the change of heading, and the turn that this is."""

    source: int
    source_lane: int
    target: int
    target_lane: int
    angle: float
    turn: Turn


def turn_of(angle: float) -> Turn:
    """Of a change of heading, radians."""
    if abs(angle) < STRAIGHT:
        return "straight"
    if abs(angle) > U_TURN:
        return "u"
    return "left" if angle > 0.0 else "right"


def lane_pairs(
    arms: Sequence[ArmLanes], banned: Collection[tuple[int, int]] = ()
) -> tuple[LanePair, ...]:
    """All turns from each arm into every other arm with a lane that leads away, but for those from
    arm to arm that are `banned`.

    From right to left each turn gets lanes that cross none of the others: right turns those at the
    curb, left turns those in the middle, the straightest all that are left, or all where there are
    more turns than lanes, and on a roundabout. Lanes with markings lead where these point; to arms
    that no marking points to, turns have the same lanes as without.
    """
    found: list[LanePair] = []
    for source, arm in enumerate(arms):
        if not arm.inbound:
            continue
        targets = sorted(
            (_turned(arm, other), place)
            for place, other in enumerate(arms)
            if place != source and other.outbound and (source, place) not in banned
        )
        angles = [angle for angle, _ in targets]
        shares = _shared(angles, len(arm.inbound), exclusive=not arm.circles)
        if arm.marked:
            shares = _as_marked(angles, shares, arm.marked)
        for (angle, target), lanes in zip(targets, shares, strict=True):
            for lane, into in _into(angle, lanes, len(arms[target].outbound)):
                found.append(LanePair(source, lane, target, into, angle, turn_of(angle)))
    return tuple(found)


def _turned(arm: ArmLanes, other: ArmLanes) -> float:
    """The change of heading from the arm's inbound lanes to the other's outbound lanes."""
    return round((other.heading - arm.heading) % (2.0 * math.pi) - math.pi, 12)


def _shared(angles: Sequence[float], lanes: int, *, exclusive: bool) -> Sequence[Sequence[int]]:
    """The lanes, counted from the curb, of each turn from right to left. `exclusive`: where there
    are lanes enough, turns have lanes of their own."""
    if lanes == 1 or len(angles) < 2:
        return [range(lanes)] * len(angles)
    straightest = min(range(len(angles)), key=lambda place: (abs(angles[place]), place))
    rights, lefts = straightest, len(angles) - 1 - straightest
    enough = exclusive and lanes >= len(angles)
    shares = []
    for place in range(len(angles)):
        if place == straightest:
            shares.append(range(rights, lanes - lefts) if enough else range(lanes))
        elif place < straightest:
            at = place if enough else 0
            shares.append(range(at, at + 1))
        else:
            at = lanes - (len(angles) - place) if enough else lanes - 1
            shares.append(range(at, at + 1))
    return shares


def _as_marked(
    angles: Sequence[float],
    shares: Sequence[Sequence[int]],
    marked: Mapping[int, tuple[float, ...]],
) -> list[list[int]]:
    """The lanes of each turn where markings point to it, and those without any of its share.

    A marking points to the turn that is closest to it; to the side, to all turns to that side.
    """
    pointed: list[set[int]] = [set() for _ in angles]
    for lane, wanted in marked.items():
        for aim in wanted:
            nearest = min(range(len(angles)), key=lambda place: abs(angles[place] - aim))
            if abs(angles[nearest] - aim) < _OFF:
                pointed[nearest].add(lane)
            for place, angle in enumerate(angles):
                if turn_of(aim) in ("left", "right") and turn_of(angle) == turn_of(aim):
                    pointed[place].add(lane)
    found = []
    for share, lanes in zip(shares, pointed, strict=True):
        free = {lane for lane in share if lane not in marked}
        found.append(sorted(lanes | free) if lanes else list(share))
    return found


def _into(angle: float, lanes: Sequence[int], targets: int) -> list[tuple[int, int]]:
    """(source lane, target lane): right and straight from the curb on, left from the middle on.

    Surplus lanes merge into the last; surplus target lanes of a straight turn are fed by the last.
    """
    if turn_of(angle) == "left" or (turn_of(angle) == "u" and angle > 0.0):
        return [(lane, max(targets - 1 - place, 0)) for place, lane in enumerate(reversed(lanes))]
    pairs = [(lane, min(place, targets - 1)) for place, lane in enumerate(lanes)]
    if turn_of(angle) == "straight":
        pairs += [(lanes[-1], extra) for extra in range(len(lanes), targets)]
    return pairs
