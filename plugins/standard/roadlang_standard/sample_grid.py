"""`sample with grid`: every combination."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Sampler, Whole, option


@dataclass(frozen=True)
class Grid(Sampler):
    """Every combination of the values of all draws: a parameter sweep."""

    name: ClassVar[str] = "grid"
    steps: Whole = option(5, minimum=1, maximum=10_000, help="values of a continuous draw")
