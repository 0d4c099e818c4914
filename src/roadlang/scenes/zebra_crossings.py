"""Zebra crossings: those that a scene file places, and where a road with sidewalks on both sides
enters a junction."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from ..geometry.areas.footprints import Footprints, separation
from ..geometry.areas.rings import outside_ring
from ..geometry.arrays import Floats
from ..ir.scene_actor import SceneActor
from ..ir.scene_junctions import SceneArm, SceneJunction
from ..ir.scene_road import SceneRoad

DEPTH = 3.0
"""Meters that people have to walk on."""
SETBACK = 0.6
"""Meters from the end of the road, where vehicles stop, to the crossing."""
STRIPE = 0.5
"""Meters: the width of a stripe, and of the gap to the next."""
_ON_FOOT = "pedestrian"


def crossings(junction: SceneJunction, roads: Mapping[str, SceneRoad]) -> Iterator[Floats]:
    """The stripes (4, 2) of all crossings of a junction, inside its area; none over another."""
    ring = np.array(junction.area)
    found: list[Floats] = []
    for arm in junction.arms:
        crossing = _crossing(arm, ring, roads[arm.road])
        if crossing is None or (outside_ring(ring, *_along_border(crossing).T) >= 0.0).any():
            continue
        if any(_overlap(crossing, other) for other in found):
            continue
        found.append(crossing)
        yield from _stripes(crossing)


def crosswalk_stripes(marking: SceneActor) -> Iterator[Floats]:
    """The stripes (4, 2) of a crosswalk, along its heading."""
    cosine, sine = math.cos(marking.heading), math.sin(marking.heading)
    along = 0.5 * marking.length * np.array([cosine, sine])
    across = 0.5 * marking.width * np.array([-sine, cosine])
    middle = np.array([marking.x, marking.y])
    near, far = middle - along, middle + along
    yield from _stripes(np.array([near + across, near - across, far - across, far + across]))


def _crossing(arm: SceneArm, ring: Floats, road: SceneRoad) -> Floats | None:
    """(4, 2) its corners: left and right nearer to the road, then right and left inside."""
    section = road.cross_section()
    walked = [place for place, lane in enumerate(section.lanes) if _ON_FOOT in lane.users]
    driven = [place for place, lane in enumerate(section.lanes) if lane.drivable]
    if not walked or not driven or not walked[0] < driven[0] <= driven[-1] < walked[-1]:
        return None
    first, last = walked[0] + 1, walked[-1]
    station = road.trim[0] if arm.end == "start" else road.length - road.trim[1]
    borders = section.border_offsets(station)
    left, right = ring[arm.left], ring[arm.right]
    outer = float(borders[0] - borders[-1])
    before = float(borders[0] - borders[first]) / outer
    after = float(borders[0] - borders[last]) / outer
    if arm.end == "end":
        before, after = 1.0 - after, 1.0 - before
    across = right - left
    inward = np.array([across[1], -across[0]]) / max(float(np.hypot(*across)), 1e-9)
    near = left + across * before, left + across * after
    corners = [point + SETBACK * inward for point in near]
    corners += [point + (SETBACK + DEPTH) * inward for point in reversed(near)]
    return np.array(corners)


def _stripes(crossing: Floats) -> Iterator[Floats]:
    """Stripes along the road, as many as fit, in the middle."""
    left, right, inner_right, inner_left = crossing
    width = float(np.hypot(*(right - left)))
    count = int((width + STRIPE) / (2.0 * STRIPE) + 1e-9)
    first = (width - (2 * count - 1) * STRIPE) / 2.0
    for number in range(count):
        start = (first + 2 * number * STRIPE) / width
        stop = start + STRIPE / width
        yield np.array(
            [
                left + start * (right - left),
                left + stop * (right - left),
                inner_left + stop * (inner_right - inner_left),
                inner_left + start * (inner_right - inner_left),
            ]
        )


def _along_border(crossing: Floats) -> Floats:
    """Points round a crossing, a little inside."""
    middle = crossing.mean(axis=0)
    shares = np.linspace(0.0, 1.0, 8, endpoint=False)[:, None]
    sides = [
        start + shares * (stop - start)
        for start, stop in zip(crossing, np.roll(crossing, -1, axis=0), strict=True)
    ]
    return np.asarray(middle + 0.98 * (np.concatenate(sides) - middle))


def _overlap(first: Floats, second: Floats) -> bool:
    return bool(separation(_box(first), _box(second)) < 0.0)


def _box(corners: Floats) -> Footprints:
    x, y = corners.mean(axis=0)
    across, along = corners[1] - corners[0], corners[3] - corners[0]
    heading = np.arctan2(along[1], along[0])
    return Footprints(x, y, heading, np.hypot(*along), np.hypot(*across))
