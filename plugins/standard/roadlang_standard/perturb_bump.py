"""`perturb with bump`: one swerve."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Length, Perturber, option


@dataclass(frozen=True)
class Bump(Perturber):
    """Push the road aside at one place."""

    name: ClassVar[str] = "bump"
    at: Length = option(help="arc length of the middle")
    height: Length = option(help="displacement in the middle, left positive")
    length: Length = option(above=0, help="arc length from where it begins to where it ends")
