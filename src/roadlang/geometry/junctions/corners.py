"""Corners: how round the curb is between an arm and the next one counter-clockwise."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import IntEnum

from .arms import ArmLine

SMALLEST_RADIUS = 4.0
"""Meters: the tightest curve of the middle of a lane that a car can follow."""
SLACK = 1.08
"""How much wider than that a curb lets the lane beside it turn."""
NOSE = 0.5
"""Meters: the radius of a corner that nobody turns round, or that is too sharp to turn."""
_SHARP, _BLUNT, _FLAT = math.radians(30.0), math.radians(60.0), math.radians(135.0)


class CurbSize(IntEnum):
    """How round the curbs beside an arm are: as by default, as round as a car needs, not at all.

    Roads that curbs of the default size would swallow have smaller ones.
    """

    DEFAULT = 0
    LEAST = 1
    NOSE = 2


@dataclass(frozen=True, slots=True)
class Corner:
    """Between `arm` and `neighbor`, which is next counter-clockwise: indices of the arms.

    `angle` from the one to the other, radians. `radius` of the curb in meters, None where the
    arms are so nearly opposite that there is no corner. `lane_radius` is the greatest that the
    middle of the curb lane may have, or the arc would cut the curb.
    """

    arm: int
    neighbor: int
    angle: float
    radius: float | None
    lane_radius: float


def corner_between(
    arms: tuple[ArmLine, ArmLine],
    places: tuple[int, int],
    headings: tuple[float, float],
    size: CurbSize,
) -> Corner:
    """The corner of two arms that leave with `headings`."""
    # Arms of different nodes may lean toward each other.
    least = 0.25 * math.pi if arms[0].node == arms[1].node else 0.75 * math.pi
    angle = (headings[1] - headings[0] + least) % (2.0 * math.pi) - least
    inner = _curb_to_lane(arms)
    if size is CurbSize.NOSE or inner is None:
        radius = NOSE
    else:
        radius = _radius(angle, inner, _BLUNT if size is CurbSize.DEFAULT else _FLAT)
    if angle >= _FLAT:
        return Corner(*places, angle, None, math.inf)
    lane_radius = max(SMALLEST_RADIUS * SLACK, radius + (inner or 0.0))
    return Corner(*places, angle, radius, lane_radius)


def _radius(angle: float, inner: float, default_from: float) -> float:
    """`default_from`: the angle from which on the curb has the default radius."""
    need = max(SLACK * SMALLEST_RADIUS - inner, 1.0)
    if angle < _SHARP:
        return NOSE
    return need if angle < default_from else max(SMALLEST_RADIUS, need)


def _curb_to_lane(arms: tuple[ArmLine, ArmLine]) -> float | None:
    """Meters from the curb to the middle of the lane beside it, the least of the two arms; None
    where no vehicle can turn from the first into the second."""
    first, second = arms
    trims = (min(10.0, arm.s[-1]) for arm in arms)
    start, stop = (arm.lanes(float(trim)) for arm, trim in zip(arms, trims, strict=True))
    inbound = [lane for lane in start if lane.inbound]
    outbound = [lane for lane in stop if lane.outbound]
    if not inbound or not outbound:
        return None
    return min(
        float(first.left[0]) - inbound[0].offset, float(second.right[0]) + outbound[-1].offset
    )
