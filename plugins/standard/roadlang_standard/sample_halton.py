"""`sample with halton`: an even cover of the space of draws."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Sampler, Whole, option


@dataclass(frozen=True)
class Halton(Sampler):
    """A scrambled Halton sequence: fewer gaps than random draws."""

    name: ClassVar[str] = "halton"
    attempts: Whole = option(
        1_000_000,
        minimum=1,
        maximum=100_000_000,
        help="candidates in all before the search is given up",
    )
