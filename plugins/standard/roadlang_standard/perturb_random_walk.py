"""`perturb with random_walk`: a road that wanders."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Length, Perturber, option


@dataclass(frozen=True)
class RandomWalk(Perturber):
    """Let the road wander at random, smoothly, never beyond `amplitude`."""

    name: ClassVar[str] = "random_walk"
    amplitude: Length = option(minimum=0, help="bound of the displacement")
    correlation: Length = option(
        above=0, help="arc length over which the road forgets where it was"
    )
