"""Lines and areas in longitude and latitude, cut where they cross the antimeridian.

RFC 7946, section 3.1.9: what crosses it is several parts, none of which crosses it. Longitudes that
come in go on beyond 180 or -180 degrees, those of the parts are from -180 to 180.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Booleans, Floats

_HALF, _WHOLE = 180.0, 360.0


def cut_line(line: Floats) -> list[Floats]:
    """The parts (m, 2) of a line (n, 2) of longitudes and latitudes, degrees."""
    at = _antimeridian([line])
    if at is None:
        return [line]
    line, beyond = _with_crossings(line, at)
    parts = [line[run] for run in _runs(beyond)]
    return [_shifted(part, at) for part in parts if len(part) > 1]


def cut_area(rings: Sequence[Floats]) -> list[list[Floats]]:
    """The parts of an area, rings each: the outer one first, counter-clockwise, then clockwise
    those of holes; (n, 2) longitudes and latitudes, degrees, ending where they begin."""
    at = _antimeridian(rings)
    if at is None:
        return [list(rings)]
    found: list[list[Floats]] = []
    for is_beyond in (False, True):
        outer: list[Floats] = []
        holes: list[Floats] = []
        chains: list[Floats] = []
        for number, ring in enumerate(rings):
            points, beyond = _with_crossings(ring[:-1], at, closed=True)
            if (beyond == is_beyond).all():
                (holes if number else outer).append(ring)
            elif beyond.any() and not beyond.all():
                chains += [points[run] for run in _runs(beyond, closed=True, of=is_beyond)]
        outer += _joined([chain for chain in chains if len(chain) > 1])
        for ring in outer:
            inside = [hole for hole in holes if _holds(ring, hole[0])]
            found.append([_shifted(part, at) for part in (ring, *inside)])
    return found


def _antimeridian(lines: Sequence[Floats]) -> float | None:
    """The longitude at which to cut, 180 or -180; None where nothing is beyond either."""
    longitudes = np.concatenate([line[:, 0] for line in lines])
    if longitudes.max() > _HALF:
        return _HALF
    return -_HALF if longitudes.min() < -_HALF else None


def _with_crossings(line: Floats, at: float, closed: bool = False) -> tuple[Floats, Booleans]:
    """A line with two points more at each crossing, one for each side, and which points lie
    beyond: east of 180, west of -180."""
    following = np.roll(line, -1, axis=0) if closed else line[1:]
    points, sides = [], []
    for number, point in enumerate(line):
        side = bool((point[0] - at) * at > 0.0)
        points.append(point)
        sides.append(side)
        if number >= len(following):
            continue
        after = following[number]
        if bool((after[0] - at) * at > 0.0) != side:
            share = (at - point[0]) / (after[0] - point[0])
            crossing = np.array([at, point[1] + share * (after[1] - point[1])])
            points += [crossing, crossing]
            sides += [side, not side]
    return np.array(points), np.array(sides)


def _runs(sides: Booleans, closed: bool = False, of: bool | None = None) -> list[list[int]]:
    """The indices of points that follow each other on one side (`of`: on that side alone)."""
    count = len(sides)
    first = int(np.flatnonzero(sides != np.roll(sides, 1))[0]) if closed else 0
    order = [(first + step) % count for step in range(count)]
    runs: list[list[int]] = []
    for before, index in zip([None, *order], order, strict=False):
        if before is None or sides[index] != sides[before]:
            runs.append([])
        runs[-1].append(index)
    return [run for run in runs if of is None or sides[run[0]] == of]


def _joined(chains: Sequence[Floats]) -> list[Floats]:
    """Rings of chains that begin and end at the antimeridian: along it, the inside lies between the
    first end and the second, the third and the fourth, and so on."""
    ends = [
        (chain[side][1], number, side) for number, chain in enumerate(chains) for side in (0, -1)
    ]
    ordered = [(number, side) for _, number, side in sorted(ends)]
    partner = dict(zip(ordered[::2], ordered[1::2], strict=True))
    partner |= {second: first for first, second in partner.items()}
    left, rings = set(range(len(chains))), []
    while left:
        number, parts = min(left), []
        while number in left:
            left.discard(number)
            parts.append(chains[number])
            number = partner[number, -1][0]
        ring = np.concatenate([*parts, parts[0][:1]])
        rings.append(ring[np.append(True, (np.diff(ring, axis=0) != 0.0).any(axis=1))])
    return rings


def _holds(ring: Floats, point: Floats) -> bool:
    """Whether a point is inside a ring: a ray from it crosses the ring an odd number of times."""
    (x, y), (next_x, next_y) = ring[:-1].T, ring[1:].T
    spans = (y > point[1]) != (next_y > point[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        meets = x + (point[1] - y) / (next_y - y) * (next_x - x)
    return bool(np.count_nonzero(spans & (point[0] < meets)) % 2)


def _shifted(part: Floats, at: float) -> Floats:
    """With longitudes from -180 to 180."""
    beyond = (part[:, 0] - at) * at > 0.0
    return part - [np.copysign(_WHOLE, at), 0.0] if beyond.any() else part
