"""`sense with imu`: acceleration and yaw rate, with errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import ANGLE, TIME, Acceleration, ReadingArray, Sensor, option, quantity

from .error_walks import walked

if TYPE_CHECKING:
    from typing import Annotated

    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import SensedBatch

    AngularVelocity = Annotated[float, quantity(ANGLE / TIME)]
else:
    AngularVelocity = quantity(ANGLE / TIME)


@dataclass(frozen=True)
class Imu(Sensor):
    """An inertial unit: acceleration along and across the body, and yaw rate."""

    name: ClassVar[str] = "imu"

    noise: Acceleration = option(
        0.05,
        minimum=0,
        maximum=1000,
        help="standard deviation of the accelerations, independent for each reading",
    )
    bias: Acceleration = option(
        0.0,
        minimum=-1000,
        maximum=1000,
        help="constant error of the accelerations; `..` draws one for each scene",
        example="-0.1m/s^2..0.1m/s^2",
    )
    walk: Acceleration = option(
        0.0,
        minimum=0,
        maximum=1000,
        help="drift of the errors of the accelerations in a second: standard deviation of a "
        "random walk",
    )
    yaw_noise: AngularVelocity = option(
        0.002,
        minimum=0,
        maximum=1000,
        help="standard deviation of the yaw rate, independent for each reading",
        example="0.1deg/s",
    )
    yaw_bias: AngularVelocity = option(
        0.0,
        minimum=-1000,
        maximum=1000,
        help="constant error of the yaw rate",
        example="-0.2deg/s..0.2deg/s",
    )
    yaw_walk: AngularVelocity = option(
        0.0,
        minimum=0,
        maximum=1000,
        help="drift of the error of the yaw rate in a second",
    )

    def arrays(self) -> dict[str, ReadingArray]:
        """`acceleration` is along the body, `lateral_acceleration` to the left."""
        return {
            "acceleration": ReadingArray(unit="m/s^2"),
            "lateral_acceleration": ReadingArray(unit="m/s^2"),
            "yaw_rate": ReadingArray(unit="rad/s"),
        }

    def start(self, count: int) -> NDArray[np.float64]:
        """The errors that wander."""
        import numpy as np

        return np.zeros((count, 3))

    def readings(self, sensed: SensedBatch, state: Any) -> dict[str, NDArray[np.float64]]:
        seen, numbers = sensed.seen, sensed.random.normal(6)
        state[:, :2] += walked(sensed, self.walk, numbers[:, :2])
        state[:, 2:] += walked(sensed, self.yaw_walk, numbers[:, 2:3])
        across = seen.speed * seen.yaw_rate
        return {
            "acceleration": seen.acceleration
            + self.bias
            + state[:, 0]
            + self.noise * numbers[:, 3],
            "lateral_acceleration": across + self.bias + state[:, 1] + self.noise * numbers[:, 4],
            "yaw_rate": seen.yaw_rate
            + self.yaw_bias
            + state[:, 2]
            + self.yaw_noise * numbers[:, 5],
        }
