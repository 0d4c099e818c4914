"""`drive with reverse`: drive backward."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Acceleration, Angle, Controller, Length, Speed, option

from .kinematic_moves import arc_move, touches

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Floats

STANDING = 0.05
"""m/s: who is faster brakes first."""
BRAKING = 4.0
"""m/s^2"""
SIGHT, BEHIND = 15.0, 0.7
"""Meters: how far it sees, and how close behind it something has to be for it to wait."""
_GONE, _PACE = range(2)


@dataclass(frozen=True)
class Reverse(Controller):
    """Drive backward, as out of a parking space: first straight, then on a circle, and stop. Its
    `speed` is negative while it backs up. Tires do not slip at such speeds: the rear axle goes
    exactly where the vehicle points. It waits while something is close behind it."""

    name: ClassVar[str] = "reverse"
    distance: Length = option(6.0, above=0, maximum=1000, help="how far it drives backward")
    speed: Speed = option(1.5, above=0, maximum=10, help="target speed")
    turn: Angle = option(
        0.0,
        minimum=-6.3,
        maximum=6.3,
        help="how far it has turned at the end, counter-clockwise as seen from above",
        example="90deg",
    )
    straight: Length = option(0.0, minimum=0, help="distance before it begins to turn")
    acceleration: Acceleration = option(
        1.0, above=0, maximum=10, help="acceleration and deceleration"
    )

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: distance driven backward, and its speed."""
        import numpy as np

        return np.zeros((count, 2))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        open_ = np.full(len(seen.x), np.nan)
        still_ahead = (seen.speed > STANDING) & (state[:, _GONE] == 0.0)
        pose = self._backed(seen, state, still_ahead)
        pose[still_ahead] = np.nan
        return ControlBatch(open_, np.where(still_ahead, -BRAKING, 0.0), pose=pose)

    def _backed(
        self, seen: ObservationBatch, state: NDArray[np.float64], waits: NDArray[np.bool_]
    ) -> Floats:
        """(N, 4) x, y, heading and speed at the end of the step."""
        import numpy as np

        left = np.maximum(self.distance - state[:, _GONE], 0.0)
        faster = np.minimum(state[:, _PACE] + self.acceleration * seen.step, self.speed)
        pace = np.minimum(faster, np.sqrt(2.0 * self.acceleration * left))
        ahead = np.minimum(BEHIND, left)
        behind = arc_move(seen, -ahead, np.zeros(len(left)))
        waits = waits | (touches(seen, seen.nearby(SIGHT), behind) & (left > 0.0))
        pace = np.where(waits, 0.0, pace)
        step = np.minimum(pace * seen.step, left)
        turning = np.maximum(self.distance - self.straight, 1e-6)
        before = np.maximum(state[:, _GONE] - self.straight, 0.0)
        after = np.maximum(state[:, _GONE] + step - self.straight, 0.0)
        turn = self.turn * (after - before) / turning
        half = 0.5 * seen.wheelbase
        rear_x = seen.x - half * np.cos(seen.heading)
        rear_y = seen.y - half * np.sin(seen.heading)
        middle, heading = seen.heading + 0.5 * turn, seen.heading + turn
        rear_x, rear_y = rear_x - step * np.cos(middle), rear_y - step * np.sin(middle)
        state[:, _GONE] += step
        state[:, _PACE] = pace
        moving = np.where(left - step > 1e-6, -pace, 0.0)
        x, y = rear_x + half * np.cos(heading), rear_y + half * np.sin(heading)
        return np.stack((x, y, heading, moving), axis=1)
