"""`adjust with contrast`: the picture flatter or harder."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Adjuster, Number, option


@dataclass(frozen=True)
class Contrast(Adjuster):
    """Pull the colours away from, or towards, the mean grey."""

    name: ClassVar[str] = "contrast"
    factor: Number = option(minimum=0, help="1 leaves the picture as it is, 0 is grey")
