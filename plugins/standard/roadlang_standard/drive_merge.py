"""`drive with merge`: into a gap of the neighboring lane, before the own lane ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import (
    LANE_END_GAP,
    Acceleration,
    Controller,
    Duration,
    InitialSpeed,
    Integer,
    Length,
    Speed,
    option,
)

from .drive_brake import HOLDING, STANDING
from .drive_change_lane import ABORT_GAP_SHARE, SIGHT, has_returned
from .drive_traffic import HARDEST
from .lane_traffic import (
    REACTION,
    SETTLING_TIME,
    STANDSTILL_GAP,
    LaneTraffic,
    has_room,
    lane_traffic,
)
from .steering import SPEED_GAIN, ahead_in_lane, along_line, target_speed, toward

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, LaneKind, ObservationBatch
    from roadlang.geometry import Booleans, Floats

HEADWAY, GAP = 0.8, 2.0
"""Seconds and meters that it keeps to who it merges behind."""
GENTLE = 0.5
"""Share of its deceleration with which it lets a gap grow that it has merged into."""
WITHIN = 150.0
"""Meters in which it changes out of a lane that does not end."""
SLOWEST = 1.0
"""m/s: who is slower pulls out only where there is room ahead to do so."""
SLOWER = 3.0
"""m/s: it falls back, or moves up, at most so fast beside the other lane. Who falls back faster is
too slow for the gap when it comes."""
TIGHT = 0.6
"""Share of the usual reaction distance: it stays beside a gap with this much room, until the
vehicle behind the gap lets it in."""
CRAWLING = 5.0
"""m/s: it does not fall back behind slower vehicles, but takes its turn, as in a zipper merge."""
STOPS = 0.9
"""Share of its deceleration with which it begins to brake for the end of its lane."""
ALIGNING_TIME = 1.5
"""Seconds in which it moves up to the middle of a gap."""
FARTHEST = 1e6
"""Meters: upper limit of the room behind, which is infinite where nobody follows."""
MOVING_TIME = 3.0
"""Seconds within which moving up has to make enough room for the vehicle behind."""
WAITING, MOVING, DONE = 0.0, 1.0, 2.0
_PHASE, _BEGAN, _TARGET, _CLOCK, _ORIGIN = range(5)


@dataclass(frozen=True)
class Merge(Controller):
    """Merge into the adjacent lane: adapt the speed to a gap, change lanes where there is room,
    and stop before the end of its own lane if there is none. It returns if the gap closes during
    the first half of the change. Afterwards the controller before it drives on, but keeps its
    distance to the vehicle ahead. While there is no such lane it drives on in its own."""

    name: ClassVar[str] = "merge"
    leaves_open: ClassVar[str] = "the rest of the drive"
    lane_options: ClassVar[tuple[str, ...]] = ("to",)
    to: Integer = option(
        "left",
        words=("left", "right"),
        minimum=-32,
        maximum=32,
        help="the lane: `left` or `right`, the next one there unless its traffic comes toward the "
        "agent, or the id of a lane",
        example="left",
    )
    within: Length = option(
        None,
        above=0,
        maximum=10_000,
        help="distance from where it takes over at which it stops and waits if there was no room; "
        "by default the end of its lane, or 150m if that goes on",
        example="150m",
    )
    speed: Speed = option(
        None,
        minimum=0,
        maximum=120,
        help="target speed; by default the speed limit, or 50 km/h without one",
        example="80km/h",
    )
    duration: Duration = option(4.0, above=0, maximum=60, help="duration of the lane change")
    acceleration: Acceleration = option(2.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(3.0, above=0, maximum=20, help="comfortable deceleration")

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.speed)

    def takes_lane(self, kind: type[LaneKind], is_oncoming: bool) -> bool:
        return kind.drivable and not is_oncoming

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: phase, distance traveled when it took over (NaN before), offset of the new
        lane, time since the change began, offset of the old lane."""
        import numpy as np

        return np.tile([WAITING, np.nan, 0.0, 0.0, 0.0], (count, 1))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        open_ = np.full(len(seen.x), np.nan)
        line, steering, acceleration = open_.copy(), open_, open_
        limit = self._following(seen, *ahead_in_lane(seen))
        state[:, _BEGAN] = np.where(np.isnan(state[:, _BEGAN]), seen.traveled, state[:, _BEGAN])
        if (state[:, _PHASE] != DONE).any():
            waiting = state[:, _PHASE] == WAITING
            state[waiting & has_returned(seen, state[:, _ORIGIN]), _CLOCK] = 0.0
            middle = np.where(state[:, _CLOCK] > 0.0, state[:, _TARGET], self._target(seen))
            exists = np.isfinite(middle)
            near = seen.nearby(SIGHT)
            lane = lane_traffic(seen, np.where(exists, middle, 0.0), near)
            self._turn_back(seen, lane, state, line)
            waiting = state[:, _PHASE] == WAITING
            time = np.zeros(len(open_)) + self.duration
            slows = np.maximum(-self._following(seen, *lane.nearest_ahead()), 0.0)
            begins = waiting & exists & has_room(seen, lane, time, braking=slows)
            begins &= (seen.speed > SLOWEST) | (ahead_in_lane(seen)[0] > 0.5 * LANE_END_GAP)
            state[begins, _PHASE], state[begins, _TARGET] = MOVING, middle[begins]
            state[begins, _ORIGIN] = (seen.road_offset - seen.cross_track_error)[begins]
            state[begins, _CLOCK] = 0.0
            line[begins] = middle[begins]
            waiting = state[:, _PHASE] == WAITING
            acceleration = np.where(waiting, self._waiting(seen, lane, state, exists), np.nan)
            moving = state[:, _PHASE] == MOVING
            limit = np.where(moving, self._following(seen, *lane.nearest_ahead()), limit)
            steering = np.where(moving, along_line(seen), np.nan)
            state[moving, _CLOCK] += seen.step
            settled = state[:, _CLOCK] >= self.duration + SETTLING_TIME
            state[moving & settled, _PHASE] = DONE
        time = np.zeros(len(open_)) + self.duration
        return ControlBatch(
            steering, acceleration, line_offset=line, line_time=time, acceleration_limit=limit
        )

    def _turn_back(
        self, seen: ObservationBatch, lane: LaneTraffic, state: Floats, line: Floats
    ) -> None:
        """Those on the first half of the change whose room is taken."""
        import numpy as np

        origin, target = state[:, _ORIGIN], state[:, _TARGET]
        early = np.abs(seen.road_offset - origin) < 0.5 * np.abs(target - origin)
        moving = (state[:, _PHASE] == MOVING) & early
        if moving.any():
            rest = np.maximum(self.duration - state[:, _CLOCK], 0.0)
            back = moving & ~has_room(seen, lane, rest, ABORT_GAP_SHARE)
            state[back, _PHASE] = WAITING
            line[back] = origin[back]

    def _target(self, seen: ObservationBatch) -> Floats:
        """(N,) where the middle of the lane is, NaN where there is none to merge into."""
        import numpy as np

        middle = seen.offset_of_lane(self.to)
        if not isinstance(self.to, str):
            return middle
        return np.where(seen.direction_of_lane(self.to) < 0.0, np.nan, middle)

    def _waiting(
        self, seen: ObservationBatch, lane: LaneTraffic, state: Floats, exists: Booleans
    ) -> Floats:
        """(N,) acceleration: to the target speed, behind who is ahead in either lane, and to a stop
        before the end. `exists` (N,): whether there is a lane to merge into."""
        import numpy as np

        speed = seen.speed
        wanted = target_speed(seen, self.speed, self.deceleration)
        free = toward(speed, wanted, self.acceleration, self.deceleration)
        in_lane = self._behind(seen, *ahead_in_lane(seen))
        aligned = self._aligned(seen, lane, np.broadcast_to(wanted, speed.shape))
        gentle = np.where(exists, aligned, np.inf)
        left, needed = self._stop(seen, state, exists)
        late = (needed >= STOPS * self.deceleration) | (left < 0.1)
        stopping = np.where(late, -np.maximum(needed, GENTLE * self.deceleration), np.inf)
        stopping = np.where((left < 0.5) & (speed <= STANDING), -HOLDING, stopping)
        least = np.minimum(np.minimum(free, in_lane), np.minimum(gentle, stopping))
        return np.maximum(least, -HARDEST)

    def _stop(
        self, seen: ObservationBatch, state: Floats, exists: Booleans
    ) -> tuple[Floats, Floats]:
        """(N,) meters to where it waits if there is no room, and the braking to stop there."""
        import numpy as np

        end = np.where(exists, self._left(seen, state), seen.lane_end())
        left = end - 0.5 * seen.length - LANE_END_GAP
        return left, seen.speed * seen.speed / (2.0 * np.maximum(left, 0.05))

    def _aligned(self, seen: ObservationBatch, lane: LaneTraffic, wanted: Floats) -> Floats:
        """(N,) acceleration beside the gap into which it merges: to the middle between who is ahead
        in the other lane and who is behind there, or behind both where the gap between them is too
        small, or it cannot move up."""
        import numpy as np

        speed = seen.speed
        gap, pace = lane.nearest_ahead()
        behind, pace_behind = lane.nearest_behind()
        reaction = TIGHT * REACTION
        spare = gap - STANDSTILL_GAP - reaction * np.maximum(pace, 0.0)
        spare_behind = behind - STANDSTILL_GAP - reaction * np.maximum(pace_behind, 0.0)
        blocked = spare_behind < 0.0
        moves_up = spare_behind + MOVING_TIME * (wanted - pace_behind) >= 0.0
        fits = (spare + spare_behind >= 0.0) & (~blocked | moves_up)
        falls_back = blocked & ~fits & (pace_behind > CRAWLING)
        off = 0.5 * (spare - np.minimum(spare_behind, FARTHEST))
        to_middle = np.minimum(np.maximum(off / ALIGNING_TIME, -SLOWER), SLOWER)
        beside = np.where(np.isfinite(gap), pace, pace_behind) + to_middle
        aligns = np.maximum(SPEED_GAIN * (beside - speed), -self.deceleration)
        follows = np.maximum(self._behind(seen, gap, pace), -self.deceleration)
        pace = np.where(falls_back, pace_behind, pace)
        slowest = SPEED_GAIN * (np.maximum(pace - SLOWER, 0.5 * pace) - speed)
        back = np.where(falls_back, -self.deceleration, follows)
        return np.where(fits, np.maximum(follows, aligns), np.maximum(back, slowest))

    def _following(self, seen: ObservationBatch, gap: Floats, pace: Floats) -> Floats:
        """(N,) the greatest acceleration behind somebody: it brakes gently where it has merged
        into a gap that is small for its speed, and as hard as it has to where it would touch."""
        import numpy as np

        closing = np.maximum(seen.speed - pace, 0.0)
        needed = -closing * closing / (2.0 * np.maximum(gap - 0.5 * GAP, 0.1))
        least = -GENTLE * self.deceleration
        gentle = np.maximum(self._behind(seen, gap, pace), least)
        return np.asarray(np.where(needed < least, np.maximum(needed, -HARDEST), gentle))

    def _left(self, seen: ObservationBatch, state: Floats) -> Floats:
        """(N,) meters in which the center has to be in the other lane."""
        import numpy as np

        traveled = seen.traveled - state[:, _BEGAN]
        if self.within is not None:
            return np.asarray(self.within - traveled)
        end = seen.lane_end()
        return np.where(np.isfinite(end), end, WITHIN - traveled)

    def _behind(self, seen: ObservationBatch, gap: Floats, pace: Floats) -> Floats:
        """(N,) acceleration behind somebody (intelligent driver model, Treiber et al. 2000)."""
        import numpy as np

        speed = seen.speed
        approach = speed * (speed - pace) / (2.0 * np.sqrt(self.acceleration * self.deceleration))
        wanted = GAP + np.maximum(0.0, speed * HEADWAY + approach)
        pull = np.where(np.isfinite(gap), wanted / np.maximum(gap, 0.5), 0.0)
        return np.asarray(self.acceleration * (1.0 - pull * pull))
