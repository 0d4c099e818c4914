"""`perturb with harmonics`: a random sum of waves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Length, Perturber, Whole, option


@dataclass(frozen=True)
class Harmonics(Perturber):
    """Add waves of 1, 2, ... `modes` periods with random weights, never beyond `amplitude`."""

    name: ClassVar[str] = "harmonics"
    amplitude: Length = option(minimum=0, help="bound of the displacement")
    modes: Whole = option(6, minimum=1, maximum=64, help="how many waves")
