"""`adjust with blur`: the picture out of focus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Adjuster, Pixels, option


@dataclass(frozen=True)
class Blur(Adjuster):
    """Smooth with a Gaussian."""

    name: ClassVar[str] = "blur"
    radius: Pixels = option(minimum=0, maximum=200, help="standard deviation of the Gaussian")
