"""Who keeps whom from going: the rules of right of way, on groups of agents that meet."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ...plugins.kinds import STANDING_GAP
from .approaches import Approaches, braking_to_stop, seconds_for
from .grants import NEVER, Grants
from .meetings import Meetings
from .swept_paths import SPACING

CLEARANCE = 0.8
"""Seconds between two that cross, for the calmest; none for the boldest."""
HEADWAY = 0.6
"""Seconds behind who goes first where lanes merge, for the calmest."""
EAGER, EAGER_SPEED = 2.6, 12.0
"""m/s^2 and m/s: how fast who asks to go may get to where another crosses."""
SLUGGISH, SLUGGISH_SPEED = 1.2, 6.0
"""m/s^2 and m/s: how fast who goes first leaves that place."""
FROM_RIGHT, FROM_RIGHT_DISTANCE = 3.0, 8.0
"""One always yields to an agent that reaches the line within this many seconds, or is within this
many meters of it."""
EASE = 2.5
"""Seconds of clearance that the calmest leave to those to whom they yield, who then need not
slow down."""
PATIENCE = 3.0
"""Seconds after which traffic of the main road lets in who waits where lanes merge."""
LONGEST_WAIT = 15.0
"""Seconds of waiting at a line without signals after which all others yield to an agent."""
COURTEOUS = 4.0
"""m/s^2: the hardest braking with which the most polite let others in."""
BEFORE_ZONE = 0.5
"""Meters before the place where another crosses at which cars stop."""
IN_ZONE = 1.0
"""An agent that is this many meters into the place where paths cross drives on."""


def pairs(values: Any) -> tuple[Any, Any]:
    """(G, P, 1) and (G, 1, P): of the first and of the second of a pair."""
    return values[:, :, None], values[:, None, :]


def let_go(meetings: Meetings, grants: Grants) -> Booleans:
    """(G, P) who may go, or is on the junction."""
    return np.asarray(meetings.is_there & (meetings.of_crossings(grants.order) < NEVER))


def is_blocked(
    meetings: Meetings, near: Approaches, grants: Grants, speed: Floats, length: Floats,
    aggression: Floats,
) -> Booleans:  # fmt: skip
    """(G, P) for whom one that may go already leaves no gap. `speed`, `length`, `aggression` from 0
    to 1: (N,)."""
    _, other_goes = pairs(let_go(meetings, grants))
    to_line, other_line = pairs(meetings.of_crossings(near.to_line))
    speed_a, speed_b = pairs(meetings.of_agents(speed))
    other_length = meetings.of_agents(length)[:, None, :]
    calm = 1.0 - meetings.of_agents(aggression)[:, :, None]
    apart = CLEARANCE * calm
    arrives = seconds_for(to_line + meetings.begin, speed_a, EAGER, EAGER_SPEED)
    end = np.swapaxes(meetings.end, 1, 2)
    leaves_in = other_line + end + other_length
    leaves = seconds_for(leaves_in, speed_b, SLUGGISH, SLUGGISH_SPEED)
    crosses = meetings.crosses & (leaves_in > 0.0) & (arrives <= leaves + apart)
    if not meetings.has_merges:
        return np.asarray((other_goes & crosses).any(axis=2))
    gap = _behind(meetings, near, length)
    wanted = STANDING_GAP + HEADWAY * calm * speed_a + np.maximum(0.0, speed_a - speed_b)
    merges = meetings.merges & (gap <= wanted)
    return np.asarray((other_goes & (crosses | merges)).any(axis=2))


def is_occupied(meetings: Meetings, near: Approaches, grants: Grants, asks: Booleans) -> Booleans:
    """(G, P) whether a waiting agent stands on the ground that each needs. `asks`: (G, P)."""
    waits = asks & ~let_go(meetings, grants)
    _, other_waits = pairs(waits)
    _, other_line = pairs(meetings.of_crossings(near.to_line))
    into = -other_line - np.swapaxes(meetings.begin, 1, 2)
    stands = meetings.crosses & (into > SPACING)
    stands &= other_waits
    return np.asarray((stands & ~np.swapaxes(stands, 1, 2)).any(axis=2))


def is_reserved(
    meetings: Meetings, grants: Grants, could: Booleans, able: Booleans
) -> Booleans:  # fmt: skip
    """(G, P) who has to let one go that has waited for long, as nobody else, the longest of those
    who `could` go, but for others: if that one is not `able` to, everybody has to."""
    waited = np.where(could, meetings.of_crossings(grants.waiting), 0.0)
    if not (waited > LONGEST_WAIT).any():
        return np.zeros(waited.shape, dtype=bool)
    longest = waited.argmax(axis=1)[:, None]
    counts = np.take_along_axis(waited, longest, axis=1) > LONGEST_WAIT
    itself = np.arange(waited.shape[1]) == longest
    meets = np.take_along_axis(meetings.conflict, longest[:, :, None], axis=2)[:, :, 0] > 0
    waits = ~np.take_along_axis(able, longest, axis=1)
    return np.asarray(counts & ~itself & (meets | waits))


def goes_after(
    meetings: Meetings, near: Approaches, turns: Booleans, speed: Floats, length: Floats,
    aggression: Floats,
) -> Booleans:  # fmt: skip
    """(G, P, P) whether the first yields to the second, and could not have left the ground that
    both need before that one comes, if it keeps its speed. `turns`: (G, P), who slows down to turn;
    `speed`, `length`, `aggression` from 0 to 1: (N,)."""
    to_line, other_line = pairs(meetings.of_crossings(near.to_line))
    speed_a, speed_b = pairs(meetings.of_agents(speed))
    boldness, _ = pairs(meetings.of_agents(aggression))
    slow = np.where(turns[:, :, None], np.minimum(speed_a, SLUGGISH_SPEED), speed_a)
    approach = np.maximum(to_line, 0.0) / np.maximum(0.5 * (speed_a + slow), 0.5 * SLUGGISH_SPEED)
    ground = np.minimum(to_line, 0.0) + meetings.end + meetings.of_agents(length)[:, :, None]
    pace = SLUGGISH + boldness * (EAGER - SLUGGISH)
    leaves = approach + seconds_for(ground, slow, pace, SLUGGISH_SPEED)
    leaves += EASE * (1.0 - boldness)
    arrives = other_line + np.swapaxes(meetings.begin, 1, 2) - FROM_RIGHT_DISTANCE
    soon = other_line < FROM_RIGHT * speed_b + FROM_RIGHT_DISTANCE
    # `leaves` is infinite where no junction is ahead; times a speed of 0 it would be NaN.
    gone = np.multiply(leaves, speed_b, out=np.zeros_like(leaves), where=speed_b > 0.0)
    return np.asarray(meetings.yields & (soon | (arrives < gone)))


def lets_in(
    meetings: Meetings, near: Approaches, grants: Grants, asks: Booleans, speed: Floats,
    politeness: Floats,
) -> Booleans:  # fmt: skip
    """(G, P) who brakes for one that has waited long where their lanes merge, unless it has itself
    waited so long that others yield to it: two would let each other go first for good."""
    has_waited = asks & (meetings.of_crossings(grants.waiting) > PATIENCE)
    if not np.count_nonzero(has_waited):
        return has_waited
    _, waits = pairs(has_waited)
    yields = np.swapaxes(meetings.yields, 1, 2)
    meets = (meetings.merges & yields & waits).any(axis=2)
    braking = braking_to_stop(
        meetings.of_agents(speed), meetings.of_crossings(near.to_line) - BEFORE_ZONE
    )
    gentle = braking < COURTEOUS * meetings.of_agents(politeness)
    patient = meetings.of_crossings(grants.waiting) <= LONGEST_WAIT
    return np.asarray(meets & patient & gentle)


def space_for_others(meetings: Meetings, may_go: Booleans, length: Floats) -> Floats:
    """(G, P) meters of the lane that each enters which those let go already will take."""
    if not meetings.shares_any or not may_go.any():
        return np.zeros(may_go.shape)
    _, other = pairs(meetings.of_agents(length) + STANDING_GAP)
    _, counts = pairs(may_go)
    used = np.where(meetings.share_exit & counts, other, 0.0)
    return np.asarray(np.cumsum(used, axis=2)[:, :, -1])  # a sum that padding does not change


def _behind(meetings: Meetings, near: Approaches, length: Floats) -> Floats:
    """(G, P, P) the gap of the first behind the second, measured from where their lanes merge."""
    leave = np.where(meetings.is_there, meetings.of_crossings(near.to_leave), 0.0)
    first, second = pairs(leave - meetings.of_agents(length))
    return np.asarray(first - second - meetings.of_agents(length)[:, None, :])


def has_earlier_grant(meetings: Meetings, grants: Grants) -> Booleans:
    """(G, P, P) whether the second was let go, and the first later or not yet."""
    order, other_order = pairs(meetings.of_crossings(grants.order))
    row, other = pairs(meetings.row)
    earlier = (other_order < order) | ((other_order == order) & (other < row))
    return np.asarray(earlier & (other_order < NEVER))


def zone_stops(
    meetings: Meetings, near: Approaches, grants: Grants, length: Floats
) -> tuple[Floats, Floats] | None:
    """(G, P, P) meters from the front of the first to where it has to wait for the second to pass,
    infinite for no need; and where lanes merge the gap at which it follows the second. None where
    nobody meets one that was let go earlier."""
    earlier = has_earlier_grant(meetings, grants) & (meetings.conflict > 0)
    if not np.count_nonzero(earlier):
        return None
    to_line, other_line = pairs(meetings.of_crossings(near.to_line))
    other_length = meetings.of_agents(length)[:, None, :]
    to_zone = to_line + meetings.begin
    leaves_in = other_line + np.swapaxes(meetings.end, 1, 2) + other_length
    crosses = earlier & meetings.crosses & (leaves_in > 0.0) & (to_zone > -IN_ZONE)
    stop = np.where(crosses, to_zone - BEFORE_ZONE, np.inf)
    goes, _ = pairs(let_go(meetings, grants))
    merges = earlier & goes & meetings.merges
    behind = _behind(meetings, near, length)
    late = merges & (behind < to_zone - BEFORE_ZONE)
    stop = np.where(late, np.minimum(stop, to_zone - BEFORE_ZONE), stop)
    return stop, np.where(merges & ~late, behind, np.inf)
