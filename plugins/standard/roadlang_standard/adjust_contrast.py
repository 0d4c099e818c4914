"""`adjust with contrast`: lower or higher contrast."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Adjuster, Number, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Contrast(Adjuster):
    """Scale the difference of every color from the mean gray."""

    name: ClassVar[str] = "contrast"
    factor: Number = option(minimum=0, help="factor: 1 changes nothing, 0 is uniform gray")

    def adjust(self, pixels: Picture, random: np.random.Generator) -> Picture:
        import numpy as np

        mean = float(pixels.mean())
        return np.asarray(np.rint(np.clip((pixels - mean) * self.factor + mean, 0, 255)), np.uint8)
