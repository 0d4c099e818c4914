"""`drive with speed_profile`: speeds by distance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar

from roadlang.api import LENGTH, SPEED, Acceleration, Controller, ListOf, option, pair_of

from .steering import SPEED_GAIN

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch


@dataclass(frozen=True)
class SpeedProfile(Controller):
    """Drive at speeds given by the distance since it took over; between two points the
    acceleration is constant. The controller before it steers."""

    name: ClassVar[str] = "speed_profile"
    also_called: ClassVar[tuple[str, ...]] = ("accelerate", "speeds")
    points: ListOf[Annotated[tuple[float, float], pair_of(LENGTH, SPEED)]] = option(
        at_least=1,
        help="distances and speeds, in any order; before the first and beyond the last the speed "
        "stays the same",
        example="[(0m, 50km/h), (80m, 20km/h)]",
    )
    acceleration: Acceleration = option(4.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(8.0, above=0, maximum=20, help="maximum deceleration")

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: distance traveled when it took over, NaN before."""
        import numpy as np

        return np.full(count, np.nan)

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        state[:] = np.where(np.isnan(state), seen.traveled, state)
        traveled = seen.traveled - state
        points = np.asarray(self.points, dtype=np.float64)
        points = np.broadcast_to(points, (len(traveled), *points.shape[-2:]))
        order = points[:, :, 0].argsort(axis=1, kind="stable")
        place = np.take_along_axis(points[:, :, 0], order, axis=1)
        speed = np.maximum(np.take_along_axis(points[:, :, 1], order, axis=1), 0.0)
        square = speed[:, 0] * speed[:, 0]
        rate = np.zeros(len(traveled))
        for left in range(points.shape[1] - 1):
            span = np.maximum(place[:, left + 1] - place[:, left], 1e-9)
            low, high = speed[:, left] * speed[:, left], speed[:, left + 1] * speed[:, left + 1]
            slope = (high - low) / span
            inside = traveled >= place[:, left]
            done = traveled >= place[:, left + 1]
            square = np.where(inside, low + slope * (traveled - place[:, left]), square)
            square = np.where(done, high, square)
            rate = np.where(inside, np.where(done, 0.0, 0.5 * slope), rate)
        wanted = np.sqrt(np.maximum(square, 0.0))
        acceleration = rate + SPEED_GAIN * (wanted - seen.speed)
        limited = np.minimum(np.maximum(acceleration, -self.deceleration), self.acceleration)
        return ControlBatch(np.full(len(traveled), np.nan), limited)
