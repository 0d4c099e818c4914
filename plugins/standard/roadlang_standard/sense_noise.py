"""`sense with noise`: what controllers see of their own agent, with errors."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Angle, Length, ReadingArray, Sensor, Speed, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import SensedBatch

_UNITS = {
    "x": "m",
    "y": "m",
    "heading": "rad",
    "speed": "m/s",
    "cross_track_error": "m",
    "heading_error": "rad",
    "road_offset": "m",
    "station": "m",
    "traveled": "m",
}


@dataclass(frozen=True)
class ObservationNoise(Sensor):
    """Controllers see the position, heading and speed of their agent with errors and delay."""

    name: ClassVar[str] = "noise"
    replaces: ClassVar[tuple[str, ...]] = tuple(_UNITS)

    position: Length = option(
        0.0, minimum=0, maximum=1000, help="standard deviation of x and of y", example="0.3m"
    )
    heading: Angle = option(
        0.0,
        minimum=0,
        maximum=math.pi,
        help="standard deviation of the heading",
        example="1deg",
    )
    speed: Speed = option(
        0.0, minimum=0, maximum=1000, help="standard deviation of the speed", example="0.2m/s"
    )

    def arrays(self) -> dict[str, ReadingArray]:
        """Columns of observations."""
        return {name: ReadingArray(unit=unit) for name, unit in _UNITS.items()}

    def readings(self, sensed: SensedBatch, state: Any) -> dict[str, NDArray[np.float64]]:
        import numpy as np

        seen, numbers = sensed.seen, sensed.random.normal(4)
        line = seen.heading - seen.heading_error
        east, north = self.position * numbers[:, 0], self.position * numbers[:, 1]
        ahead = np.cos(line) * east + np.sin(line) * north
        left = np.cos(line) * north - np.sin(line) * east
        turned = self.heading * numbers[:, 2]
        return {
            "x": seen.x + east,
            "y": seen.y + north,
            "heading": seen.heading + turned,
            "speed": seen.speed + self.speed * numbers[:, 3],
            "cross_track_error": seen.cross_track_error + left,
            "heading_error": seen.heading_error + turned,
            "road_offset": seen.road_offset + left,
            "station": seen.station,
            "traveled": seen.traveled + ahead,
        }
