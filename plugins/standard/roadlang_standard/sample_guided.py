"""`sample with guided`: robustness steers the draw."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Sampler, Whole, option


@dataclass(frozen=True)
class Guided(Sampler):
    """Learn from robustness where the requirements hold, and draw there."""

    name: ClassVar[str] = "guided"
    sequential: ClassVar[bool] = False
    attempts: Whole = option(
        10_000, minimum=1, maximum=100_000_000, help="tries for one scene before it is given up"
    )
