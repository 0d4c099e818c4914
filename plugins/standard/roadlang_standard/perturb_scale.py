"""`perturb with scale`: bends sharper or flatter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Number, Perturber, option

if TYPE_CHECKING:
    from roadlang.api import BatchRandom, RoadBatch
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Scale(Perturber):
    """Scale a closed road about its centroid; of other roads, the distance from their chord.

    With `over`, and in a network, points move along the normal of the road only.
    """

    name: ClassVar[str] = "scale"
    is_random: ClassVar[bool] = False
    factor: Number = option(
        minimum=0, help="1 leaves the road as it is; 0 makes an open road straight"
    )

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """Of a closed road (V, S, 2): all of it keeps its shape, and curvatures are divided by
        the factor. Else (V, S): `factor - 1` times how far each point is from the chord between
        the ends of the road (or of the interval `over`), along the normal."""
        import numpy as np

        if roads.closed and roads.interval is None:
            lever = roads.points - roads.points.mean(axis=1, keepdims=True)
            return np.asarray((np.reshape(self.factor, (-1, 1, 1)) - 1.0) * lever)
        sideways = (self._from_chord(roads) * roads.normal).sum(axis=-1)
        return np.atleast_2d((self.factor - 1.0) * sideways)

    def shortest_feature(self, length: float, closed: bool) -> Floats | float:
        """None but those of the road."""
        return float("inf")

    def _from_chord(self, roads: RoadBatch) -> Floats:
        """(V, S, 2) from the foot on the chord to the road."""
        import numpy as np

        points = roads.points
        low, high = (0.0, roads.stations[-1]) if roads.interval is None else roads.interval
        first = np.searchsorted(roads.stations, np.ravel(low)).clip(0, len(roads.stations) - 1)
        last = np.searchsorted(roads.stations, np.ravel(high), "right") - 1
        rows = np.arange(max(len(points), len(first), len(last)))
        many = np.broadcast_to(points, (len(rows), *points.shape[1:]))
        start = many[rows, np.broadcast_to(first, rows.shape)][:, None]
        chord = many[rows, np.broadcast_to(last, rows.shape)][:, None] - start
        square = np.maximum((chord * chord).sum(axis=-1, keepdims=True), 1e-12)
        share = ((many - start) * chord).sum(axis=-1, keepdims=True) / square
        return np.asarray(many - (start + share * chord))
