"""`drive with cut_in`: change closely in front of another agent."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from roadlang.api import Acceleration, AgentName, Controller, Duration, Length, Speed, option

from .lane_traffic import (
    BRAKING,
    SETTLING_TIME,
    STANDSTILL_GAP,
    lane_traffic,
    target_among,
)
from .steering import along_line

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Floats

SIGHT = 300.0
"""Meters in which the target and others are looked for."""
GAIN = 1.0
"""1/s: speed for each meter that the gap is off."""
SPEED_GAIN = 2.5
"""1/s: acceleration for each m/s that the speed is off."""
SAME_LANE = 1.5
"""Meters: less to the side is in the same lane."""
LEAST, MOST = 0.75, 1.25
"""Shares of the gap that are there when the change begins; and `SLACK` meters more."""
SLACK = 1.0
APPROACHING, CHANGING, DONE = 0.0, 1.0, 2.0
_PHASE, _TARGET, _CLOCK, _PACE = range(4)


@dataclass(frozen=True)
class CutIn(Controller):
    """Pass an agent in an adjacent lane, change lanes in front of it, and end with a gap to it;
    it waits for other vehicles in the way. Afterwards the controller before it drives on."""

    name: ClassVar[str] = "cut_in"
    leaves_open: ClassVar[str] = "the rest of the drive"
    target: Annotated[str, AgentName] = option(help="the agent to cut in front of")
    gap: Length = option(
        8.0, minimum=0, maximum=200, help="gap to the target at the end, from bumper to bumper"
    )
    duration: Duration = option(3.0, above=0, maximum=60, help="duration of the lane change")
    closing: Speed = option(
        5.0, above=0, maximum=40, help="maximum speed relative to the target while passing"
    )
    acceleration: Acceleration = option(3.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(4.0, above=0, maximum=20, help="maximum deceleration")

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: phase, offset of the lane of the target, time since the change began, and
        the pace of the target then."""
        import numpy as np

        return np.zeros((count, 4))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        open_ = np.full(len(seen.x), np.nan)
        line, steering, acceleration = open_.copy(), open_, open_
        if (state[:, _PHASE] != DONE).any():
            near = seen.nearby(SIGHT)
            found, ahead, left, pace, length = target_among(near, self.target)
            gap = -ahead - 0.5 * (seen.length + length)
            beside = found & (np.abs(left) >= SAME_LANE)
            self._begin(seen, near, state, (beside, left, gap, pace))
            steers = state[:, _PHASE] == CHANGING
            changing = steers & (state[:, _CLOCK] < self.duration)
            line[changing] = state[changing, _TARGET]
            steering = np.where(steers, along_line(seen), np.nan)
            acceleration = np.where(
                found & (changing | ((state[:, _PHASE] == APPROACHING) & beside)),
                self._toward(seen, gap, pace, state), np.nan,
            )  # fmt: skip
            state[steers, _CLOCK] += seen.step
            settled = state[:, _CLOCK] >= self.duration + SETTLING_TIME
            state[steers & settled, _PHASE] = DONE
        time = np.zeros(len(open_)) + self.duration
        return ControlBatch(steering, acceleration, line_offset=line, line_time=time)

    def _begin(self, seen: ObservationBatch, near: Any, state: Any, target: Any) -> None:
        """Those who are far enough ahead, or will be by the end of the change."""
        import numpy as np

        beside, left, gap, pace = target
        middle = np.where(left > 0.0, seen.offset_of_lane("left"), seen.offset_of_lane("right"))
        middle = np.where(np.isfinite(middle), middle, seen.road_offset + left)
        gained = np.maximum(seen.speed - pace, 0.0) * self.duration
        fits = (state[:, _PHASE] == APPROACHING) & beside & (seen.speed > 1.0)
        fits &= (gap + gained >= self.gap) & (gap >= LEAST * self.gap)
        fits &= gap <= MOST * self.gap + SLACK
        room, other = lane_traffic(seen, middle, near).nearest_ahead()
        closing = np.maximum(seen.speed - other, 0.0)
        fits &= room > STANDSTILL_GAP + closing * closing / (2.0 * BRAKING)
        state[fits, _PHASE], state[fits, _CLOCK] = CHANGING, 0.0
        state[fits, _TARGET], state[fits, _PACE] = middle[fits], pace[fits]

    def _toward(self, seen: ObservationBatch, gap: Floats, pace: Floats, state: Any) -> Floats:
        """(N,) acceleration that brings the gap to what it should be. Who changes already does not
        brake with a target that makes room."""
        import numpy as np

        changing = state[:, _PHASE] == CHANGING
        slowest = np.where(changing, 0.0, -self.closing)
        faster = np.minimum(np.maximum(GAIN * (self.gap - gap), slowest), self.closing)
        pace = np.where(changing, state[:, _PACE], pace)
        wanted = SPEED_GAIN * (pace + faster - seen.speed)
        return np.minimum(np.maximum(wanted, -self.deceleration), self.acceleration)
