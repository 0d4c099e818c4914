"""`sense with ranges`: distances along rays, as of a lidar or of ultrasonic sensors."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Angle, Integer, Length, Number, ReadingArray, option

from .mounted_sensor import MountedSensor

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import SensedBatch

FULL_TURN = 2 * math.pi


@dataclass(frozen=True)
class Ranges(MountedSensor):
    """Distances to agents, objects and ground along rays: a lidar, or a radar without speeds."""

    name: ClassVar[str] = "ranges"

    rays: Integer = option(72, minimum=1, maximum=4096, help="number of rays side by side")
    angle: Angle = option(
        FULL_TURN,
        minimum=0,
        maximum=FULL_TURN,
        help="between the outermost rays; in a full turn the first ray is straight behind",
        example="120deg",
    )
    range: Length = option(
        60.0, above=0, maximum=1000, help="greatest distance; a ray that hits nothing reads this"
    )
    channels: Integer = option(1, minimum=1, maximum=256, help="number of rows of rays, from below")
    vertical_angle: Angle = option(
        math.radians(30.0),
        minimum=0,
        maximum=math.pi,
        help="between the lowest and the highest row, if there are several",
    )
    noise: Length = option(
        0.0, minimum=0, maximum=100, help="standard deviation of a distance", example="3cm"
    )
    lost_rays: Number = option(
        0.0, minimum=0, maximum=1, help="share of rays that are lost and read `range`", example="1%"
    )

    def arrays(self) -> dict[str, ReadingArray]:
        """`distances`: a number for each ray, from right to left, or for each channel and ray;
        `angles`: of the rays, to the left of the heading."""
        shape = (self.rays,) if self.channels == 1 else (self.channels, self.rays)
        high = float(self.range) if isinstance(self.range, int | float) else math.inf
        return {
            "distances": ReadingArray(shape, low=0.0, high=high, unit="m"),
            "angles": ReadingArray((self.rays,), unit="rad"),
        }

    def readings(self, sensed: SensedBatch, state: Any) -> dict[str, NDArray[np.float64]]:
        import numpy as np

        count = len(sensed.interval)
        angles, elevations = (
            np.broadcast_to(found, (count, found.shape[1])) for found in self._directions()
        )
        shape = (count, self.channels * self.rays)
        reach = np.asarray(self.range)
        found = sensed.cast_rays(
            self.at,
            np.repeat(angles[:, None], self.channels, axis=1).reshape(shape),
            np.repeat(elevations[:, :, None], self.rays, axis=2).reshape(shape),
            reach,
        )
        most = np.broadcast_to(reach, (count,))[:, None]
        noise = np.asarray(self.noise)
        if noise.any():
            found = found + noise[..., None] * sensed.random.normal(shape[1])
        if np.any(self.lost_rays):
            lost = sensed.random.uniform(shape[1], stream=1) < np.asarray(self.lost_rays)[..., None]
            found = np.where(lost, np.inf, found)
        found = np.minimum(np.maximum(found, 0.0), most)
        names = (count, *self.arrays()["distances"].shape)
        return {"distances": found.reshape(names), "angles": angles}

    def _directions(self) -> tuple[Any, Any]:
        """(N, rays) to the left of the heading, and (N, channels) upward."""
        import numpy as np

        def spread(count: int, angle: Any, middle: Any) -> Any:
            """From one side to the other; in a full turn the last is a step before the first."""
            angle, middle = np.atleast_1d(angle)[:, None], np.atleast_1d(middle)[:, None]
            number = np.arange(count)
            turns = angle >= FULL_TURN - 1e-9
            steps = np.where(turns, count, max(count - 1, 1))
            share = number / steps - 0.5 if count > 1 else np.zeros((1, 1))
            return middle + angle * share

        return (
            spread(self.rays, self.angle, self.yaw),
            spread(self.channels, self.vertical_angle, self.pitch),
        )
