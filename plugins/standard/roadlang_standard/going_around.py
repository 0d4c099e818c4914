"""Going around what stands in the lane: when it begins, how it goes on, and how it ends."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from .lane_traffic import lane_traffic
from .pulling_out import CLEARED, SLOWEST, TURNED, can_creep_out, creeping_out, held_back
from .steering import SPEED_GAIN
from .ways_around import (
    AHEAD,
    MOVING,
    NEXT,
    SIGHT,
    WayAround,
    bends,
    is_free,
    leads_past,
    planned,
)

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Booleans, Floats

SOON, LEAST = 5.0, 40.0
"""Seconds of its speed, and meters at least, at which a vehicle looks for a way around."""
LATER, SPARE = 1.0, 8.0
"""Seconds of its speed, and meters at least, beyond what pulling out takes, at which it begins."""
SLOWLY = 8.3
"""m/s: the greatest speed beside what stands."""
NARROWLY = 2.0
"""m/s: the same where the way is narrow."""
LATERAL, EASILY = 2.5, 1.5
"""m/s^2: across and along, in bends beside what stands."""
GAINING = 2.6
"""m/s^2, the acceleration of an agent that begins to go around."""
CLOSEST = 3.0
"""Meters that remain to what it passes once it is clear of its old line."""
BEYOND = 1.2
"""Meters past the line beside the obstacle that it aims for when it pulls out from close behind."""
NEARLY = 0.35
"""Share of the move to the side that is left when pulling out from close behind ends."""
BACK = 0.3
"""Meters from its line at which it is back."""
EARLY, TOUCHING = 1.5, 0.5
"""It goes no faster than it could brake, with this deceleration (m/s^2), to stop this many meters
before what it would touch on its way. Its way is checked every 0.5 m, so a contact may be that much
nearer than it seems."""
PASSED = 0.5
"""Meters before the end of what is passed up to which what stands there belongs to it."""
COMING, LEAST_AHEAD = 0.3, 1.5
"""If an oncoming agent is faster than this, in m/s, it returns as soon as it is this many meters
past the obstacle."""
HOME, AROUND, RETURNING = 0.0, 1.0, 2.0
PHASE, LINE, TARGET, END, CLOSE, NARROW = COLUMNS = range(6)
"""Columns of the state: what it is doing, the line that it left and the one beside, where along its
line what it passes ends, whether it pulls out from close behind, and whether the way is narrow."""


@dataclass(frozen=True)
class GoingAround:
    """(N,) what those that go around do: which they are, what they steer and how fast they go."""

    passing: Booleans
    """away from their lines: they stop for objects at `stop` alone"""
    line: Floats
    time: Floats
    most: Floats
    """m/s^2, of the acceleration"""
    speed: Floats
    """m/s, at most"""
    stop: Floats
    """meters to where they stop before the next object"""
    creeps: Booleans
    steering: Floats


def going_around(seen: ObservationBatch, state: Any, target: Floats) -> GoingAround | None:
    """What agents with target speeds do about objects in their lanes. Changes their state. None
    where there are none."""
    import numpy as np

    gap = seen.obstacle_ahead()
    near = gap < np.maximum(SOON * seen.speed, LEAST)
    if not np.count_nonzero(near) and not np.count_nonzero(state[:, PHASE]):
        return None
    now = seen.road_offset - seen.cross_track_error
    home = np.where(state[:, PHASE] == HOME, now, state[:, LINE])
    line = np.full(len(now), np.nan)
    most = np.full(len(now), np.inf)
    looks = near & (state[:, PHASE] == HOME)
    if looks.any():
        plan = planned(seen, home, np.where(looks, gap, np.inf))
        _begin(seen, state, plan, np.minimum(target, SLOWLY), (line, most))
    _go_on(seen, state, home, line)
    around = state[:, PHASE] == AROUND
    creeps = around & (state[:, CLOSE] > 0.0)
    steering, slow = creeping_out(seen, 2.0)
    left = np.abs(seen.road_offset - state[:, TARGET])
    state[left < NEARLY * np.abs(state[:, TARGET] - state[:, LINE]), CLOSE] = 0.0
    most = np.where(creeps, np.minimum(most, slow), most)
    side = np.sign(state[:, TARGET] - state[:, LINE])
    line = np.where(around, state[:, TARGET] + np.where(creeps, side * BEYOND, 0.0), line)
    time = np.where(creeps, 0.0, MOVING)
    passing = state[:, PHASE] != HOME
    stop, speed = np.full(len(now), np.inf), np.full(len(now), np.inf)
    if passing.any():
        stop, touch = _stops(seen, state, passing, creeps)
        most = np.minimum(most, touch)
        speed = np.where(state[:, NARROW] > 0.0, NARROWLY, SLOWLY)
        speed = np.where(passing, np.minimum(speed, _bend_speed(seen, state)), np.inf)
    return GoingAround(passing, line, time, most, speed, stop, creeps, steering)


def _stops(
    seen: ObservationBatch, state: Any, passing: Booleans, creeps: Booleans
) -> tuple[Floats, Floats]:
    """(N,) meters to where those that pass stop before what else stands in the way of the line that
    they are on their way to, and the acceleration with which they do so before what they would
    touch on their way there."""
    import numpy as np

    to = np.where(state[:, PHASE] == AROUND, state[:, TARGET], state[:, LINE])
    now = seen.road_offset - seen.cross_track_error
    gap = seen.obstacle_ahead(np.where(passing, to, now))
    beyond = seen.traveled + gap + seen.length > state[:, END] - PASSED
    stop = np.where(beyond | (state[:, PHASE] == RETURNING), gap - CLOSEST, np.inf)
    away = np.maximum(seen.touches_ahead(passing, creeps) - TOUCHING, 0.0)
    # Who is slower than it could still stop from may gain speed, but no more than that. Who pulls
    # out from close behind has less room than that, and turns away as it goes on.
    turns = (state[:, CLOSE] > 0.0) | (np.abs(seen.heading_error) > TURNED)
    least = np.where(turns, SLOWEST, 0.0)
    slower = SPEED_GAIN * (np.maximum(np.sqrt(2.0 * EARLY * away), least) - seen.speed)
    needed = -0.5 * seen.speed * seen.speed / np.maximum(away, 0.05)
    touch = np.where(needed < -EARLY, np.minimum(needed, slower), slower)
    return np.where(passing, stop, np.inf), touch


def _bend_speed(seen: ObservationBatch, state: Any) -> Floats:
    """(N,) speeds at which those that go around can drive the bends ahead, beside their lines."""
    import numpy as np

    reach = np.maximum(2.0 * seen.speed, seen.length)
    square = np.full(len(reach), np.inf)
    found = bends(seen, reach)
    for place, curvature in enumerate(found):
        across = np.maximum(1.0 - curvature * state[:, TARGET], 0.1)
        radius = across / np.maximum(np.abs(curvature), 1e-4)
        away = reach * (place / (len(found) - 1))
        square = np.minimum(square, LATERAL * radius + 2.0 * EASILY * away)
    return np.asarray(np.sqrt(square))


def _begin(
    seen: ObservationBatch, state: Any, plan: WayAround, speed: Floats, out: tuple[Floats, Floats]
) -> None:
    """Those that are near enough pull out where all is free, and else stop where they can still
    pull out."""
    import numpy as np

    line, most = out
    waits = np.isfinite(plan.target)
    if not waits.any():
        return
    aside = CLEARED * MOVING
    takes = aside * (seen.speed + 0.5 * GAINING * aside) + CLOSEST
    has_way = plan.gap > takes
    ready = waits & (has_way | can_creep_out(seen, plan.gap))
    free = ready & ~(seen.moving_ahead()[0] < plan.gap)
    if free.any():
        asking = replace(plan, target=np.where(free, plan.target, np.nan))
        free &= is_free(seen, asking, np.where(plan.is_narrow, NARROWLY, speed))
    goes = free & (plan.gap < takes + np.maximum(LATER * seen.speed, SPARE))
    held = held_back(seen, plan.gap, np.zeros(len(line)), waits & ~free)
    most[:] = np.where(np.isfinite(held), held, most)
    now = seen.road_offset - seen.cross_track_error
    end = seen.traveled + plan.end + seen.length
    for column, value in (
        (PHASE, AROUND), (LINE, now), (TARGET, plan.target), (END, end), (CLOSE, ~has_way),
        (NARROW, plan.is_narrow),
    ):  # fmt: skip
        state[:, column] = np.where(goes, value, state[:, column])
    line[goes] = plan.target[goes]


def _go_on(seen: ObservationBatch, state: Any, home: Floats, line: Floats) -> None:
    """Those that have passed come back to the lines `home`, unless more stands there that they can
    pass on the same line."""
    import numpy as np

    around = state[:, PHASE] == AROUND
    if around.any():
        ahead = seen.row_ahead(home, NEXT)[0]
        more = around & (ahead < NEXT + seen.length)
        if more.any():
            more &= leads_past(seen, np.where(more, state[:, TARGET], home), ahead)
        state[more, END] = np.maximum(state[:, END], seen.traveled + ahead + seen.length)[more]
        meets = seen.moving_ahead()[1] < -COMING
        spare = np.where(meets, LEAST_AHEAD, AHEAD)
        past = around & (seen.traveled > state[:, END] + spare - 0.5 * seen.length)
        if past.any():
            lane = lane_traffic(seen, home, seen.nearby(SIGHT))
            past &= ~(lane.there & (lane.gap < 1.0)).any(axis=1)
        state[past, PHASE] = RETURNING
        line[past] = home[past]
    returning = state[:, PHASE] == RETURNING
    there = returning & (np.abs(seen.road_offset - home) < BACK)
    state[there, PHASE] = HOME
