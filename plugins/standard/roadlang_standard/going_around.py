"""Going around what stands in the lane: where, and whether others leave the time for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .lane_traffic import LaneTraffic, has_room, lane_traffic
from .pulling_out import CLEARED, can_creep_out, creeping_out, held_back

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Booleans, Floats

BESIDE = 0.4
"""Meters between the side of a vehicle and what it passes."""
LONG, LONGER = 7.0, 0.3
"""Longer vehicles keep so much more, as their ends swing out: meters."""
SIGHT = 250.0
"""Meters in which others are looked for."""
SOON, LEAST = 5.0, 40.0
"""Seconds of its speed, and meters at least, at which a vehicle begins to go around."""
SLOWLY = 8.3
"""m/s: the greatest speed beside what stands."""
MOVING = 3.0
"""Seconds of each of the two moves to the side."""
GAINING = 2.6
"""m/s^2, the acceleration of an agent that begins to go around."""
CLOSEST = 3.0
"""Meters that remain to what it passes once it is clear of its old line."""
BEYOND = 1.2
"""Meters past the line beside the obstacle that it aims for when it pulls out from close behind."""
NEARLY = 0.35
"""Share of the move to the side that is left when pulling out from close behind ends."""
AHEAD = 4.0
"""Meters between the agent and what it has passed before it comes back."""
MEETING = 3.0
"""Seconds, and also meters, to spare before it would meet oncoming traffic."""
STARTING = 4.0
"""Seconds that pulling out from a standstill takes longer."""
INSIDE = 0.1
"""Meters by which it may stick out of its lane without looking for others."""
BACK = 0.3
"""Meters from its line at which it is back."""
NEXT = 25.0
"""Meters to the next obstacle within which it does not come back in between."""
HOME, AROUND, RETURNING = 0.0, 1.0, 2.0
PHASE, LINE, TARGET, END, CLOSE = range(5)
"""Columns of the state: what it is doing, the line that it left and the one beside, where along its
line what it passes ends, and whether it pulls out from close behind."""


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


def planned(seen: ObservationBatch, line: Floats, gap: Floats) -> WayAround:
    """How to get around objects in the way of lines, at gaps, to the side with the shorter way."""
    import numpy as np

    end, left, right = seen.row_ahead(line, NEXT)
    room = 0.5 * seen.width + BESIDE + np.where(seen.length > LONG, LONGER, 0.0)
    place, half = seen.lane_place(), 0.5 * seen.width
    best = np.full(len(line), np.nan)
    crosses, oncoming = np.zeros(len(line), dtype=bool), np.zeros(len(line), dtype=bool)
    for side, word, edge in ((1.0, "left", left), (-1.0, "right", right)):
        needed = side * edge + room
        own = side * place.offset + 0.5 * place.width
        middle = side * seen.offset_of_lane(word)
        direction = seen.direction_of_lane(word)
        leaves = needed + half > own + INSIDE
        needed = np.where(leaves & (direction > 0.0), np.maximum(needed, middle), needed)
        most = np.where(np.isfinite(middle), 2.0 * middle - own, own)
        fits = (needed + half <= most) & (~leaves | (direction != 0.0)) & np.isfinite(end)
        shift = np.abs(needed - side * line)
        shorter = fits & ~(shift >= np.abs(best - line))
        best = np.where(shorter, side * needed, best)
        crosses = np.where(shorter, leaves, crosses)
        oncoming = np.where(shorter, leaves & (direction < 0.0), oncoming)
    return WayAround(gap, end, best, crosses, oncoming)


def is_free(seen: ObservationBatch, plan: WayAround, speed: Floats) -> Booleans:
    """(N,) whether nobody comes toward agents, and nobody is or comes beside them, until they are
    back in their lane. `speed`: that with which they pass."""
    import numpy as np

    lane = lane_traffic(seen, np.where(np.isfinite(plan.target), plan.target, 0.0),
                        seen.nearby(SIGHT))  # fmt: skip
    way = plan.end + seen.length + AHEAD + MOVING * speed
    pace = np.maximum(0.5 * (np.minimum(seen.speed, speed) + speed), 1.0)
    time = way / pace + np.where(seen.speed < 0.5 * speed, STARTING, 0.0)
    theirs = np.maximum(-lane.pace, 0.0) * (time + MEETING)[:, None]
    slower = lane.there & lane.ahead & (lane.pace < 1.0)
    meets = slower & (lane.gap < way[:, None] + theirs + MEETING)
    along = LaneTraffic(lane.there & ~slower, lane.ahead, lane.gap, lane.pace, lane.length)
    duration = np.full(len(speed), MOVING)
    beside = has_room(seen, along, duration)
    clear = np.asarray(~meets.any(axis=1)) & beside
    before_junction = seen.junction_ahead()[0]
    clear &= ~plan.is_oncoming | (before_junction > plan.end + seen.length)
    return np.asarray(np.isfinite(plan.target) & (clear | ~plan.crosses))


@dataclass(frozen=True)
class GoingAround:
    """(N,) what those that go around do: which they are, what they steer and how fast they go."""

    passing: Booleans
    line: Floats
    time: Floats
    most: Floats
    """m/s^2, of the acceleration"""
    speed: Floats
    """m/s, at most"""
    creeps: Booleans
    steering: Floats


def going_around(seen: ObservationBatch, state: Any, target: Floats) -> GoingAround | None:
    """What agents with target speeds do about objects in their lanes. Changes their state. None
    where there are none."""
    import numpy as np

    gap = seen.obstacle_ahead()
    if not np.isfinite(gap).any() and not state[:, PHASE].any():
        return None
    now = seen.road_offset - seen.cross_track_error
    phase = state[:, PHASE].copy()
    home = np.where(phase == HOME, now, state[:, LINE])
    plan = planned(seen, home, gap)
    speed = np.minimum(target, SLOWLY)
    line = np.full(len(now), np.nan)
    most = np.full(len(now), np.inf)
    _begin(seen, state, plan, speed, (line, most))
    _go_on(seen, state, home, line)
    passing = state[:, PHASE] == AROUND
    creeps = passing & (state[:, CLOSE] > 0.0)
    steering, slow = creeping_out(seen, 2.0)
    left = np.abs(seen.road_offset - state[:, TARGET])
    state[left < NEARLY * np.abs(state[:, TARGET] - state[:, LINE]), CLOSE] = 0.0
    most = np.where(creeps, np.minimum(most, slow), most)
    side = np.sign(state[:, TARGET] - state[:, LINE])
    line = np.where(passing, state[:, TARGET] + np.where(creeps, side * BEYOND, 0.0), line)
    time = np.where(creeps, 0.0, MOVING)
    speed = np.where(passing, speed, np.inf)
    return GoingAround(passing, line, time, most, speed, creeps, steering)


def _begin(
    seen: ObservationBatch, state: Any, plan: WayAround, speed: Floats, out: tuple[Floats, Floats]
) -> None:
    """Those that are near enough pull out where all is free, and else stop where they can still
    pull out."""
    import numpy as np

    line, most = out
    near = plan.gap < np.maximum(SOON * seen.speed, LEAST)
    waits = (state[:, PHASE] == HOME) & near & np.isfinite(plan.target)
    if not waits.any():
        return
    aside = CLEARED * MOVING
    has_way = plan.gap > aside * (seen.speed + 0.5 * GAINING * aside) + CLOSEST
    ready = waits & (has_way | can_creep_out(seen, plan.gap))
    nobody = ~(seen.vehicle_ahead()[0] < plan.gap)
    goes = ready & nobody & is_free(seen, plan, speed)
    held = held_back(seen, plan.gap, np.zeros(len(line)), waits & ~goes)
    most[:] = np.where(np.isfinite(held), held, most)
    now = seen.road_offset - seen.cross_track_error
    end = seen.traveled + plan.end + seen.length
    for column, value in (
        (PHASE, AROUND), (LINE, now), (TARGET, plan.target), (END, end), (CLOSE, ~has_way),
    ):  # fmt: skip
        state[:, column] = np.where(goes, value, state[:, column])
    line[goes] = plan.target[goes]


def _go_on(seen: ObservationBatch, state: Any, home: Floats, line: Floats) -> None:
    """Those that have passed come back to the lines `home`, unless more stands there."""
    import numpy as np

    around = state[:, PHASE] == AROUND
    if around.any():
        ahead = seen.row_ahead(home, NEXT)[0]
        more = around & (ahead < NEXT + seen.length)
        state[more, END] = np.maximum(state[:, END], seen.traveled + ahead + seen.length)[more]
        past = around & (seen.traveled > state[:, END] + AHEAD - 0.5 * seen.length)
        lane = lane_traffic(seen, home, seen.nearby(SIGHT))
        beside = (lane.there & (lane.gap < 1.0)).any(axis=1)
        back = past & ~beside
        state[back, PHASE] = RETURNING
        line[back] = home[back]
    returning = state[:, PHASE] == RETURNING
    there = returning & (np.abs(seen.road_offset - home) < BACK)
    state[there, PHASE] = HOME
