"""`drive with overtake`: pass an agent or object, where oncoming traffic leaves the time for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from roadlang.api import (
    Acceleration,
    AgentOrObject,
    Controller,
    Duration,
    InitialSpeed,
    Length,
    Speed,
    option,
)

from .lane_traffic import (
    BRAKING,
    SETTLING_TIME,
    SIDE,
    STANDSTILL_GAP,
    LaneTraffic,
    has_room,
    lane_traffic,
    members,
    target_among,
)
from .passing import STANDSTILL, PassingView, passing_distance, passing_time, standing_row
from .pulling_out import BACK_OFF, CLEARED, can_creep_out, creeping_out, held_back
from .steering import along_line

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Booleans, Floats

SIGHT = 600.0
"""Meters in which others are looked for."""
FASTER = 10.0
"""m/s: how much faster than the target it passes, where no speed limit says otherwise."""
LEAST_FASTER = 2.0
"""m/s: passing more slowly takes too long."""
FREE_SHARE = 0.9
"""Share of the free distance to begin a pass that must remain for what is left of it."""
MARGIN = 2.0
"""Seconds between the end of the pass and meeting oncoming traffic, at least."""
SPEED_GAIN = 2.0
"""1/s: acceleration for each m/s that the speed is off."""
WAITING, PASSING, RETURNING, GIVING_UP, DONE = 0.0, 1.0, 2.0, 3.0, 4.0
CLEAR = 1.0
"""Meters from the middle of the other lane from which on it drives on as always."""
_PHASE, _ORIGIN, _LANE, _CLOCK, _CLOSE = range(5)


@dataclass(frozen=True)
class Overtake(Controller):
    """Overtake an agent or an object: pull out, pass, and pull in ahead of it. It waits behind
    until the other lane is free for long enough, keeps checking while it is alongside, and
    drops back if the lane is no longer free. Otherwise the controller before it drives."""

    name: ClassVar[str] = "overtake"
    also_called: ClassVar[tuple[str, ...]] = ("pass",)
    leaves_open: ClassVar[str] = "the rest of the drive"
    target: Annotated[str, AgentOrObject] = option(
        help="the agent, object or group to overtake; members of a group are overtaken one by one"
    )
    gap: Length = option(
        8.0, minimum=1, maximum=200, help="gap to the target when it pulls in, bumper to bumper"
    )
    speed: Speed = option(
        None,
        above=0,
        maximum=120,
        help="speed while passing; by default 10 m/s more than the target, within the speed limit",
        example="100km/h",
    )
    duration: Duration = option(
        3.0, above=0, maximum=60, help="time of each of the two lane changes"
    )
    within: Length = option(
        60.0, above=0, maximum=1000, help="gap to the target at which it pulls out"
    )
    acceleration: Acceleration = option(2.5, above=0, maximum=20, help="maximum acceleration")

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.speed)

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: phase, offsets of its lane and of that in which it passes, time since it
        began to pull in, whether it pulls out from close behind."""
        import numpy as np

        return np.zeros((count, 5))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        open_ = np.full(len(seen.x), np.nan)
        time = np.zeros(len(open_)) + self.duration
        if (state[:, _PHASE] == DONE).all():
            return ControlBatch(open_, open_)
        plan = self._plan(seen, state)
        self._wait(seen, plan, state)
        self._give_up(seen, plan, state)
        self._pull_in(seen, plan, state)
        phase = state[:, _PHASE]
        line = np.where(phase == PASSING, state[:, _LANE], np.nan)
        line = np.where(phase == RETURNING, state[:, _ORIGIN], line)
        behind = plan.gap(seen.length) > STANDSTILL_GAP
        line = np.where((phase == GIVING_UP) & behind, state[:, _ORIGIN], line)
        acceleration = self._acceleration(seen, plan, state)
        steers = (phase != WAITING) & (phase != DONE)
        steering = np.where(steers, along_line(seen), np.nan)
        close = (phase == PASSING) & (state[:, _CLOSE] > 0.0)
        if close.any():
            time = np.where(close, 0.0, time)
            sharply, slow = creeping_out(seen, self.acceleration)
            steering = np.where(close, sharply, steering)
            acceleration = np.where(close, np.minimum(slow, acceleration), acceleration)
            state[close & (np.abs(seen.road_offset - state[:, _LANE]) < CLEAR), _CLOSE] = 0.0
        state[phase == RETURNING, _CLOCK] += seen.step
        settled = state[:, _CLOCK] >= self.duration + SETTLING_TIME
        returned = (phase == RETURNING) & settled
        state[returned, _PHASE] = np.where(plan.has_another, WAITING, DONE)[returned]
        home = np.abs(seen.road_offset - state[:, _ORIGIN]) < SIDE
        state[(phase == GIVING_UP) & behind & home, _PHASE] = WAITING
        return ControlBatch(steering, acceleration, line_offset=line, line_time=time)

    def _plan(self, seen: ObservationBatch, state: Any) -> PassingView:
        """What a pass from here on takes."""
        import numpy as np

        near = seen.nearby(SIGHT)
        found, ahead, left, pace, length = target_among(near, self.target)
        offset = seen.road_offset - seen.cross_track_error
        waiting = state[:, _PHASE] == WAITING
        origin = np.where(waiting, offset, state[:, _ORIGIN])
        middle = np.where(waiting, self._other_lane(seen), state[:, _LANE])
        lane = lane_traffic(seen, np.where(np.isfinite(middle), middle, offset), near)
        home = lane_traffic(seen, origin, near)
        least = self.gap + seen.length + STANDSTILL_GAP
        row = standing_row(near, members(near, self.target), home, least)
        has_another = np.asarray((members(near, self.target) & (near.ahead > 0.0)).any(axis=1))
        farthest = np.where(row, near.ahead, -np.inf).max(axis=1, initial=-np.inf)
        row_length = np.maximum(farthest - ahead, 0.0)
        return PassingView(
            found, ahead, left, pace, length, origin, middle, self._fast(seen, pace), lane,
            home, row, row_length, has_another,
        )  # fmt: skip

    def _other_lane(self, seen: ObservationBatch) -> Floats:
        """(N,) the lane in which it passes: the next one inward, and where there is none, the next
        one outward whose traffic goes the same way. NaN for none."""
        import numpy as np

        inner, outer = seen.offset_of_lane("inner"), seen.offset_of_lane("outer")
        outer = np.where(seen.direction_of_lane("outer") > 0.0, outer, np.nan)
        return np.where(np.isfinite(inner), inner, outer)

    def _fast(self, seen: ObservationBatch, pace: Floats) -> Floats:
        """(N,) speed while passing."""
        import numpy as np

        if self.speed is not None:
            return np.zeros(len(pace)) + self.speed
        return np.minimum(seen.speed_limit, pace + FASTER)

    def _free(self, seen: ObservationBatch, plan: PassingView, share: float) -> Booleans:
        """(N,) whether oncoming traffic, and who else is in the lane, leave room for the pass."""
        import numpy as np

        to_gain = np.maximum(plan.ahead, 0.0) + plan.row_length + self.gap
        to_gain = to_gain + 0.5 * (seen.length + plan.length)
        time = passing_time(seen.speed, plan.pace, plan.fast, self.acceleration, to_gain)
        time = time + self.duration
        own_distance = passing_distance(seen.speed, plan.fast, self.acceleration, time)
        lane = plan.lane
        theirs = np.maximum(-lane.pace, 0.0) * (time + MARGIN)[:, None]
        oncoming = lane.there & lane.ahead & (lane.pace < 0.5 * seen.speed[:, None])
        blocked = oncoming & (lane.gap < share * (own_distance[:, None] + theirs + STANDSTILL_GAP))
        return np.asarray(~blocked.any(axis=1))

    def _wait(self, seen: ObservationBatch, plan: PassingView, state: Any) -> None:
        """Who waits pulls out when all is free: its lane, and the place before the target."""
        import numpy as np

        state[:, _ORIGIN], state[:, _LANE] = plan.origin, plan.middle
        gap = plan.gap(seen.length)
        fits = (state[:, _PHASE] == WAITING) & plan.found & np.isfinite(plan.middle)
        fits &= (
            (gap > 0.0)
            & (gap < self.within)
            & (np.abs(plan.left) < np.maximum(plan.length, seen.width))
        )
        fits &= plan.fast - plan.pace >= LEAST_FASTER
        still = np.abs(plan.pace) < STANDSTILL
        aside = CLEARED * self.duration
        has_way = gap > aside * (seen.speed + 0.5 * self.acceleration * aside)
        fits &= ~still | has_way | can_creep_out(seen, gap)
        if not fits.any():
            return
        time = np.zeros(len(gap)) + self.duration
        same_direction = LaneTraffic(
            plan.lane.there & (plan.lane.pace >= 0.5 * seen.speed[:, None]),
            plan.lane.ahead, plan.lane.gap, plan.lane.pace, plan.lane.length,
        )  # fmt: skip
        fits &= self._free(seen, plan, 1.0) & has_room(seen, same_direction, time)
        fits &= self._place_before(seen, plan)
        state[fits, _PHASE] = PASSING
        state[fits, _CLOSE] = (still & ~has_way)[fits]

    def _place_before(self, seen: ObservationBatch, plan: PassingView) -> Booleans:
        """(N,) whether there is a place for the agent between the target and who drives before
        it."""
        import numpy as np

        home = plan.home
        gap = plan.gap(seen.length) + plan.row_length
        further = home.there & home.ahead & (home.gap > gap[:, None] + 1.0) & ~plan.row
        free = home.gap - (gap + plan.length)[:, None]
        closing = np.maximum(plan.fast[:, None] - home.pace, 0.0)
        least = (self.gap + seen.length)[:, None] + STANDSTILL_GAP
        needed = least + closing * closing / (2.0 * BRAKING)
        return np.asarray((~further | (free > needed)).all(axis=1))

    def _give_up(self, seen: ObservationBatch, plan: PassingView, state: Any) -> None:
        """Until they are beside the target, those who pass look again."""
        early = (state[:, _PHASE] == PASSING) & (plan.ahead > 0.0) & plan.found
        if early.any():
            state[early & ~self._free(seen, plan, FREE_SHARE), _PHASE] = GIVING_UP

    def _pull_in(self, seen: ObservationBatch, plan: PassingView, state: Any) -> None:
        """Those who are far enough before the target, or have lost it from sight."""
        gap = -plan.ahead - 0.5 * (seen.length + plan.length)
        past = (gap >= self.gap) & ~(plan.row & plan.home.ahead).any(axis=1)
        past = (state[:, _PHASE] == PASSING) & (~plan.found | past)
        state[past, _PHASE], state[past, _CLOCK] = RETURNING, 0.0

    def _acceleration(self, seen: ObservationBatch, plan: PassingView, state: Any) -> Floats:
        """(N,) of who passes, to its speed; of who gives up, until it is behind the target."""
        import numpy as np

        phase, fast = state[:, _PHASE], plan.fast
        for which, lane in ((PASSING, plan.lane), (RETURNING, plan.home)):
            room, pace = lane.nearest_ahead()
            pace = np.maximum(pace, 0.0)
            square = pace * pace + 2.0 * BRAKING * np.maximum(room - self.gap, 0.0)
            behind = np.sqrt(np.where(np.isfinite(room), square, np.inf))
            fast = np.where(phase == which, np.minimum(fast, behind), fast)
        passing = SPEED_GAIN * (fast - seen.speed)
        passing = np.minimum(np.maximum(passing, -BACK_OFF), self.acceleration)
        slower = SPEED_GAIN * (np.maximum(plan.pace - 4.0, 0.0) - seen.speed)
        slower = np.minimum(np.maximum(slower, -BACK_OFF), 0.0)
        back = (phase == RETURNING) & (state[:, _CLOCK] < self.duration)
        out = np.where((phase == PASSING) | back, passing, np.nan)
        out = np.where(phase == GIVING_UP, slower, out)
        return np.where(phase == WAITING, self._hold_back(seen, plan), out)

    def _hold_back(self, seen: ObservationBatch, plan: PassingView) -> Floats:
        """(N,) of who has to wait behind something that stands still, or soon may, where it can
        still pull out. NaN for who need not brake for that, or has another before it."""
        import numpy as np

        gap = plan.gap(seen.length)
        nearest, _ = plan.home.nearest_ahead()
        waits = plan.found & (np.abs(gap - nearest) < 1.0)
        return held_back(seen, gap, plan.pace, waits)
