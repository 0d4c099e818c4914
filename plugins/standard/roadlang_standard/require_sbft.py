"""`require N with sbft`: a road by the rules of the SBFT tool competition."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Flag, Length, Monitor, RoadName, option

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy as np
    from numpy.typing import NDArray

    from roadlang.geometry import Floats


@dataclass(frozen=True)
class SbftMonitor(Monitor):
    """Whether the SBFT tool competition (cyber-physical systems track) would accept the road.

    Its robustness is in meters: the least of the distance of the road, 8 m wide, from the edge of
    the map, the gap between its parts, and what its least radius is above 14.33 m and its length
    above 20 m, after the interpolation that the competition uses.
    """

    name: ClassVar[str] = "sbft"
    domain: ClassVar[str] = "road"
    road: RoadName = option(help="the road")
    spacing: Length = option(
        5.0, minimum=1, maximum=50, help="distance between the points that `emit sbft` writes"
    )
    size: Length = option(200.0, minimum=50, maximum=10000, help="width and height of the map")
    centered: Flag = option(True, help="moved to the middle of the map, as `emit sbft` does")

    def robustness(self) -> Floats:
        import numpy as np

        from .sbft.rules import judged

        out = np.empty(self.road.variants)
        for rows, found in self._points():
            out[rows] = judged(found, self._size).robustness
        return out

    def reason(self) -> str | None:
        from .sbft.broken_rules import broken_rules

        first = next((found[rows == 0] for rows, found in self._points() if (rows == 0).any()))
        return broken_rules(first, self._size, self.centered)

    @property
    def _size(self) -> float:
        import numpy as np

        return float(np.ravel(self.size)[0])

    def _points(self) -> Iterator[tuple[NDArray[np.int64], Floats]]:
        """As `road_points`."""
        import numpy as np

        from .sbft.road_points import road_points

        road = self.road
        shape = (road.variants, *road.points.shape[1:])
        points = np.broadcast_to(road.points, shape)
        heading = np.broadcast_to(road.heading, shape[:2])
        spacing = float(np.ravel(self.spacing)[0])
        return road_points(points, heading, spacing, self._size, self.centered)
