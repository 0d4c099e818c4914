"""`sample with random`: independent draws (the default)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Sampler, Whole, option


@dataclass(frozen=True)
class Random(Sampler):
    """Draw at random; each scene tries until its draw satisfies every requirement."""

    name: ClassVar[str] = "random"
    is_default: ClassVar[bool] = True
    sequential: ClassVar[bool] = False
    attempts: Whole = option(
        None,
        minimum=1,
        maximum=100_000_000,
        help="tries before a scene is given up; about five seconds' worth",
    )

    def limit(self) -> int | None:
        """The option `attempts`."""
        return self.attempts
