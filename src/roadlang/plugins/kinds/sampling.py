"""Kinds that draw: distributions of values, samplers of candidates."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

from .base import Kind

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ...geometry.arrays import Floats


class Distribution(Kind):
    """A random value, written as a call: `normal(1m, 0.5m)`. Options are those of the call."""

    verb: ClassVar[str] = "distribution"
    required_methods: ClassVar[tuple[str, ...]] = ("quantile",)
    is_ordered: ClassVar[bool] = True
    """for countable values (`cells`): whether neighboring values are more alike than others"""

    def quantile(self, uniform: Floats) -> Any:
        """Values of the distribution, by inversion.

        `uniform` is (variants, 1) in [0, 1). Returns an array of the same shape, or of (variants,):
        finite numbers in SI units, or an array of objects if an option takes values of any type to
        choose from. Anything else is RL474, as is NaN.
        """
        raise NotImplementedError

    def support(self) -> tuple[float, float] | None:
        """Least and greatest value, for bounds; None if unknown. Options are plain numbers.

        Where options are drawn themselves it is evaluated at all ends of their ranges, so both must
        be monotonic in every option. A value beyond it is RL474.
        """
        return None

    def levels(self, steps: int) -> Iterable[float]:
        """Numbers in [0, 1] at which `quantile` gives the values that `sample with grid` visits:
        `steps` of them where it is continuous, the middle of each step by default."""
        return [(step + 0.5) / steps for step in range(steps)]

    def cells(self) -> Sequence[float] | None:
        """For countable values: the upper ends, ascending to 1, of the parts of [0, 1] in which
        `quantile` returns the same value. None for continuous values. Options are plain numbers."""
        return None

    def simplest(self) -> float:
        """The number in [0, 1) at which `quantile` returns the simplest value, toward which
        failures are shrunk; the median by default. Options are plain numbers."""
        return 0.5


class DrawnValue(Protocol):
    """A random value of the scenario, as samplers see it."""

    @property
    def place(self) -> str:
        """Its place in the scenario: `bent/perturb 1/amplitude`."""
        ...

    def levels(self, steps: int) -> Sequence[float]:
        """Numbers in [0, 1] that a grid visits, as `Distribution.levels` says."""
        ...


class Sampler(Kind):
    """`sample with`: which points of the unit cube of all random values become candidates.

    A sampler without methods draws at random. `points` chooses candidates by their index; `steer`
    chooses them based on the results of earlier ones.
    """

    verb: ClassVar[str] = "sample"
    sequential: ClassVar[bool] = True
    """candidates are one stream, and scene i is the i-th accepted of it; otherwise each scene has
    a stream of attempts of its own"""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.required_methods = ("points",) if cls.sequential else ()

    def points(self, indices: NDArray[np.int64], draws: Sequence[DrawnValue], seed: int) -> Floats:
        """The candidates at `indices` (n,) of the stream; each depends on its index alone.

        Returns (n, draws) numbers in [0, 1]; anything else is RL474.
        """
        raise NotImplementedError

    def size(self, draws: Sequence[DrawnValue]) -> int | None:
        """The number of candidates in the stream; None: unlimited."""
        return None

    def limit(self) -> int | None:
        """The number of candidates that are tried before a scene is given up; None: as many as fit
        in about five seconds."""
        return None

    def steer(self, known: Floats, uniform: Floats) -> Floats:
        """Proposals for candidates; a sampler with this method learns where the requirements hold.

        `known` (n, d) are points of the unit cube near which they hold, `uniform` (V, `numbers(d)`)
        random numbers in [0, 1). Returns (V, d) numbers in [0, 1); anything else is RL474.
        """
        raise NotImplementedError

    def pilot_size(self) -> int:
        """The greatest number of candidates that are evaluated before steering begins."""
        return 20_000

    def falls_back(self) -> bool:
        """Whether scenes are drawn uniformly instead of steered if that is faster."""
        return True

    def numbers(self, dimensions: int) -> int:
        """The number of random numbers that `steer` needs for a proposal, at least `dimensions`."""
        return dimensions
