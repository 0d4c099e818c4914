"""What faults of the steering and of throttle and brakes share."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Controller, Duration, Flag, Number, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ActuationBatch


@dataclass(frozen=True)
class ActuatorFault(Controller):
    """Alters what all controllers of the agent decide, while it is active. It drives nothing
    itself; `when:` and `while:` say when it is active."""

    leaves_open: ClassVar[str] = "everything"

    delay: Duration = option(
        0.0, minimum=0, maximum=10, help="delay until commands act", example="200ms"
    )
    gain: Number = option(1.0, minimum=-10, maximum=10, help="factor: 0.5 halves every command")
    stuck: Flag = option(
        False, help="holds the command at which the fault began, for as long as it lasts"
    )

    def start(self, count: int) -> NDArray[np.object_]:
        """What was wanted, and where it is stuck."""
        from .faulty_actuator import first_state

        return first_state(count)

    def disturbed(
        self,
        wanted: NDArray[np.float64],
        at: ActuationBatch,
        state: Any,
        bias: float,
        noise: float,
    ) -> NDArray[np.float64]:
        """(N,) what the actuator does instead of what is `wanted` of it."""
        from .faulty_actuator import disturbed

        return disturbed(
            wanted, at, state, delay=self.delay, gain=self.gain, bias=bias, noise=noise,
            stuck=bool(self.stuck),
        )  # fmt: skip
