"""`sample with grid`: every combination of values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Code, DiagnosticError, Integer, Sampler, diagnose, option

from .unit_cube import MOST_COMBINATIONS

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import DrawnValue
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class GridSampler(Sampler):
    """A parameter sweep: every combination of the values of all draws."""

    name: ClassVar[str] = "grid"
    steps: Integer = option(
        5, minimum=1, maximum=10_000, help="number of values of each continuous draw"
    )

    def size(self, draws: Sequence[DrawnValue]) -> int:
        """The product of the numbers of levels. Raises RL614 beyond ten million."""
        count = 1
        for draw in draws:
            count *= len(draw.levels(self.steps))
            if count > MOST_COMBINATIONS:
                most = f"{MOST_COMBINATIONS:,}"
                help_ = "use fewer `steps`, make fewer values random, or `sample with halton`"
                raise DiagnosticError(diagnose(Code.GRID_TOO_LARGE, most=most, help=help_))
        return count

    def points(self, indices: NDArray[np.int64], draws: Sequence[DrawnValue], seed: int) -> Floats:
        """The last draw changes fastest."""
        import numpy as np

        points = np.empty((len(indices), len(draws)))
        rest = np.asarray(indices)
        for column in reversed(range(len(draws))):
            levels = np.asarray(draws[column].levels(self.steps))
            points[:, column] = levels[rest % len(levels)]
            rest = rest // len(levels)
        return points
