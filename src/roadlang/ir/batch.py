"""Roads in many variants at once, and randomness that is keyed, not ordered."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

from .read_only import Frozen, frozen

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..geometry import CurveBatch
    from ..geometry.arrays import Floats


@dataclass(frozen=True, eq=False)
class RoadBatch(Frozen):
    """V variants of a road, sampled at S stations of its root road (arc length, meters).

    All roads with the same root share its stations, so that they can be compared point by point.
    Arrays have V rows, or one row if all variants are equal; they are computed when first used.
    """

    name: str
    root: str
    curves: CurveBatch
    width: Floats
    """(V, S) or (V, 1) meters"""
    displacement: Floats
    """(V, S) meters: the sum of all displacements from the root, left positive"""
    confidence: float
    """confidence of the extractor, 0 to 1; 1 for roads that were not extracted"""
    interval: tuple[Any, Any] | None = None
    """`over: [a, b]` of the pass that perturbs it: arc lengths, or (V, 1) columns of such"""
    others: tuple[RoadBatch, ...] = ()
    """the other roads of the same network, for clearance"""

    @property
    def stations(self) -> Floats:
        """(S,) arc length of the root road."""
        return self.curves.stations

    @property
    def points(self) -> Floats:
        """(V, S, 2) meters."""
        return self.curves.points

    @property
    def heading(self) -> Floats:
        """(V, S) radians, continuous along the road."""
        return self.curves.heading

    @property
    def curvature(self) -> Floats:
        """(V, S) 1/m, left positive."""
        return self.curves.curvature

    @property
    def normal(self) -> Floats:
        """(V, S, 2) unit vectors to the left."""
        normal: Floats = frozen(self.curves.normal)
        return normal

    @property
    def closed(self) -> bool:
        """Whether the roads are closed."""
        return self.curves.closed

    @property
    def period(self) -> float | None:
        """Length of the root road in meters, for closed roads."""
        return self.curves.period

    @property
    def folded(self) -> NDArray[np.bool_]:
        """(V,) True where a displacement exceeded the radius of a bend."""
        return self.curves.folded

    @property
    def variants(self) -> int:
        """Number of variants, V."""
        return self.curves.variants

    @property
    def length(self) -> Floats:
        """(V, 1) meters along the road itself."""
        length: Floats = frozen(self.curves.length[:, None])
        return length

    def take(self, rows: NDArray[np.intp]) -> RoadBatch:
        """The variants at `rows`; arrays with one row for all variants keep it."""
        every = {field.name: getattr(self, field.name) for field in fields(self)}
        chosen = {"curves": _rows(self.curves, rows)}
        if self.displacement is getattr(self.curves, "displacement", None):
            chosen["displacement"] = chosen["curves"].displacement  # copied once
        for name in every.keys() - chosen.keys():
            chosen[name] = _rows(every[name], rows)
        if all(chosen[name] is value for name, value in every.items()):
            return self
        return replace(self, **chosen)


def _rows(value: Any, rows: NDArray[np.intp]) -> Any:
    """The rows of a field: of arrays, curves and roads, also inside tuples."""
    if isinstance(value, RoadBatch):
        return value.take(rows)
    if hasattr(value, "variants"):  # curves
        return value if value.variants == 1 else value.take(rows)
    if hasattr(value, "shape"):
        return value if value.shape[0] == 1 else value[rows]
    if isinstance(value, tuple):
        items = tuple(_rows(item, rows) for item in value)
        is_same = all(item is before for item, before in zip(items, value, strict=True))
        return value if is_same else items
    return value


class BatchRandom:
    """Random numbers of one pass: a function of (seed, scene, attempt, place), for each variant.

    `keys`: (V,) uint64, one per variant.
    """

    def __init__(self, keys: NDArray[np.uint64]) -> None:
        self.keys = frozen(keys)

    @property
    def variants(self) -> int:
        """Number of variants, V."""
        return len(self.keys)

    def uniform(self, count: int, stream: int = 0) -> Floats:
        """(V, count) numbers in [0, 1); another `stream`, other numbers."""
        return unit_interval(self.keys[:, None], count, stream)

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


def unit_interval(keys: NDArray[np.uint64], count: int, stream: int = 0) -> Floats:
    """Keys (V, 1) to numbers in [0, 1), (V, count): SplitMix64 from each key on."""
    import numpy as np

    steps = np.arange(1, count + 1, dtype=np.uint64) + np.uint64(stream << 32)
    with np.errstate(over="ignore"):
        words = mix(numbered(keys, steps[None, :]))
    return (words >> np.uint64(11)).astype(np.float64) * 2.0**-53


def numbered(words: NDArray[np.uint64], numbers: NDArray[Any]) -> NDArray[np.uint64]:
    """Words for the `numbers` >= 0 of what each of the `words` stands for, in their common shape:
    the states of SplitMix64 (Steele, Lea, Flood 2014), from which `mix` makes random words."""
    import numpy as np

    with np.errstate(over="ignore"):
        return words + np.asarray(numbers, np.uint64) * np.uint64(0x9E3779B97F4A7C15)


def mix(words: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """The finalizer of SplitMix64 (Steele, Lea, Flood 2014): every input bit reaches every
    output bit."""
    import numpy as np

    with np.errstate(over="ignore"):
        words = (words ^ (words >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        words = (words ^ (words >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return words ^ (words >> np.uint64(31))
