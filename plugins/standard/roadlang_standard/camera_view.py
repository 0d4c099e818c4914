"""What a camera covers: where it is, where it looks, and its picture."""

from __future__ import annotations

import math
from dataclasses import dataclass

from roadlang.api import Angle, OptionError, Pixels, PointInSpace, option

from .mounted_sensor import MountedSensor


@dataclass(frozen=True)
class CameraView(MountedSensor):
    """A sensor with the view of a camera."""

    at: PointInSpace = option(
        (1.5, 0.0, 1.2),
        help="position: ahead of the center of the vehicle, to its left, above the ground",
        example="(1.5m, 0m, 1.2m)",
    )
    width: Pixels = option(320.0, minimum=16, maximum=4096, help="width of the picture")
    height: Pixels = option(180.0, minimum=16, maximum=4096, help="height of the picture")
    fov: Angle = option(
        math.pi / 2,
        minimum=math.radians(1),
        maximum=math.radians(170),
        help="horizontal field of view",
        example="60deg",
    )

    def __post_init__(self) -> None:
        for name in ("width", "height"):
            value = getattr(self, name)
            # Columns, of several agents, were checked one by one.
            if isinstance(value, int | float) and value != round(value):
                raise OptionError(name, "is not a whole number of pixels")
