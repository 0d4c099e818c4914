"""Cars keep to the inside of bends where the lane is too narrow for them in its middle.

A vehicle of length `l` and width `w` whose middle follows a circle of radius `r`, and which points
along it at its rear axle, `b` meters back, is turned outward by `a = b / r`. Its outer front corner
reaches `hypot(l/2 cos a - w/2 sin a, r + l/2 sin a + w/2 cos a) - r` outside of the circle, and its
inner side `r (1 - cos a) + w/2` inside. Where that is more than half of the lane outside, its line
is moved to the inside: by what is missing, or until it has as much room on both sides. A lane that
bends the other way just before or after sets a limit to that.
"""

from __future__ import annotations

import math

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ...geometry.curves.bend_room import LONG
from ...ir.scene_actor import SceneActor
from ..lines.route_lines import RouteLine
from ..vehicles.bodies import vehicle_parameters
from .leaning import SPACING, mean_bend, moved_line

SPARE = 0.2
"""Meters that remain to the border of the lane: in bends vehicles are not quite on their lines."""
EASED = 5.0
"""Meters before and after a bend in which a line is moved, and comes back."""
EASED_LIMIT = 1.0
"""Meters before and after a place where there is less room, in which a line keeps to that."""


def kept_in_lane(line: RouteLine, actor: SceneActor) -> RouteLine:
    """The line that the middle of a vehicle follows where `line` is the middle of its lane.

    It stays as it is where all of the vehicle is in a junction.
    """
    if actor.length > LONG:
        return line
    source = line.source
    even = np.linspace(0.0, source.length, max(2, math.ceil(source.length / SPACING)) + 1)
    heading = np.interp(even, source.s, source.heading)
    car = vehicle_parameters(actor)
    bend = mean_bend(even, heading, source.closed, actor.length)
    room = 0.5 * np.interp(even, source.s, np.broadcast_to(source.width, source.s.shape)) - SPARE
    outside, inside = _extents(bend, actor, 0.5 * car.wheelbase)
    needed = np.clip(outside - room, 0.0, 0.5 * np.maximum(outside - inside, 0.0))
    needed = np.where(_on_lanes(line, even, 0.5 * actor.length), needed, 0.0)
    if not needed.any():
        return line
    left = _eased(np.sign(bend) * needed, source.closed)
    is_lane = _on_lanes(line, even, 0.0)
    for side in (1.0, -1.0):
        is_inside = side * bend > 0.0
        most = np.maximum(room - np.where(is_inside, inside, outside), needed * is_inside)
        most = _around(np.where(is_lane, most, math.inf), EASED_LIMIT, source.closed).min(axis=1)
        left = side * np.minimum(side * left, most)
    left = _around(left, EASED_LIMIT, source.closed).mean(axis=1)
    return moved_line(line, np.interp(source.s, even, left))


def _extents(bend: Floats, actor: SceneActor, base: float) -> tuple[Floats, Floats]:
    """Meters that a vehicle covers outside and inside of bends of these curvatures (n,)."""
    half, beside = 0.5 * actor.length, 0.5 * actor.width
    radius = 1.0 / np.maximum(np.abs(bend), 1e-4)
    angle = base / radius
    sine, cosine = np.sin(angle), np.cos(angle)
    corner = half * cosine - beside * sine, radius + half * sine + beside * cosine
    return np.hypot(*corner) - radius, radius * (1.0 - cosine) + beside


def _on_lanes(line: RouteLine, s: Floats, around: float) -> Booleans:
    """(n,) whether there is a lane of a road within a distance in meters of arc lengths (n,)."""
    begins = np.array([leg.begin for leg in line.legs])
    is_lane = np.array([leg.turn is None for leg in line.legs])
    legs = (np.searchsorted(begins, s + side, side="right") - 1 for side in (-around, around))
    before, after = (is_lane[np.maximum(found, 0)] for found in legs)
    return np.asarray(before | after)


def _eased(wanted: Floats, closed: bool) -> Floats:
    """What is to each side at least as far as wanted, and changes within about 2 `EASED`."""
    out = np.zeros_like(wanted)
    for side in (1.0, -1.0):
        far = _around(np.maximum(side * wanted, 0.0), EASED, closed).max(axis=1)
        for _ in range(2):
            far = _around(far, 0.5 * EASED, closed).mean(axis=1)
        out += side * far
    return out


def _around(values: Floats, meters: float, closed: bool) -> Floats:
    """(n, m) what is within a distance in meters of each place."""
    count = min(round(meters / SPACING), (len(values) - 1) // 2)
    wide = np.pad(values, count, mode="wrap" if closed else "edge")
    return np.lib.stride_tricks.sliding_window_view(wide, 2 * count + 1)
