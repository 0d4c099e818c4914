"""`drive with change_lane`: move to another lane, where it is free."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Controller, Duration, Flag, Integer, Length, option

from .lane_traffic import SETTLING_TIME, has_room, lane_traffic
from .passing import STANDSTILL
from .pulling_out import CLEARED, PULL_OUT, can_creep_out, creeping_out, held_back
from .steering import ahead_in_lane, along_line

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, LaneKind, ObservationBatch
    from roadlang.geometry import Booleans, Floats

SIGHT = 200.0
"""Meters: other vehicles farther away are ignored."""
SLOWEST = 1.0
"""m/s: at lower speeds a lane change begins only by pulling out."""
BESIDE = ("shoulder", "parking")
"""Kinds of lanes beside the driving lanes in which vehicles may stop, in order of preference."""
NEXT = 6.0
"""Meters: a lane whose middle is farther away is not the next one."""
WAITING, MOVING, DONE = 0.0, 1.0, 2.0
CLEAR = 1.0
"""Meters from the middle of the new lane at which pulling out ends."""
CLOSEST = 3.0
"""Meters: the gap that must remain to a standing vehicle when the old lane has been left."""
CREEPING_ACCELERATION = 2.0
"""m/s^2"""
_PHASE, _TARGET, _ORIGIN, _CLOCK, _TIME, _CLOSE = range(6)
ABORT_GAP_SHARE = 0.4
"""A change is aborted when less than this share of the gap needed to begin it remains, during its
first half."""
RETURNED = 0.6
"""Meters from the old line"""
BACK_TIME = 2.0
"""Seconds: the maximum duration of the return after an aborted change."""


_SIGNS = {"left": 1.0, "right": -1.0}


@dataclass(frozen=True)
class ChangeLane(Controller):
    """Change lanes as soon as there is room, and stay in the new lane; the controller before it
    steers otherwise, and controls the speed. It returns if the gap closes during the first half
    of the change. Behind a standing obstacle it waits at a distance from which it can pull out."""

    name: ClassVar[str] = "change_lane"
    also_called: ClassVar[tuple[str, ...]] = (
        "lane_change",
        "LaneChange",
        "LaneChangeBehavior",
        "lane_changing",
    )
    leaves_open: ClassVar[str] = "the rest of the drive"
    lane_options: ClassVar[tuple[str, ...]] = ("to",)
    to: Integer = option(
        words=("left", "right", *BESIDE),
        minimum=-32,
        maximum=32,
        help="the lane: `left` or `right`, the next one there whose traffic goes the same way, or "
        "where there is none the shoulder or parking lane; `shoulder` or `parking`; or the id of a "
        "lane, also of oncoming traffic",
        example="left",
    )
    duration: Duration = option(4.0, above=0, maximum=60, help="duration of the lane change")
    distance: Length = option(
        None,
        above=0,
        maximum=1000,
        help="distance over which it changes, at the speed with which it begins; it replaces "
        "`duration`",
        example="50m",
    )
    force: Flag = option(False, help="change lanes even if there is no room")

    def takes_lane(self, kind: type[LaneKind], is_oncoming: bool) -> bool:
        if self.force:
            return kind.drivable
        return kind.name in BESIDE or (kind.drivable and not is_oncoming)

    def start(self, count: int) -> NDArray[np.float64]:
        """(count, 6) of each agent: phase, offsets of the new and of the old lane, time since the
        start of the change, its duration, and whether it pulls out from close behind something."""
        import numpy as np

        return np.zeros((count, 6))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        line = np.full(len(seen.x), np.nan)
        time = np.ones(len(line))
        acceleration = line.copy()
        if (state[:, _PHASE] != DONE).any():
            near = None if self.force else seen.nearby(SIGHT)
            self._turn_back(seen, near, state, line)
            acceleration = self._begin(seen, near, state, line)
            time = np.where(state[:, _CLOSE] > 0.0, 0.0, state[:, _TIME])
            self._stopped_short(seen, state)
            state[state[:, _CLOSE] == 0.0, _CLOCK] += seen.step
            settled = state[:, _CLOCK] >= state[:, _TIME] + SETTLING_TIME
            state[(state[:, _PHASE] == MOVING) & settled, _PHASE] = DONE
        open_ = np.full(len(line), np.nan)
        steering = open_
        if (state[:, _PHASE] == MOVING).any():
            steering = np.where(state[:, _PHASE] == MOVING, along_line(seen), np.nan)
        close = (state[:, _PHASE] == MOVING) & (state[:, _CLOSE] > 0.0)
        if close.any():
            sharply, slow = creeping_out(seen, CREEPING_ACCELERATION)
            steering, acceleration = (
                np.where(close, now, before)
                for now, before in ((sharply, steering), (slow, acceleration))
            )
            state[close & (np.abs(seen.road_offset - state[:, _TARGET]) < CLEAR), _CLOSE] = 0.0
        return ControlBatch(steering, acceleration, line_offset=line, line_time=time)

    def _begin(self, seen: ObservationBatch, near: Any, state: Any, line: Floats) -> Floats:
        """Begin the change of waiting vehicles that have room. Returns (N,) accelerations of those
        that go on waiting behind a standing vehicle or object, NaN for all others."""
        import numpy as np

        has_begun = (state[:, _PHASE] == WAITING) & (state[:, _TIME] > 0.0)
        has_begun &= ~has_returned(seen, state[:, _ORIGIN])
        target = np.where(has_begun, state[:, _TARGET], self._target(seen))
        time = self._time(seen)
        waits = (state[:, _PHASE] == WAITING) & np.isfinite(target)
        gap, pace = ahead_in_lane(seen)
        least = np.where(
            seen.speed > SLOWEST, CLEARED * time * seen.speed + CLOSEST, PULL_OUT + 1.0
        )
        close = (pace < STANDSTILL) & (gap <= least)
        side = np.sign(target - (seen.road_offset - seen.cross_track_error))
        aside = np.maximum(np.where(waits, side * seen.cross_track_error, 0.0), 0.0)
        fits = waits & np.where(close, can_creep_out(seen, gap, aside), seen.speed > SLOWEST)
        if near is not None:
            fits &= self._is_free(seen, near, target, time, 1.0)
        now = seen.road_offset - seen.cross_track_error
        for column, value in (
            (_PHASE, MOVING), (_TARGET, target), (_ORIGIN, now), (_CLOCK, 0.0), (_TIME, time),
            (_CLOSE, close),
        ):  # fmt: skip
            state[:, column] = np.where(fits, value, state[:, column])
        line[fits] = target[fits]
        return held_back(seen, gap, pace, waits & ~fits)

    def _stopped_short(self, seen: ObservationBatch, state: Any) -> None:
        """Vehicles that had to stop during the change, because the one ahead did, pull out."""
        import numpy as np

        gap, pace = ahead_in_lane(seen)
        aside = np.abs(seen.road_offset - state[:, _ORIGIN])
        left = np.abs(seen.road_offset - state[:, _TARGET])
        short = (state[:, _PHASE] == MOVING) & (pace < STANDSTILL) & (gap < PULL_OUT)
        short &= (seen.speed < SLOWEST) & (left > CLEAR) & can_creep_out(seen, gap, aside)
        state[short, _CLOSE] = 1.0

    def _turn_back(self, seen: ObservationBatch, near: Any, state: Any, line: Floats) -> None:
        """Abort changes whose gap closes during the first half."""
        import numpy as np

        if near is None:
            return
        target, origin = state[:, _TARGET], state[:, _ORIGIN]
        early = np.abs(seen.road_offset - origin) < 0.5 * np.abs(target - origin)
        moving = (state[:, _PHASE] == MOVING) & early
        if moving.any():
            rest = np.maximum(state[:, _TIME] - state[:, _CLOCK], 0.0)
            back = moving & ~self._is_free(seen, near, target, rest, ABORT_GAP_SHARE)
            state[back, _PHASE] = WAITING
            line[back] = origin[back]
            state[back, _TIME] = np.minimum(state[back, _TIME], BACK_TIME)

    def _is_free(
        self, seen: ObservationBatch, near: Any, target: Floats, time: Floats, share: float
    ) -> Booleans:
        import numpy as np

        middle = np.where(np.isfinite(target), target, 0.0)
        braking = np.maximum(-seen.acceleration, 0.0)
        return has_room(seen, lane_traffic(seen, middle, near), time, share, braking)

    def _target(self, seen: ObservationBatch) -> Floats:
        """(N,) where the middle of the lane is, NaN where there is none to change to."""
        import numpy as np

        middle = seen.offset_of_lane(self.to)
        if isinstance(self.to, str) and not self.force:
            against = seen.direction_of_lane(self.to) < 0.0
            middle = np.where(against, np.nan, middle)
            if self.to in _SIGNS:
                middle = _else_beside(seen, middle, _SIGNS[self.to])
        return middle

    def _time(self, seen: ObservationBatch) -> Floats:
        """(N,) seconds."""
        import numpy as np

        if self.distance is not None:
            return np.asarray(self.distance / np.maximum(seen.speed, SLOWEST))
        return np.zeros(len(seen.x)) + self.duration


def _else_beside(seen: ObservationBatch, middle: Floats, side: float) -> Floats:
    """(N,) the offsets of lanes; where there is none, that of a shoulder or parking lane which is
    the next on that side."""
    import numpy as np

    for kind in BESIDE:
        found = seen.offset_of_lane(kind)
        away = side * (found - seen.road_offset)
        middle = np.where(np.isnan(middle) & (away > 0.0) & (away < NEXT), found, middle)
    return middle


def has_returned(seen: ObservationBatch, origin: Floats) -> NDArray[np.bool_]:
    """(N,) whether vehicles are on the lines at offsets `origin` again. One on its way back may be
    in the new lane still, whose neighbor is not the lane that it wants."""
    import numpy as np

    return np.asarray(np.abs(seen.road_offset - origin) <= RETURNED)
