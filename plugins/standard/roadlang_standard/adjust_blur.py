"""`adjust with blur`: an image out of focus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Adjuster, Pixels, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Blur(Adjuster):
    """Blur with a Gaussian filter."""

    name: ClassVar[str] = "blur"
    radius: Pixels = option(minimum=0, maximum=200, help="standard deviation of the Gaussian")

    def adjust(self, pixels: Picture, random: np.random.Generator) -> Picture:
        import cv2
        import numpy as np

        if self.radius <= 0:
            return pixels
        return np.asarray(cv2.GaussianBlur(pixels, (0, 0), self.radius), np.uint8)
