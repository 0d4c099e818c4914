"""`sample with guided`: draws guided by robustness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from roadlang.api import Integer, Sampler, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Guided(Sampler):
    """Learn from robustness where the requirements are satisfied, and sample there."""

    name: ClassVar[str] = "guided"
    sequential: ClassVar[bool] = False
    attempts: Integer = option(
        None,
        minimum=1,
        maximum=100_000_000,
        help="maximum attempts per scene; by default about five seconds of work",
    )
    pilot: Integer = option(
        20_000, minimum=100, maximum=10_000_000, help="maximum number of candidates to learn from"
    )
    fallback: Literal["auto", "never"] = option(
        "auto",
        help="`auto` draws as `random` does where so many draws satisfy the requirements that "
        "learning would not pay; `never` always learns",
    )

    def limit(self) -> int | None:
        """The option `attempts`."""
        return self.attempts

    def pilot_size(self) -> int:
        """The option `pilot`."""
        return self.pilot

    def falls_back(self) -> bool:
        """The option `fallback`."""
        return self.fallback == "auto"

    def numbers(self, dimensions: int) -> int:
        """Six choose a region, a point in it, a move and its size; three for each coordinate."""
        return 3 * dimensions + 6

    def steer(self, known: Floats, uniform: Floats) -> Floats:
        """Proposals (V, d) in the unit cube from `known` (n, d) and `uniform` (V, 3 d + 6).

        A mixture of local models: a region, by its size, a known point in it, and a move from
        there that is drawn with the neighbors of the point (see `local_moves`).
        """
        from .local_moves import moved

        return moved(known, uniform)
