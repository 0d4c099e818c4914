"""Turns back into the road that one comes from: up to three arcs, with room inside the junction."""

from __future__ import annotations

import math
from collections.abc import Mapping, MutableMapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arrays import Floats
from .area import surface
from .arms import ArmKey, ArmLine
from .connecting import Connected, connected, pair_widths, push
from .connection_curves import Fits, along
from .corners import SMALLEST_RADIUS
from .lane_pairs import ArmLanes, LanePair
from .places import JunctionSite
from .sweeping import TOLERANCE, ring_round, road_beyond, valid

_RADII = (1.0, 1.3)
_SHARES = (0.0, 1.0)
"""Of the angle of two equal arcs to the right: that of the lesser one."""
_STRAIGHT = (0.0, 1.0, 2.0, 4.0, 6.0, 9.0, 13.0, 18.0, 24.0)
_BAY = 2.5
"""Meters that the surface of a junction may be made larger for a turn."""
_PIECES = 5
_SAMPLES = np.linspace(0.0, 1.0, 65)
_FEWEST_ARMS = 3
_LEAST_APART = 0.1
_ROUNDS = 5


@dataclass(frozen=True)
class _Bend:
    """A line, three arcs and a line."""

    lengths: tuple[float, ...]
    curvatures: tuple[float, ...]


def with_u_turns(
    place: JunctionSite,
    found: Connected,
    trims: MutableMapping[ArmKey, float],
    lines: Mapping[ArmKey, ArmLine],
) -> Connected:
    """The turns of a place, and those from the lane next to the middle of each road back into the
    same road, where there is room: on the surface that the other turns need, or at most 2.5 m
    beside it, and never on a road beyond its face.

    Of all that have room the one counts that leaves the surface the least, then the shortest. Where
    a road has none, moves the trims in place, all of them alike.
    """
    if len(found.arms) < _FEWEST_ARMS:
        return found
    wanted = sum(_is_two_way(lanes) for lanes in found.lanes)
    best, least = _with_them(place, found, trims, lines), _copy(found, trims)
    for _ in range(_ROUNDS):
        moved = [push(place, arm.key, trims) for arm in found.arms] if _count(best) < wanted else []
        if not any(moved):
            break
        found = connected(place, trims)
        other = _with_them(place, found, trims, lines)
        if _count(other) > _count(best) and other.refused.sum() <= best.refused.sum():
            best, least = other, _copy(found, trims)
    trims.update(least)
    return best


def _count(found: Connected) -> int:
    return sum(pair.source == pair.target for pair in found.pairs)


def _copy(found: Connected, trims: Mapping[ArmKey, float]) -> dict[ArmKey, float]:
    return {arm.key: trims[arm.key] for arm in found.arms}


def _is_two_way(lanes: ArmLanes) -> bool:
    """Whether there is a lane to turn from, and one to turn into."""
    return _apart(lanes) >= _LEAST_APART and not lanes.circles


def _apart(lanes: ArmLanes) -> float:
    """Meters between the two lanes next to the middle. Seen from the junction the one that leads in
    lies to the left: traffic keeps right."""
    if not lanes.inbound or not lanes.outbound:
        return 0.0
    return lanes.inbound[-1].offset - lanes.outbound[-1].offset


def _with_them(
    place: JunctionSite,
    found: Connected,
    trims: Mapping[ArmKey, float],
    lines: Mapping[ArmKey, ArmLine],
) -> Connected:
    import shapely

    widths = [pair_widths(found, pair) for pair in found.pairs]
    area = surface(place, found, trims, widths, place.halves(lines))
    roads = [road_beyond(arm, trims, TOLERANCE) for arm in found.arms]
    beyond = shapely.union_all([road for road in roads if road is not None])
    for arm, lanes in enumerate(found.lanes):
        if not _is_two_way(lanes):
            continue
        face, source, target = found.faces[arm], lanes.inbound[-1], lanes.outbound[-1]
        from_lane, into_lane = len(lanes.inbound) - 1, len(lanes.outbound) - 1
        pair = LanePair(arm, from_lane, arm, into_lane, math.pi, "u")
        begin = np.array([face.beside(source.offset)]), np.array([face.heading + math.pi])
        bends = _bends(_apart(lanes))
        best = _roomiest(bends, begin, (source.width, target.width), area, beyond)
        found = found if best is None else _added(found, pair, begin, bends[best])
    return found


def _bends(apart: float) -> list[_Bend]:
    """Turns to the left between two lines of opposite direction. Where these are closer than twice
    the radius, an arc to the right goes before the turn, or follows it, or both."""
    found = []
    for share in _RADII:
        radius = max(share * SMALLEST_RADIUS, apart / 2.0)
        # With such angles to the right, cos(first) + cos(last) = 1 + apart / (2 radius).
        total = 1.0 + apart / (2.0 * radius)
        for share_of_equal in _SHARES:
            less = share_of_equal * math.acos(min(total / 2.0, 1.0))
            more = math.acos(min(total - math.cos(less), 1.0))
            for first, last in ((less, more), (more, less)):
                found += _around(radius, first, last)
    return list(dict.fromkeys(found))


def _around(radius: float, first: float, last: float) -> list[_Bend]:
    """To the right, round to the left and to the right again, after straights of some lengths."""
    lag, bend = 2.0 * radius * (math.sin(last) - math.sin(first)), 1.0 / radius
    middle = radius * first, radius * (math.pi + first + last), radius * last
    before, after = max(lag, 0.0), max(-lag, 0.0)
    return [
        _Bend((straight + before, *middle, straight + after), (0.0, -bend, bend, -bend, 0.0))
        for straight in _STRAIGHT
    ]


def _added(
    found: Connected, pair: LanePair, begin: tuple[Floats, Floats], bend: _Bend
) -> Connected:
    """The turns with one more."""
    fits = found.fits
    lengths = np.vstack([_padded(fits.lengths), bend.lengths])
    curvatures = np.vstack([_padded(fits.curvatures), bend.curvatures])
    start = np.vstack([fits.start, begin[0]])
    heading = np.concatenate([fits.heading, begin[1]])
    drivable = np.append(fits.drivable, True)
    swept = np.vstack([found.swept, np.zeros((1, len(found.arms)), dtype=bool)])
    return replace(
        found,
        pairs=(*found.pairs, pair),
        fits=Fits(start, heading, lengths, curvatures, drivable),
        found_sweeps=swept,
    )


def _padded(pieces: Floats) -> Floats:
    return np.pad(pieces, ((0, 0), (0, _PIECES - pieces.shape[1])))


def _roomiest(
    bends: list[_Bend], begin: tuple[Floats, Floats], widths: tuple[float, float], area: Any,
    beyond: Any,
) -> int | None:  # fmt: skip
    """Which of the turns leaves the area the least; None where none of them has room."""
    import shapely

    count = len(bends)
    lengths = np.array([bend.lengths for bend in bends])
    curvatures = np.array([bend.curvatures for bend in bends])
    start, heading = np.repeat(begin[0], count, axis=0), np.repeat(begin[1], count)
    points, headings = along(start, heading, lengths, curvatures, _SAMPLES)
    half = np.broadcast_to((widths[0] + (widths[1] - widths[0]) * _SAMPLES) / 2.0, headings.shape)
    strips = valid(shapely.polygons(ring_round(points, headings, half)))
    away = np.zeros(count)
    corners, of = shapely.get_coordinates(shapely.difference(strips, area), return_index=True)
    np.maximum.at(away, of, shapely.distance(area, shapely.points(corners)))
    away = np.where(shapely.intersects(beyond, strips), np.inf, away)
    order = np.lexsort((lengths.sum(axis=1).round(3), away.round(2)))
    return int(order[0]) if away[order[0]] <= _BAY else None
