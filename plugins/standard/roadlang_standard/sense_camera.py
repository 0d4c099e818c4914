"""`sense with camera`: pictures, in an engine that draws."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, Literal

from roadlang.api import (
    Angle,
    ListOf,
    OptionError,
    Pixels,
    PointInSpace,
    ReadingArray,
    option,
)

from .mounted_sensor import MountedSensor


@dataclass(frozen=True)
class Camera(MountedSensor):
    """A camera: color, depth and what each pixel shows. For engines that draw, such as Godot."""

    name: ClassVar[str] = "camera"

    at: PointInSpace = option(
        (1.5, 0.0, 1.2),
        help="where it is: ahead of the center of the vehicle, left of it, above the ground",
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
    outputs: ListOf[Literal["rgb", "depth", "semantic", "instance"]] = option(
        ("rgb",),
        at_least=1,
        help="what a reading holds: `rgb`; `depth`, meters from the camera's plane; `semantic`, "
        "the class of each pixel; `instance`, the number of each thing",
        example="[rgb, depth, semantic]",
    )

    def __post_init__(self) -> None:
        for name in ("width", "height"):
            if getattr(self, name) != round(getattr(self, name)):
                raise OptionError(name, "is not a whole number of pixels")
        if len(set(self.outputs)) != len(self.outputs):
            raise OptionError("outputs", "names an output twice")

    def arrays(self) -> dict[str, ReadingArray]:
        """Arrays of (height, width), from the top left."""
        shape = (round(self.height), round(self.width))
        known = {
            "rgb": ReadingArray((*shape, 3), "uint8", 0, 255),
            "depth": ReadingArray(shape, "float32", 0.0, unit="m"),
            "semantic": ReadingArray(shape, "uint8", 0, 255),
            "instance": ReadingArray(shape, "uint16", 0, 65535),
        }
        return {name: known[name] for name in self.outputs}
