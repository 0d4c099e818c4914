"""`adjust with noise`: sensor noise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Adjuster, Number, option


@dataclass(frozen=True)
class Noise(Adjuster):
    """Add Gaussian noise to every channel of every pixel."""

    name: ClassVar[str] = "noise"
    sigma: Number = option(
        minimum=0, maximum=1, help="standard deviation, as a share of full scale"
    )
