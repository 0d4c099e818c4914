"""`drive with throttle_fault`: throttle and brakes do not do what controllers want."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Acceleration, option

from .actuator_fault import ActuatorFault

if TYPE_CHECKING:
    from roadlang.api import ActuationBatch


@dataclass(frozen=True)
class ThrottleFault(ActuatorFault):
    """A fault of throttle and brakes: the commands of the agent's controllers act late, wrong or
    not at all. It does not drive itself; `when:` and `while:` say when it is active."""

    name: ClassVar[str] = "throttle_fault"

    bias: Acceleration = option(
        0.0, minimum=-50, maximum=50, help="constant error", example="-0.5m/s^2"
    )
    noise: Acceleration = option(
        0.0, minimum=0, maximum=50, help="standard deviation of random errors, new at each step"
    )

    def altered(self, wanted: ActuationBatch, state: Any) -> Any:
        found = self.disturbed(wanted.acceleration, wanted, state, self.bias, self.noise)
        return wanted.steering, found
