"""`perturb with sine`: the perturbation of the paper."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Angle, Length, Perturber, option


@dataclass(frozen=True)
class Sine(Perturber):
    """Sway the road by a sine wave along its arc length."""

    name: ClassVar[str] = "sine"
    amplitude: Length = option(help="greatest displacement")
    wavelength: Length = option(
        above=0, help="arc length of one period; a closed road has a whole number"
    )
    phase: Angle = option(0.0, help="of the wave where the road, or the stretch, begins")
