"""The lanelets of roads: each lane, cut where lanes beside it begin and end, and where the speed
limit changes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from roadlang.geometry import Floats, Lane
from roadlang_formats.surfaces.built import is_loop
from roadlang_formats.surfaces.road_surface import RoadSurface

from .model import Border, Lanelet, Side

_GONE = 0.02
"""Meters of width at which a lane has none."""
_LOOP_PARTS = 3
"""Of a loop, because a lanelet must not lead into itself."""
_MOST_TURN = math.radians(150.0)
"""Of the direction of a lanelet whose road crosses itself: it must not lie on itself, because
others ask which places are inside of its outline."""


@dataclass
class Drafts:
    """What is found so far of a map."""

    borders: list[Border]
    lanelets: list[Lanelet]
    links: list[tuple[int, int]]
    leaving: dict[tuple[str, str, int], int]
    entering: dict[tuple[str, str, int], int]

    def add(self, lanelet: Lanelet) -> int:
        """Its number."""
        self.lanelets.append(lanelet)
        return len(self.lanelets) - 1


def add_road(drafts: Drafts, surface: RoadSurface) -> None:
    """The lanelets of a road, linked with one another."""
    borders = _closed_up(surface)
    parts = [
        _add_part(
            drafts, surface, borders[:, first : last + 1], present, _limit(surface, first, last)
        )
        for first, last, present in _parts(surface, borders)
    ]
    name = surface.road.name
    following = [*pairwise(parts), *([(parts[-1], parts[0])] if is_loop(surface.road) else [])]
    for one, other in following:
        for (lane, forward), source in one.items():
            target = other.get((lane, forward))
            if target is not None:
                drafts.links.append((source, target) if forward else (target, source))
    for end, part in (("start", parts[0]), ("end", parts[-1])):
        for (lane, forward), number in part.items():
            leaves = forward == (end == "end")
            (drafts.leaving if leaves else drafts.entering)[name, end, lane] = number


def _closed_up(surface: RoadSurface) -> Floats:
    """(L + 1, n, 3) borders, where lanes without width have one border on both sides."""
    borders = surface.borders.copy()
    widths = np.linalg.norm(np.diff(borders, axis=0), axis=2)
    for place, width in enumerate(widths):
        borders[place + 1, width < _GONE] = borders[place, width < _GONE]
    if is_loop(surface.road):
        borders[:, -1] = borders[:, 0]
    return np.round(borders, 6)


def _parts(surface: RoadSurface, borders: Floats) -> list[tuple[int, int, tuple[bool, ...]]]:
    """First and last station of parts in which the same lanes have a width and the speed limit is
    the same, and which lanes they are."""
    wide = np.linalg.norm(np.diff(borders, axis=0), axis=2) > 0.0
    spans = (wide[:, 1:] | wide[:, :-1]).T
    cuts = [0, *(np.flatnonzero((spans[1:] != spans[:-1]).any(axis=1)) + 1).tolist(), len(spans)]
    limits = [zone.start for zone in surface.road.zones()[1:]]
    cuts = sorted({*cuts, *(int(np.abs(surface.stations - limit).argmin()) for limit in limits)})
    if is_loop(surface.road):
        even = [round(len(spans) * k / _LOOP_PARTS) for k in range(1, _LOOP_PARTS)]
        cuts = sorted({*cuts, *even})
    cuts = sorted({*cuts, *_untangled(borders, cuts)})
    return [
        (first, last, tuple(bool(is_wide) for is_wide in spans[first]))
        for first, last in pairwise(cuts)
        if last > first
    ]


def _untangled(borders: Floats, cuts: Sequence[int]) -> list[int]:
    """Further cuts, in parts that cross themselves: each may do so only if it turns far enough."""
    found = []
    for first, last in pairwise(cuts):
        lines = borders[:, first : last + 1, :2]
        outline = np.vstack((lines[0], lines[-1, ::-1]))
        middle = np.diff(lines.mean(axis=0), axis=0)
        turned = np.unwrap(np.arctan2(middle[:, 1], middle[:, 0]))
        if np.ptp(turned) <= _MOST_TURN or not _crosses_itself(outline):
            continue
        begin = 0
        for place in range(1, len(turned)):
            if np.ptp(turned[begin : place + 1]) > _MOST_TURN:
                found.append(first + place)
                begin = place
    return found


def _crosses_itself(ring: Floats) -> bool:
    """Whether two sides of a ring (n, 2) cross: each has its ends on both sides of the other."""
    ahead = np.roll(ring, -1, axis=0) - ring
    x, y = (ring[None, :, k] - ring[:, None, k] for k in (0, 1))
    begins = ahead[:, None, 0] * y - ahead[:, None, 1] * x
    parted = begins * np.roll(begins, -1, axis=1) < 0.0
    return bool((parted & parted.T).any())


def _limit(surface: RoadSurface, first: int, last: int) -> float | None:
    """The speed limit of the road between two stations, m/s."""
    middle = (surface.stations[first] + surface.stations[last]) / 2.0
    return surface.road.limit_at(float(middle))


def _add_part(
    drafts: Drafts,
    surface: RoadSurface,
    borders: Floats,
    present: Sequence[bool],
    limit: float | None,
) -> dict[tuple[int, bool], int]:
    """The numbers of the lanelets of a part, by lane and whether they run along the road."""
    lanes = [
        lane for lane, is_there in zip(surface.section.lanes, present, strict=True) if is_there
    ]
    places = [place for place, is_there in enumerate(present) if is_there]
    markings = surface.section.markings
    first = len(drafts.borders)
    for place in [*places, places[-1] + 1]:
        points = tuple((x, y, z) for x, y, z in borders[place].tolist())
        drafts.borders.append(Border(points, markings[place]))
    found: dict[tuple[int, bool], int] = {}
    for place, lane in enumerate(lanes):
        for forward in _directions(lane):
            lanelet = _lanelet(surface.road.name, lane, first + place, forward, limit)
            found[lane.id, forward] = drafts.add(lanelet)
    _add_neighbors(drafts, lanes, found)
    return found


def _directions(lane: Lane) -> tuple[bool, ...]:
    """Whether its lanelets run along the road; vehicles have one for each of their directions."""
    if lane.drivable and lane.direction == "both":
        return (True, False)
    return (lane.direction != "backward",)


def _lanelet(road: str, lane: Lane, border: int, forward: bool, limit: float | None) -> Lanelet:
    sides = Side(border, not forward), Side(border + 1, not forward)
    left, right = sides if forward else sides[::-1]
    limit = limit if lane.drivable else None
    return Lanelet(
        road,
        lane.id,
        left,
        right,
        lane.kind,
        lane.users,
        lane.drivable,
        both_ways=not lane.drivable and lane.direction == "both",
        speed_limit=lane.speed_limit if lane.speed_limit is not None else limit,
    )


def _add_neighbors(
    drafts: Drafts, lanes: Sequence[Lane], found: dict[tuple[int, bool], int]
) -> None:
    """Lanelets beside each other; those of a lane for both directions have none."""
    single = [lane for lane in lanes if len(_directions(lane)) == 1]
    for one, other in pairwise(lanes):
        if one not in single or other not in single:
            continue
        left = found[one.id, _directions(one)[0]]
        right = found[other.id, _directions(other)[0]]
        same = _directions(one) == _directions(other)
        _set(drafts, left, (right, same), is_right=_directions(one)[0])
        _set(drafts, right, (left, same), is_right=not _directions(other)[0])


def _set(drafts: Drafts, number: int, beside: tuple[int, bool], *, is_right: bool) -> None:
    lanelet = drafts.lanelets[number]
    drafts.lanelets[number] = (
        replace(lanelet, beside_right=beside) if is_right else replace(lanelet, beside_left=beside)
    )
