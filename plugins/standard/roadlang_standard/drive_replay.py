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
    also_called: ClassVar[tuple[str, ...]] = ("trajectory", "follow_trajectory", "recording")
    file: File = option(
        help="CSV file with the columns time (s), x, y (m), heading (rad) and, if there is one, "
        "speed (m/s); or with time, steering (rad) and acceleration (m/s^2); or a trace of "
        "`roadlang run`",
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

        from .recorded_inputs import recorded_inputs
        from .recorded_poses import recording

        seen = observations
        state[:] = np.where(np.isnan(state), seen.time, state)
        count = len(state)
        pose, wanted = np.full((count, 4), np.nan), np.full((count, 2), np.nan)
        inputs = recorded_inputs(self.file)
        for row, (name, since) in enumerate(zip(seen.agent, seen.time - state, strict=True)):
            if inputs is not None:
                wanted[row] = inputs.at(float(since), float(seen.step))
            else:
                recorded = recording(self.file, self.agent or str(name))
                pose[row] = recorded.at(float(since + seen.step))
        return ControlBatch(wanted[:, 0], wanted[:, 1], pose=pose)
