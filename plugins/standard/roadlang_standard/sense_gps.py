"""`sense with gps`: where the agent is, with errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Length, Point, ReadingArray, Sensor, option

from .error_walks import walked

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import SensedBatch


@dataclass(frozen=True)
class Gps(Sensor):
    """A satellite receiver: the position of the agent's center."""

    name: ClassVar[str] = "gps"

    noise: Length = option(
        1.0,
        minimum=0,
        maximum=1000,
        help="standard deviation of x and of y, independent for each reading",
    )
    bias: Point = option(
        (0.0, 0.0),
        help="constant error, meters east and north; `..` draws one for each scene",
        example="(-2m..2m, -2m..2m)",
    )
    walk: Length = option(
        0.0,
        minimum=0,
        maximum=1000,
        help="drift of the error in a second: standard deviation of a random walk of x and of y",
        example="0.1m",
    )

    def arrays(self) -> dict[str, ReadingArray]:
        """Meters east and north."""
        return {"x": ReadingArray(unit="m"), "y": ReadingArray(unit="m")}

    def start(self, count: int) -> NDArray[np.float64]:
        """The errors that wander, of x and y."""
        import numpy as np

        return np.zeros((count, 2))

    def readings(self, sensed: SensedBatch, state: Any) -> dict[str, NDArray[np.float64]]:
        import numpy as np

        numbers = sensed.random.normal(4)
        bias: Any = self.bias  # (N, 2) here
        state += walked(sensed, self.walk, numbers[:, :2])
        noise = np.asarray(self.noise)[..., None] * numbers[:, 2:]
        error = bias + state + noise
        return {"x": sensed.seen.x + error[:, 0], "y": sensed.seen.y + error[:, 1]}
