"""`adjust with noise`: sensor noise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Adjuster, Number, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Noise(Adjuster):
    """Add Gaussian noise to every channel of every pixel."""

    name: ClassVar[str] = "noise"
    is_random: ClassVar[bool] = True
    sigma: Number = option(
        minimum=0, maximum=1, help="standard deviation, as a fraction of the full range"
    )

    def adjust(self, pixels: Picture, random: np.random.Generator) -> Picture:
        import numpy as np

        grain = random.normal(0.0, 255.0 * self.sigma, pixels.shape)
        return np.rint(np.clip(pixels + grain, 0, 255)).astype(np.uint8)
