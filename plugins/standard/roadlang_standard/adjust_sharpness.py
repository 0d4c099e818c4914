"""`adjust with sharpness`: edges softer or crisper."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Adjuster, Number, option


@dataclass(frozen=True)
class Sharpness(Adjuster):
    """Blend with a smoothed copy (below 1) or away from it (above 1)."""

    name: ClassVar[str] = "sharpness"
    factor: Number = option(
        minimum=0, maximum=20, help="1 leaves the picture as it is, 0 is smooth"
    )
