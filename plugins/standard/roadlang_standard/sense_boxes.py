"""`sense with boxes`: what a detector of agents and objects gives."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Integer, Length, Number, ReadingArray, option

from .camera_view import CameraView

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import SensedBatch


@dataclass(frozen=True)
class Boxes(CameraView):
    """The agents and objects in the view of a camera, as boxes in space and in its picture."""

    name: ClassVar[str] = "boxes"

    range: Length = option(
        100.0, above=0, maximum=1000, help="greatest distance of a center from the camera"
    )
    most: Integer = option(
        16, minimum=1, maximum=256, help="number of boxes in a reading, the nearest first"
    )
    noise: Length = option(
        0.0,
        minimum=0,
        maximum=100,
        help="standard deviation of each coordinate of a center",
        example="20cm",
    )
    missed: Number = option(
        0.0, minimum=0, maximum=1, help="share of things that are not detected", example="2%"
    )

    def arrays(self) -> dict[str, ReadingArray]:
        """A row for each thing, the nearest first; all 0 where there are no more.

        `class_id`: as in pictures of classes. `center`: meters ahead of the center of the agent,
        to its left, and above the ground; `size`: length, width and height; `heading`: to the left
        of that of the agent. `box`: left, top, right and bottom in the picture, pixels. `visible`:
        the share that nothing hides.
        """
        most = self.most
        return {
            "class_id": ReadingArray((most,), "uint8", 0, 255),
            "center": ReadingArray((most, 3), unit="m"),
            "size": ReadingArray((most, 3), low=0.0, unit="m"),
            "heading": ReadingArray((most,), low=-math.pi, high=math.pi, unit="rad"),
            "box": ReadingArray((most, 4), low=0.0, high=4096.0),
            "visible": ReadingArray((most,), low=0.0, high=1.0),
        }

    def readings(self, sensed: SensedBatch, state: Any) -> dict[str, NDArray[np.generic]]:
        from .detected_boxes import BoxCamera, detected

        columns = (self.width, self.height, self.fov, self.at, self.yaw, self.pitch, self.range)
        camera = BoxCamera.of(len(sensed.interval), *columns)
        return detected(camera, sensed, self.most, self.noise, self.missed)
