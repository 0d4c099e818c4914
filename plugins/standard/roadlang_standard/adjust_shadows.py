"""`adjust with shadows`: dark blobs, as of clouds and trees."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Adjuster, Number, Pixels, Whole, option


@dataclass(frozen=True)
class Shadows(Adjuster):
    """Darken elliptic patches at random places."""

    name: ClassVar[str] = "shadows"
    count: Whole = option(minimum=0, maximum=1000, help="how many")
    size: Pixels = option(above=0, help="mean radius of a patch")
    darkness: Number = option(0.5, minimum=0, maximum=1, help="1 is black")
    softness: Number = option(
        0.3, minimum=0, maximum=1, help="width of the edge, as a share of the size"
    )
