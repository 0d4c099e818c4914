"""`sample with guided`: draws guided by robustness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Integer, Sampler, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


_JITTER = 0.01


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

    def limit(self) -> int | None:
        """The option `attempts`."""
        return self.attempts

    def pilot_size(self) -> int:
        """The option `pilot`."""
        return self.pilot

    def numbers(self, dimensions: int) -> int:
        """Five choose and scale a move, the others spread it."""
        return dimensions + 5

    def steer(self, known: Floats, uniform: Floats) -> Floats:
        """Proposals (V, d) in the unit cube from `known` (n, d) and `uniform` (V, d + 5).

        The first number chooses a known point. It is moved by a multiple of the difference of two
        others (differential evolution, Storn and Price 1997), so that moves have the directions in
        which the known points differ.
        """
        import numpy as np

        count = len(known)
        lead, spread = uniform[:, :5], uniform[:, 5:]
        parent, first, second = np.minimum((lead[:, :3] * count).astype(int), count - 1).T
        length = 1.5 * lead[:, 3:4]
        moved = known[parent] + length * (known[first] - known[second])
        moved += _JITTER * (spread + np.roll(spread, 1, axis=1) - 1.0)
        folded: Floats = 1.0 - np.abs(np.mod(moved, 2.0) - 1.0)
        return np.clip(folded, 0.0, 1.0 - 2.0**-53)
