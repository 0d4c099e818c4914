"""`drive with walk`: along the road, on the sidewalk or at the edge."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Controller, InitialSpeed, Length, Speed, Word, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Floats

LOOKAHEAD = 2.0
"""Meters ahead in which who walks wants to be where it should be."""


@dataclass(frozen=True)
class Walk(Controller):
    """Walk along the road, in the direction that the agent faces: on the nearest sidewalk, or
    beside the edge of the road where there is none."""

    name: ClassVar[str] = "walk"
    speed: Speed = option(1.4, above=0, maximum=20, help="walking speed")
    along: Word = option(
        "sidewalk",
        words=("sidewalk", "edge"),
        help="whether to walk on the sidewalk or beside the edge of the lanes for vehicles",
    )
    beyond: Length = option(
        0.5, minimum=-10, maximum=20, help="distance from the edge, where it walks beside that"
    )

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.speed)

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: how far left of the line it walks, NaN before the start."""
        import numpy as np

        return np.full(count, np.nan)

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        if np.isnan(state).any():
            state[:] = np.where(np.isnan(state), self._place(seen), state)
        _, _, along, _ = seen.line_ahead(0.0)
        heading = along + np.arctan((state - seen.road_offset) / LOOKAHEAD)
        acceleration = (self.speed - seen.speed) / seen.step
        zero = np.zeros(len(state))
        return ControlBatch(zero, acceleration, heading, line_offset=state.copy())

    def _place(self, seen: ObservationBatch) -> Floats:
        """(N,) how far left of the line to walk."""
        import numpy as np

        side = np.where(seen.road_offset < 0.0, -1.0, 1.0)
        edge = side * (0.5 * seen.road_width + self.beyond)
        place = np.where(np.isfinite(edge), edge, seen.road_offset)
        if self.along == "edge":
            return place
        sidewalk = seen.offset_of_lane("sidewalk")
        return np.where(np.isfinite(sidewalk), sidewalk, place)
