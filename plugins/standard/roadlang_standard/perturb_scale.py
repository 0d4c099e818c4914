"""`perturb with scale`: bends sharper or flatter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Number, Perturber, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import BatchRandom, RoadBatch

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Scale(Perturber):
    """Scale the distance of the road from its chord (closed: from its centroid)."""

    name: ClassVar[str] = "scale"
    is_random: ClassVar[bool] = False
    factor: Number = option(minimum=0, help="1 leaves the road as it is, 0 makes it straight")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """(factor - 1) times how far each point is from its foot, along the normal."""
        import numpy as np

        lever = self._from_foot(roads)
        return np.atleast_2d((self.factor - 1.0) * (lever * roads.normal).sum(axis=-1))

    def _from_foot(self, roads: RoadBatch) -> Floats:
        """(V, S, 2) from the foot on the chord of the stretch, or the centroid, to the road."""
        import numpy as np

        points = roads.points
        if roads.stretch is None and roads.closed:
            return points - points.mean(axis=1, keepdims=True)
        low, high = (0.0, roads.stations[-1]) if roads.stretch is None else roads.stretch
        first = np.searchsorted(roads.stations, np.ravel(low)).clip(0, len(roads.stations) - 1)
        last = np.searchsorted(roads.stations, np.ravel(high), "right") - 1
        rows = np.arange(max(len(points), len(first), len(last)))
        many = np.broadcast_to(points, (len(rows), *points.shape[1:]))
        start = many[rows, np.broadcast_to(first, rows.shape)][:, None]
        chord = many[rows, np.broadcast_to(last, rows.shape)][:, None] - start
        square = np.maximum((chord * chord).sum(axis=-1, keepdims=True), 1e-12)
        share = ((many - start) * chord).sum(axis=-1, keepdims=True) / square
        return many - (start + share * chord)
