"""`drive with onnx`: a policy network drives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import (
    Acceleration,
    Angle,
    Controller,
    File,
    Integer,
    Length,
    ListOf,
    option,
)

if TYPE_CHECKING:
    from roadlang.api import ControlBatch, ObservationBatch

MOST_AGENTS = 100


@dataclass(frozen=True)
class OnnxController(Controller):
    """A policy network in an ONNX file, float32 (1, F) to (1, 2): its input is the observation
    vector of environments, its output their actions, steering and acceleration. Inputs called
    SENSOR.ARRAY, such as `front.distances`, get readings of the agent's sensors.
    """

    name: ClassVar[str] = "onnx"
    also_called: ClassVar[tuple[str, ...]] = ("neural_network", "torch", "pytorch")
    model: File = option(help="ONNX file; needs onnxruntime: `pip install roadlang[onnx]`")
    distances: ListOf[Length] = option(
        (5.0, 10.0, 20.0, 30.0, 50.0), help="distances ahead at which it observes the path"
    )
    agents: Integer = option(
        4, minimum=0, maximum=MOST_AGENTS, help="number of other agents it observes"
    )
    steering: Angle = option(
        None,
        above=0,
        maximum=1.5,
        help="steering angle for an output of 1; by default as far as the agent can steer",
        example="35deg",
    )
    acceleration: Acceleration = option(
        4.0, above=0, maximum=20, help="acceleration for an output of 1"
    )
    deceleration: Acceleration = option(
        8.0, above=0, maximum=20, help="deceleration for an output of -1"
    )

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch, ObservationVector

        from .policy_network import policy

        # What a network sees is the same for all that it drives.
        rows = np.atleast_2d(np.asarray(self.distances, dtype=np.float64))
        distances = tuple(rows[0].tolist())
        agents = int(np.ravel(self.agents)[0])
        vectors = ObservationVector(distances, agents).of(observations)
        network = policy(self.model)
        help_ = _agents_of(network.width, distances)
        wanted = network.wanted(vectors, observations.sensors, help_)
        most = observations.max_steering if self.steering is None else self.steering
        scale = np.where(wanted[:, 1] < 0.0, self.deceleration, self.acceleration)
        return ControlBatch(wanted[:, 0] * most, wanted[:, 1] * scale)


def _agents_of(width: int | None, distances: tuple[float, ...]) -> tuple[str, ...]:
    """Help: the number of other agents with which a network of that width fits, if one does."""
    from roadlang.api import ObservationVector

    alone, one = (len(ObservationVector(distances, agents).names) for agents in (0, 1))
    agents, rest = divmod((width or 0) - alone, one - alone)
    fits = rest == 0 and 0 <= agents <= MOST_AGENTS
    return (f"the network fits with `agents: {agents}`",) if fits else ()
