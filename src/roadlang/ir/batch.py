"""Roads in many variants at once, and randomness that is keyed, not ordered."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class RoadBatch:
    """A road in V variants, sampled at S stations of its root road (arc length, metres).

    All roads that derive from one root share its stations, so that they can be compared point
    by point. Arrays have V rows, or one row where all variants are alike.
    """

    name: str
    root: str
    stations: Floats
    points: Floats
    """(V, S, 2) metres"""
    heading: Floats
    """(V, S) radians, unwrapped along the road"""
    curvature: Floats
    """(V, S) 1/m, left positive"""
    width: Floats
    """(V, S) metres"""
    closed: bool = False
    folded: NDArray[np.bool_] | None = None
    """(V,) True where a displacement exceeded the radius of a bend"""
    others: tuple[RoadBatch, ...] = ()
    """the other roads of the same network, for clearance"""

    @property
    def variants(self) -> int:
        return int(self.points.shape[0])

    @cached_property
    def normal(self) -> Floats:
        """(V, S, 2) unit vectors to the left."""
        import numpy as np

        return np.stack([-np.sin(self.heading), np.cos(self.heading)], axis=-1)

    @cached_property
    def length(self) -> Floats:
        """(V, 1) metres along the road itself."""
        import numpy as np

        points = self.points
        if self.closed:
            points = np.concatenate([points, points[:, :1]], axis=1)
        steps = np.linalg.norm(np.diff(points, axis=1), axis=-1)
        return np.asarray(steps.sum(axis=1, keepdims=True))


class BatchRandom:
    """Random numbers of one pass: a function of (seed, scene, attempt, place), for each variant.

    `keys`: (V,) uint64, one per variant.
    """

    def __init__(self, keys: NDArray[np.uint64]) -> None:
        self.keys = keys

    def uniform(self, count: int, stream: int = 0) -> Floats:
        """(V, count) numbers in [0, 1); another `stream`, other numbers."""
        import numpy as np

        steps = np.arange(1, count + 1, dtype=np.uint64) + np.uint64(stream << 32)
        with np.errstate(over="ignore"):
            words = mix(self.keys[:, None] + steps[None, :] * np.uint64(0x9E3779B97F4A7C15))
        return (words >> np.uint64(11)).astype(np.float64) * 2.0**-53

    def normal(self, count: int, stream: int = 0) -> Floats:
        """(V, count) standard normal numbers."""
        import numpy as np

        pairs = self.uniform(2 * count, stream)
        radius = np.sqrt(-2.0 * np.log1p(-pairs[:, :count]))
        return np.asarray(radius * np.cos(2.0 * np.pi * pairs[:, count:]))

    def generator(self, variant: int) -> np.random.Generator:
        """A numpy generator for one variant."""
        import numpy as np

        return np.random.Generator(np.random.Philox(key=int(self.keys[variant])))


def mix(words: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every input bit reaches every
    output bit."""
    import numpy as np

    with np.errstate(over="ignore"):
        words = (words ^ (words >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        words = (words ^ (words >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return words ^ (words >> np.uint64(31))
