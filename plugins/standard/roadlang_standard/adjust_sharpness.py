"""`adjust with sharpness`: softer or sharper edges."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Adjuster, Number, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Sharpness(Adjuster):
    """Blend the image with a smoothed copy (below 1) or away from it (above 1)."""

    name: ClassVar[str] = "sharpness"
    factor: Number = option(
        minimum=0, maximum=20, help="factor: 1 changes nothing, 0 is fully smoothed"
    )

    def adjust(self, pixels: Picture, random: np.random.Generator) -> Picture:
        import cv2
        import numpy as np

        smooth = cv2.blur(pixels, (3, 3)).astype(np.float32)
        mixed = smooth + (pixels - smooth) * self.factor
        return np.asarray(np.rint(np.clip(mixed, 0, 255)), np.uint8)
