"""`drive with emergency_brake`: brakes for what a `ranges` sensor sees in the way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Acceleration, Controller, Duration, Length, String, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch


@dataclass(frozen=True)
class EmergencyBrake(Controller):
    """Brake hard for what a `ranges` sensor sees straight ahead, assuming that it does not move;
    otherwise the controller before it drives. Once it brakes, it brakes to a stop."""

    name: ClassVar[str] = "emergency_brake"
    also_called: ClassVar[tuple[str, ...]] = ("aeb", "autonomous_emergency_braking")
    leaves_open: ClassVar[str] = "steering and, while the way is free, acceleration"
    sensor_options: ClassVar[tuple[str, ...]] = ("sensor",)

    sensor: String = option("ranges", help="name of the sensor", example='"front"')
    deceleration: Acceleration = option(8.0, above=0, maximum=50, help="deceleration")
    reaction: Duration = option(
        0.2, minimum=0, maximum=10, help="time driven at the current speed before the brakes act"
    )
    gap: Length = option(
        2.0,
        minimum=0,
        help="distance to stop at, from the sensor, which may be behind the front of the vehicle",
    )
    margin: Length = option(
        0.2, minimum=-10, help="objects up to this far beside the vehicle count as in its way"
    )

    def start(self, count: int) -> NDArray[np.float64]:
        """Who brakes, 1."""
        import numpy as np

        return np.zeros(count)

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        distances, angles = self._rays(seen)
        half = 0.5 * seen.width + self.margin
        in_way = np.abs(distances * np.sin(angles)) <= half[:, None]
        in_way &= np.cos(angles) > 0.0
        ahead = np.where(in_way, distances * np.cos(angles), np.inf).min(axis=1)
        speed = seen.speed
        needed = speed * speed / (2.0 * self.deceleration) + speed * self.reaction + self.gap
        state[:] = np.where((ahead <= needed) | ((state > 0.0) & (speed > 0.1)), 1.0, 0.0)
        braking = np.where(state > 0.0, -self.deceleration, np.nan)
        return ControlBatch(np.full(len(speed), np.nan), braking)

    def _rays(self, seen: ObservationBatch) -> tuple[Any, Any]:
        """(N, R) distances and angles. Raises `OptionError` for a sensor that has none."""
        from roadlang.api import OptionError

        try:
            reading = seen.sensors[self.sensor]
            distances, angles = reading.distances, reading.angles
        except (KeyError, AttributeError) as error:
            raise OptionError("sensor", f"has no rays: {error.args[0]}") from None
        if distances.ndim != 2:
            raise OptionError("sensor", "has several channels; it needs rays in one row")
        return distances, angles
