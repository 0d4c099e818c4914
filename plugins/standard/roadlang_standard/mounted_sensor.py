"""Where a sensor is on its vehicle."""

from __future__ import annotations

import math
from dataclasses import dataclass

from roadlang.api import Angle, PointInSpace, Sensor, option


@dataclass(frozen=True)
class MountedSensor(Sensor):
    """A sensor that looks from a place of the vehicle in a direction."""

    at: PointInSpace = option(
        (0.0, 0.0, 0.5),
        help="position: ahead of the center of the vehicle, to its left, above the ground",
        example="(2.2m, 0m, 0.5m)",
    )
    yaw: Angle = option(0.0, help="to the left of straight ahead", example="180deg")
    pitch: Angle = option(
        0.0,
        minimum=-math.pi / 2,
        maximum=math.pi / 2,
        help="upward from the horizontal",
        example="-5deg",
    )
