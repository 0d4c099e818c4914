"""`drive with steering_fault`: the steering does not do what controllers want."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Angle, option

from .actuator_fault import ActuatorFault

if TYPE_CHECKING:
    from roadlang.api import ActuationBatch


@dataclass(frozen=True)
class SteeringFault(ActuatorFault):
    """A steering fault: the steering commands of the agent's controllers act late, wrong or not at
    all. It does not drive itself; `when:` and `while:` say when it is active."""

    name: ClassVar[str] = "steering_fault"

    bias: Angle = option(0.0, minimum=-1.5, maximum=1.5, help="constant error", example="2deg")
    noise: Angle = option(
        0.0, minimum=0, maximum=1.5, help="standard deviation of random errors, new at each step"
    )

    def altered(self, wanted: ActuationBatch, state: Any) -> Any:
        found = self.disturbed(wanted.steering, wanted, state, self.bias, self.noise)
        return found, wanted.acceleration
