"""A controller and a judge of its own, brought to roadlang by a plugin."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from roadlang.api import (
    AgentName,
    Control,
    Controller,
    Duration,
    File,
    Flag,
    Jerk,
    Monitor,
    Number,
    Observation,
    Trace,
    hookimpl,
    list_of,
    option,
)


@dataclass(frozen=True)
class Mpc(Controller):
    """Steer toward where the road will be, weighing error, heading and effort."""

    name: ClassVar[str] = "mpc"
    horizon: Duration = option(2.0, above=0, maximum=20, help="how far ahead it plans")
    weights: list_of(Number, at_least=3) = option(  # type: ignore[valid-type]
        (1.0, 0.5, 20.0), minimum=0, help="of cross-track error, heading error and effort"
    )
    model: File = option(None, help="a network that predicts the vehicle")
    verbose: Flag = option(False, help="say what it does")

    def control(self, observation: Observation) -> Control:
        """One step of the plan: the error decays over the horizon."""
        error, heading, effort = self.weights[:3]
        pull = error * observation.cross_track_error / max(observation.speed * self.horizon, 1.0)
        return Control(-(pull + heading * observation.heading_error) / (1 + effort / 20), 0.0)


@dataclass(frozen=True)
class RideComfort(Monitor):
    """The ride is comfortable while jerk stays below a limit."""

    name: ClassVar[str] = "ride_comfort"
    domain: ClassVar[str] = "drive"
    agent: AgentName = option(help="whose ride")
    limit: Jerk = option(2.5, above=0, help="greatest jerk that is still comfortable")

    def judge(self, trace: Trace) -> float:
        """The limit minus the greatest jerk."""
        ride = trace.agents[getattr(self.agent, "name", str(self.agent))]
        jerk = np.gradient(ride.acceleration, trace.time)
        return float(self.limit - np.abs(jerk).max())


@hookimpl
def roadlang_kinds() -> list[type]:
    """What this plugin brings."""
    return [Mpc, RideComfort]
