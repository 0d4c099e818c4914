"""`perturb with random_walk`: a road that wanders."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Length, Perturber, option

if TYPE_CHECKING:
    from roadlang.api import BatchRandom, RoadBatch
    from roadlang.geometry import Floats


MOST_KNOTS = 20_000
"""Of a road; closer ones, more than the stations of a road can show, would be a waste of memory."""


@dataclass(frozen=True)
class RandomWalk(Perturber):
    """Let the road wander at random, smoothly, never beyond `amplitude`."""

    name: ClassVar[str] = "random_walk"
    also_called: ClassVar[tuple[str, ...]] = ("noise", "gaussian", "perlin", "jitter")
    amplitude: Length = option(minimum=0, help="bound of the displacement")
    correlation: Length = option(
        above=0, help="correlation length: arc length over which displacements are related"
    )

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """A reflected random walk at knots, joined by uniform cubic B-splines.

        Knots are `correlation` apart; a step is uniform in [-1.5, 1.5] amplitudes, after which the
        walk has forgotten all but 40 % of where it was. A B-spline stays between its knots' values.
        """
        import numpy as np

        count = random.variants
        length = roads.period if roads.period is not None else float(roads.stations[-1])
        gap = np.broadcast_to(np.asarray(self.correlation, float).reshape(-1, 1), (count, 1))
        gap = np.maximum(gap, length / MOST_KNOTS)
        if roads.period is not None:
            gap = length / np.maximum(np.rint(length / gap), 3.0)
        knots = int(np.ceil(length / gap.min() - 1e-9)) + 4
        walk = self._walk(random, knots)
        place = roads.stations / gap
        index = np.floor(place).astype(np.int64)
        t = place - index
        cubes = ((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3)
        total = np.zeros(np.broadcast_shapes(place.shape, (count, 1)))
        turns = np.rint(length / gap).astype(np.int64) if roads.period is not None else None
        for shift, weight in enumerate(cubes):
            at = index + shift if turns is None else (index + shift) % turns
            total += weight / 6.0 * np.take_along_axis(walk, at, axis=1)
        return self.amplitude * total

    def _walk(self, random: BatchRandom, knots: int) -> Floats:
        """(V, knots) in [-1, 1]: the n-th number depends on the first n draws alone."""
        import numpy as np

        drawn = random.uniform(knots)
        steps = 3.0 * drawn - 1.5
        steps[:, 0] = 4.0 * drawn[:, 0]
        # Folding the line into [-1, 1] reflects the walk at both ends.
        return np.abs(np.mod(np.cumsum(steps, axis=1), 4.0) - 2.0) - 1.0

    def displacement_bound(self) -> Floats | float:
        return self.amplitude

    def shortest_feature(self, length: float, closed: bool) -> Floats | float:
        """A wave between neighboring knots."""
        return 2.0 * self.correlation
