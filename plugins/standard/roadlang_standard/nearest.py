"""Roads of different roots are compared by the nearest point of the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import RoadBatch

    Floats = NDArray[np.float64]


def nearest_distance(road: RoadBatch, other: RoadBatch) -> Floats:
    """(V, S) meters from each station of a road to the nearest point of another."""
    import numpy as np

    return np.stack([
        np.hypot(*(points - other.curves.curve(row % other.variants).at(s)).T)
        for row, points, s, _ in _projected(road, other)
    ])  # fmt: skip


def nearest_offset(road: RoadBatch, other: RoadBatch) -> Floats:
    """(V, S) meters that each station of a road lies beside another."""
    import numpy as np

    return np.stack([np.abs(offset) for _, _, _, offset in _projected(road, other)])


def nearest_lp_distance(road: RoadBatch, other: RoadBatch, p: float) -> Floats:
    """(V, 1) the L_p distance with the nearest points of another road."""
    import numpy as np

    gaps = nearest_distance(road, other)
    integral = np.trapezoid(gaps**p, road.stations, axis=1)
    return np.asarray(integral)[:, None] ** (1.0 / p)


def _projected(road: RoadBatch, other: RoadBatch) -> Iterator[tuple[int, Floats, Floats, Floats]]:
    """Row, points (S, 2), their places along the other road and beside it, for each variant."""
    count = max(road.variants, other.variants)
    for row in range(count):
        points = road.points[row % road.variants]
        s, offset = other.curves.curve(row % other.variants).project(points)
        yield row, points, s, offset
