"""`perturb with harmonics`: a random sum of waves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Integer, Length, Perturber, option

if TYPE_CHECKING:
    from roadlang.api import BatchRandom, RoadBatch
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Harmonics(Perturber):
    """Add waves of 1, 2, ... `modes` periods with random weights, never beyond `amplitude`."""

    name: ClassVar[str] = "harmonics"
    also_called: ClassVar[tuple[str, ...]] = ("fourier", "waves")
    amplitude: Length = option(minimum=0, help="bound of the displacement")
    modes: Integer = option(6, minimum=1, maximum=64, help="number of waves")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """Weights of a sine and a cosine for each wave, those of short waves smaller.

        Wave k has k periods on the road (on a closed one) or k half periods (on an open one) and
        weights uniform in [-1, 1] / k; their sum is scaled to the amplitude by the sum of all.
        """
        import numpy as np

        modes = np.broadcast_to(self.modes, (random.variants, 1))
        most = int(modes.max())
        order = np.arange(1, most + 1)
        drawn = 2.0 * random.uniform(2 * most) - 1.0
        weights = np.where(order <= modes, 1.0 / order, 0.0)
        sines, cosines = drawn[:, :most] * weights, drawn[:, most:] * weights
        period = roads.period if roads.period is not None else 2.0 * float(roads.stations[-1])
        angle = (2.0 * np.pi / period) * np.outer(order, roads.stations)
        # einsum keeps rows independent of each other to the last bit, which a matrix product
        # (whose blocks depend on the number of rows) does not.
        total = np.einsum("vk,ks->vs", sines, np.sin(angle))
        total += np.einsum("vk,ks->vs", cosines, np.cos(angle))
        bound = np.sqrt(sines**2 + cosines**2).sum(axis=1, keepdims=True)
        size = random.uniform(1, stream=1)
        return np.asarray(self.amplitude * size * total / np.maximum(bound, 1e-12))

    def displacement_bound(self) -> Floats | float:
        return self.amplitude

    def shortest_feature(self, length: float, closed: bool) -> Floats | float:
        """One period of the wave of the highest order."""
        return (length if closed else 2.0 * length) / self.modes
