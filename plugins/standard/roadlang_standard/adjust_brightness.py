"""`adjust with brightness`: the picture lighter or darker."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Adjuster, Number, option


@dataclass(frozen=True)
class Brightness(Adjuster):
    """Multiply every channel by a factor."""

    name: ClassVar[str] = "brightness"
    factor: Number = option(minimum=0, help="1 leaves the picture as it is, 0 is black")
