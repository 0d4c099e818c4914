"""The way around what stands in the lane: to which side, how far, and whether others leave time."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

from .lane_traffic import LaneTraffic, has_room, lane_traffic

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Booleans, Floats

BESIDE = 0.4
"""Meters between the side of a vehicle and what it passes."""
CLOSELY = 0.25
"""The same where there is no other way, slowly."""
BENT, OFF_LINE = 1.0 / 30.0, 0.3
"""After bends tighter than this (1/m) vehicles are farther off their line, and keep this much more
distance (meters) where there is room."""
LONG, LONGER = 7.0, 0.3
"""Vehicles longer than `LONG` meters keep `LONGER` meters more, because their ends swing out."""
SIGHT = 250.0
"""Meters in which others are looked for."""
MOVING = 3.0
"""Seconds of each of the two moves to the side."""
AHEAD = 4.0
"""Meters between the agent and what it has passed before it comes back."""
MEETING = 3.0
"""Seconds, and also meters, to spare before it would meet oncoming traffic."""
STANDS = 0.5
"""m/s: who is slower stands; whether it is about to come is another question."""
TO_SPARE = 2.0
"""Seconds to spare before others may come who have to gain speed first."""
STARTING = 4.0
"""Seconds that pulling out from a standstill takes longer."""
INSIDE = 0.1
"""Meters by which it may stick out of its lane without looking for others."""
NEXT = 25.0
"""Meters to the next obstacle within which it does not come back in between."""
SHORTEST = 8.0
"""Meters that it takes to come back, at least."""
INTO_JUNCTION = 2.0
"""Meters that what it passes may reach into a junction without signals."""
IN_BENDS = 0.6
"""Meters more that it may take in bends, where it covers more ground."""
LEAST_SHARE, MOST_SWING = 0.3, 1.0
"""Of the radius of a reference line at least, and meters at most, where a front swings out."""
TIGHTEST = 1.6
"""Times its wheelbase: the least radius of a line beside an obstacle."""
LOOKS = 9
"""Places along the way around at which its curvature is looked at."""


@dataclass(frozen=True)
class WayAround:
    """(N,) how agents would go around what is ahead; NaN where there is no way."""

    gap: Floats
    end: Floats
    """meters from the front to where what is in the way ends"""
    target: Floats
    """line to follow beside it"""
    crosses: Booleans
    """whether that leaves the lane"""
    is_oncoming: Booleans
    """whether traffic comes toward it there"""
    is_narrow: Booleans
    """whether it has to pass more closely than others do"""


def planned(seen: ObservationBatch, line: Floats, gap: Floats) -> WayAround:
    """How to get around objects in the way of lines, at gaps (infinite: not asked for), to the side
    with the shorter way; where there is none with the usual distance, with less."""
    import numpy as np

    reach = np.where(np.isfinite(gap), gap, 0.0) + seen.length
    bent = np.max(np.abs(bends(seen, reach)), axis=0) > BENT
    found = _planned(seen, line, gap, BESIDE + np.where(bent, OFF_LINE, 0.0))
    for apart in (BESIDE, CLOSELY):
        lacks = np.isfinite(gap) & np.isnan(found.target)
        if not lacks.any():
            break
        other = _planned(seen, line, np.where(lacks, gap, np.inf), np.full(len(gap), apart))
        found = WayAround(
            gap, found.end, np.where(lacks, other.target, found.target),
            np.where(lacks, other.crosses, found.crosses),
            np.where(lacks, other.is_oncoming, found.is_oncoming),
            np.where(lacks, apart < BESIDE, found.is_narrow),
        )  # fmt: skip
    return found


def _planned(seen: ObservationBatch, line: Floats, gap: Floats, apart: Floats) -> WayAround:
    """With (N,) this many meters between."""
    import numpy as np

    end, left, right = seen.row_ahead(line, NEXT)
    room = 0.5 * seen.width + apart + np.where(seen.length > LONG, LONGER, 0.0)
    lanes, half = seen.lanes_beside(gap + 0.5 * seen.length, line), 0.5 * seen.width
    turning = _turning(seen, gap, end)
    best = np.full(len(line), np.nan)
    crosses, oncoming = np.zeros(len(line), dtype=bool), np.zeros(len(line), dtype=bool)
    for (side, edge, beside, direction), more in product(
        (
            (1.0, left, lanes.left, lanes.left_direction),
            (-1.0, right, lanes.right, lanes.right_direction),
        ),
        (0.0, IN_BENDS),
    ):
        needed = side * edge + room + more
        needed = needed + swing(seen.length, side * turning[int(side < 0.0)], needed)
        own = side * lanes.middle + 0.5 * lanes.width
        middle = side * beside
        leaves = needed + half > own + INSIDE
        needed = np.where(leaves & (direction > 0.0), np.maximum(needed, middle), needed)
        most = np.where(np.isfinite(middle), 2.0 * middle - own, own)
        fits = (needed + half <= most) & (~leaves | (direction != 0.0)) & np.isfinite(end + gap)
        if more > 0.0:
            fits &= np.isnan(best)
        if not fits.any():
            continue
        fits &= leads_past(seen, np.where(fits, side * needed, line), end)
        shift = np.abs(needed - side * line)
        shorter = fits & ~(shift >= np.abs(best - line))
        best = np.where(shorter, side * needed, best)
        crosses = np.where(shorter, leaves, crosses)
        oncoming = np.where(shorter, leaves & (direction < 0.0), oncoming)
    return WayAround(gap, end, best, crosses, oncoming, np.zeros(len(line), dtype=bool))


def _turning(seen: ObservationBatch, gap: Floats, end: Floats) -> tuple[Floats, Floats]:
    """(N,) the greatest and the least curvatures of the reference lines beside what is passed."""
    import numpy as np

    reach = end + seen.length
    most, least = np.zeros(len(reach)), np.zeros(len(reach))
    for place, curvature in enumerate(bends(seen, reach)):
        beside = np.where(reach * (place / (LOOKS - 1)) >= gap, curvature, 0.0)
        most, least = np.maximum(most, beside), np.minimum(least, beside)
    return most, least


def swing(length: Floats, curvature: Floats, line: Floats) -> Floats:
    """(N,) meters by which the front of a vehicle, its middle on a line so far to the inside of a
    reference line of such a curvature, reaches farther to the outside: `(length / 2)^2 / (2 r)`."""
    import numpy as np

    bend = np.maximum(curvature, 0.0)
    radius_share = np.maximum(1.0 - bend * line, LEAST_SHARE)
    return np.minimum(0.125 * length * length * bend / radius_share, MOST_SWING)


def is_free(seen: ObservationBatch, plan: WayAround, speed: Floats) -> Booleans:
    """(N,) whether nobody comes toward agents, and nobody is or comes beside them, until they are
    back in their lane. `speed`: that with which they pass."""
    import numpy as np

    line = np.where(np.isfinite(plan.target), plan.target, 0.0)
    # What it passes is CLOSELY beside that line at least: it is not in the way there.
    lane = lane_traffic(seen, line, seen.nearby(SIGHT), 0.8 * CLOSELY)
    pace = np.maximum(0.5 * (np.minimum(seen.speed, speed) + speed), 1.0)
    way = plan.end + seen.length + AHEAD + MOVING * pace
    time = way / pace + np.where(seen.speed < 0.5 * speed, STARTING, 0.0)
    theirs = np.maximum(-lane.pace, 0.0) * (time + MEETING)[:, None]
    slower = lane.there & lane.ahead & (lane.pace < 1.0)
    stretch = plan.end + seen.length + AHEAD
    meeting = np.where(lane.pace > -STANDS, stretch[:, None], way[:, None] + theirs + MEETING)
    meets = slower & (lane.gap < meeting)
    along = LaneTraffic(lane.there & ~slower, lane.ahead, lane.gap, lane.pace, lane.length)
    duration = np.full(len(speed), MOVING)
    beside = has_room(seen, along, duration)
    clear = np.asarray(~meets.any(axis=1)) & beside
    to_line, _, until_red = seen.junction_ahead()
    needed = plan.end + np.where(np.isfinite(until_red), seen.length, -INTO_JUNCTION)
    clear &= ~plan.is_oncoming | (to_line < 0.0) | (to_line > needed)
    asks = clear & plan.is_oncoming
    reach = np.where(asks, plan.end + 2.0 * seen.length + AHEAD, np.nan)
    clear &= ~asks | (seen.comes_toward(plan.target, reach) > time + TO_SPARE)
    return np.asarray(np.isfinite(plan.target) & (clear | ~plan.crosses))


def leads_past(seen: ObservationBatch, line: Floats, end: Floats) -> Booleans:
    """(N,) whether lines beside what ends at `end` meters can be driven: nothing stands there
    until the agent is back, and no bend becomes too tight for it."""
    import numpy as np

    free = seen.obstacle_ahead(line) > end + seen.length + AHEAD + SHORTEST
    tightest = 1.0 / (TIGHTEST * seen.wheelbase)
    for curvature in bends(seen, end + seen.length):
        across = 1.0 - curvature * line
        bend = np.abs(curvature)
        free &= (across > 0.0) & (bend <= np.maximum(tightest, bend) * across)
    return np.asarray(free)


def bends(seen: ObservationBatch, reach: Floats) -> Floats:
    """(LOOKS, N) the curvatures of the reference lines at some places up to a distance ahead."""
    import numpy as np

    far = np.where(np.isfinite(reach), reach, 0.0)
    shares = np.arange(LOOKS)[:, None] / (LOOKS - 1)
    return seen.curvatures_ahead(far * shares)
