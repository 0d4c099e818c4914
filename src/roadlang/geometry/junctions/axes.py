"""The order of roads at a junction by geometry, which a mirrored drawing with traffic on the other
side shares."""

from __future__ import annotations

import math
from collections.abc import Iterable

from ..networks.junction_model import Arm, Junction

Axis = tuple[float, float]

OPPOSITE = math.radians(135.0) + 1e-6
"""Roads whose headings differ by more face each other. Not those at 135 degrees, whatever the
rounding of their headings."""


def heading_of(junction: Junction, arm: Arm) -> float:
    """The heading of an arm away from the junction."""
    (xl, yl), (xr, yr) = junction.area[arm.left], junction.area[arm.right]
    return math.atan2(xr - xl, yl - yr)


def axis_order(headings: Iterable[float], *, left_hand: bool) -> Axis:
    """A key to sort groups of arms by: those that run east and west come first.

    It is the sum of `(-cos 2h, -sin 2h)` over the headings h, of left-hand traffic over -h. A turn
    of the drawing by half a circle changes nothing in it, and a mirror image at the x axis with
    traffic on the other side neither, hence one at the y axis neither. Groups with equal keys lie
    along one axis.
    """
    side = -1.0 if left_hand else 1.0
    doubled = [2.0 * heading for heading in headings]
    along = round(-sum(map(math.cos, doubled)), 6)
    return along + 0.0, round(-side * sum(map(math.sin, doubled)), 6) + 0.0
