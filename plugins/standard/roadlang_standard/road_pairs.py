"""Two roads compared: at shared stations if they have one root, else by the nearest point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from roadlang.api import RoadName, RoadNumber, geometry, option

if TYPE_CHECKING:
    from collections.abc import Iterator

    from roadlang.api import RoadBatch
    from roadlang.geometry import Floats


COMPARED = "road that is measured, at its stations"
OTHER = "road that it is compared with"


@dataclass(frozen=True)
class RoadPair(RoadNumber):
    """A number of two roads that cannot exceed how far they are apart."""

    road: RoadName = option(help=COMPARED)
    other: RoadName = option(help=OTHER)

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        """From 0 to what the displacements allow."""
        return 0.0, options["road"].apart(options["other"])


def distances(road: RoadBatch, other: RoadBatch) -> Floats:
    """(V, S) meters from each station of a road to the other road."""
    import numpy as np

    if road.root == other.root:
        return geometry.pointwise(road.curves, other.curves)
    return np.stack([
        np.hypot(*(points - other.curves.curve(row % other.variants).at(s)).T)
        for row, points, s, _ in _projected(road, other)
    ])  # fmt: skip


def offsets(road: RoadBatch, other: RoadBatch) -> Floats:
    """(V, S) meters across the other road from it to each station, zero or more."""
    import numpy as np

    if road.root == other.root:
        return np.abs(road.displacement - other.displacement)
    return np.stack([np.abs(offset) for _, _, _, offset in _projected(road, other)])


def _projected(road: RoadBatch, other: RoadBatch) -> Iterator[tuple[int, Floats, Floats, Floats]]:
    """Row, points (S, 2), their places along the other road and beside it, for each variant."""
    for row in range(max(road.variants, other.variants)):
        points = road.points[row % road.variants]
        s, offset = other.curves.curve(row % other.variants).project(points)
        yield row, points, s, offset
