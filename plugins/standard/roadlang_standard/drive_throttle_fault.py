"""`drive with throttle_fault`: throttle and brakes does not do what controllers want."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Acceleration, Controller, Duration, Flag, Number, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ActuationBatch


@dataclass(frozen=True)
class ThrottleFault(Controller):
    """A fault of throttle and brakes: what all controllers of the agent decide comes late, is
    wrong or stuck. It drives nothing itself; `when:` and `while:` say when it is there."""

    name: ClassVar[str] = "throttle_fault"
    leaves_open: ClassVar[str] = "everything"

    delay: Duration = option(0.0, minimum=0, maximum=10, help="how late it acts", example="200ms")
    gain: Number = option(
        1.0, minimum=-10, maximum=10, help="factor: 0.5 does half of what is wanted"
    )
    bias: Acceleration = option(
        0.0, minimum=-50, maximum=50, help="constant error", example="-0.5m/s^2"
    )
    noise: Acceleration = option(
        0.0, minimum=0, maximum=50, help="standard deviation of errors, anew at each step"
    )
    stuck: Flag = option(
        False, help="it stays as it is when the fault begins, for as long as the fault is there"
    )

    def start(self, count: int) -> NDArray[np.object_]:
        """What was wanted, and where it is stuck."""
        from .faulty_actuator import first_state

        return first_state(count)

    def altered(self, wanted: ActuationBatch, state: Any) -> Any:
        from .faulty_actuator import disturbed

        found = disturbed(
            wanted.acceleration, wanted, state, delay=self.delay, gain=self.gain, bias=self.bias,
            noise=self.noise, stuck=bool(self.stuck),
        )  # fmt: skip
        return wanted.steering, found
