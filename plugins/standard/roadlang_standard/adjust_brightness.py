"""`adjust with brightness`: a lighter or darker image."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Adjuster, Number, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Brightness(Adjuster):
    """Multiply all color channels by a factor."""

    name: ClassVar[str] = "brightness"
    factor: Number = option(minimum=0, help="factor: 1 changes nothing, 0 is black")

    def adjust(self, pixels: Picture, random: np.random.Generator) -> Picture:
        import numpy as np

        return np.asarray(np.rint(np.clip(pixels * self.factor, 0, 255)), np.uint8)
