"""`sample with random`: independent draws (the default)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Integer, Sampler, option


@dataclass(frozen=True)
class RandomSampler(Sampler):
    """Independent random draws, repeated until all requirements are satisfied."""

    name: ClassVar[str] = "random"
    is_default: ClassVar[bool] = True
    sequential: ClassVar[bool] = False
    attempts: Integer = option(
        None,
        minimum=1,
        maximum=100_000_000,
        help="maximum attempts per scene; by default about five seconds of work",
    )

    def limit(self) -> int | None:
        """The option `attempts`."""
        return self.attempts
