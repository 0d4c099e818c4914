"""`drive with stop_at`: stop at a place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Acceleration, Controller, Length, option

from .drive_brake import HOLDING, STANDING
from .drive_car_follow import HARDEST

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Floats

MOST_DRAG = 1.0
"""m/s^2"""
CLOSE = 0.05
"""Meters: from here on an agent is there."""


@dataclass(frozen=True)
class StopAt(Controller):
    """Stop at a place with constant deceleration, and stay there; until braking starts, the
    controller before it drives. Without a place it stops at once."""

    name: ClassVar[str] = "stop_at"
    also_called: ClassVar[tuple[str, ...]] = ("wait",)
    station: Length = option(
        None,
        minimum=0,
        help="place to stop at: arc length along the agent's road (`ego.station`)",
        example="120m",
    )
    distance: Length = option(
        None,
        minimum=0,
        help="or the distance from where it takes over; with both, the nearer one counts",
        example="40m",
    )
    deceleration: Acceleration = option(3.0, above=0, maximum=20, help="deceleration")

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: distance traveled when it took over, NaN before; whether it brakes; what
        it wanted to accelerate with in the last step, NaN for nothing."""
        import numpy as np

        return np.tile([np.nan, 0.0, np.nan], (count, 1))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen, speed = observations, observations.speed
        left = self._left(seen, state)
        room = left - speed * seen.step
        state[room * 2.0 * self.deceleration <= speed * speed, 1] = 1.0
        needed = speed * speed / (2.0 * np.maximum(left, CLOSE))
        # What drag and slopes add to it is taken off again.
        drag = np.where(np.isnan(state[:, 2]), 0.0, seen.acceleration - state[:, 2])
        drag = np.minimum(np.maximum(drag, -MOST_DRAG), MOST_DRAG)
        braking = -np.minimum(needed + drag, HARDEST)
        is_there = (left <= CLOSE) & (speed > STANDING)
        braking = np.where(is_there, -self.deceleration, braking)
        braking = np.where(speed > STANDING, braking, -HOLDING)
        acceleration = np.where(state[:, 1] > 0.0, braking, np.nan)
        state[:, 2] = acceleration
        return ControlBatch(np.full(len(speed), np.nan), acceleration)

    def _left(self, seen: ObservationBatch, state: NDArray[np.float64]) -> Floats:
        """(N,) meters to the place."""
        import numpy as np

        state[:, 0] = np.where(np.isnan(state[:, 0]), seen.traveled, state[:, 0])
        if self.station is None and self.distance is None:
            return np.zeros(len(seen.x))
        left = np.full(len(seen.x), np.inf)
        if self.distance is not None:
            left = self.distance - (seen.traveled - state[:, 0])
        if self.station is not None:
            direction = seen.lane_place().road_direction
            left = np.minimum(left, (self.station - seen.station) * direction)
        return left
