"""`adjust with shadows`: dark patches, like the shadows of clouds and trees."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Adjuster, Integer, Number, Pixels, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Shadows(Adjuster):
    """Darken elliptic patches at random places."""

    name: ClassVar[str] = "shadows"
    is_random: ClassVar[bool] = True
    count: Integer = option(minimum=0, maximum=1000, help="number of patches")
    size: Pixels = option(above=0, help="mean radius of a patch")
    darkness: Number = option(0.5, minimum=0, maximum=1, help="0 is transparent, 1 is black")
    softness: Number = option(
        0.3, minimum=0, maximum=1, help="width of the soft edge, as a fraction of `size`"
    )

    def adjust(self, pixels: Picture, random: np.random.Generator) -> Picture:
        import cv2
        import numpy as np

        height, width = pixels.shape[:2]
        shade = np.zeros((height, width), np.float32)
        for _ in range(self.count):
            middle = (random.uniform(0, width), random.uniform(0, height))
            axes = self.size * random.uniform(0.5, 1.5, 2)
            box = (middle, tuple(2.0 * axes), random.uniform(0.0, 180.0))
            cv2.ellipse(shade, box, 1.0, thickness=-1)
        if self.softness > 0:
            shade = cv2.GaussianBlur(shade, (0, 0), max(0.5, self.softness * self.size))
        light = 1.0 - self.darkness * shade[..., None]
        return np.asarray(np.rint(np.clip(pixels * light, 0, 255)), np.uint8)
