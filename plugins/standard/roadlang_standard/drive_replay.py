"""`drive with replay`: as a recording has it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Controller, File, String, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch


@dataclass(frozen=True)
class Replay(Controller):
    """Follow a recording exactly, from the moment it takes over; the agent does not react to
    anything. After the end of the recording it stands still."""

    name: ClassVar[str] = "replay"
    file: File = option(
        help="CSV file with the columns time (s), x, y (m), heading (rad) and, if there is one, "
        "speed (m/s); or a trace of `roadlang run`",
        example='"recorded.csv"',
    )
    agent: String = option("", help="agent in the file; by default the one with this agent's name")

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: when it took over, NaN before."""
        import numpy as np

        return np.full(count, np.nan)

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        from .recorded_poses import recording

        seen = observations
        state[:] = np.where(np.isnan(state), seen.time, state)
        pose = np.stack(
            [
                recording(self.file, self.agent or str(name)).at(float(later))
                for name, later in zip(seen.agent, seen.time + seen.step - state, strict=True)
            ]
        )
        open_ = np.full(len(pose), np.nan)
        return ControlBatch(open_, open_, pose=pose)
