"""What a controller does with the arrays that it is given stays its own affair."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

import roadlang
from roadlang import testing
from roadlang.api import ControlBatch, Controller, Number, ObservationBatch, option

TEXT = """
road main { draw with segments { pieces: [straight(30m), arc(40m, 60deg)] }, lanes: 2 }
agent ego is car on main at 5m { start_speed: 5m/s, drive with keeper { unit: %s } }
simulate with builtin { duration: 3s }
"""


@dataclass(frozen=True)
class Keeper(Controller):
    """Keeps 5 m/s, reckoned in another unit."""

    name: ClassVar[str] = "keeper"
    unit: Number = option(1.0, help="of its speed")

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        speed = observations.speed
        speed *= self.unit
        steering = -0.1 * observations.cross_track_error - observations.heading_error
        return ControlBatch(steering, 5.0 - speed / self.unit)


def test_a_unit_that_is_converted_in_place_changes_no_drive() -> None:
    """Nor does it make a difference whether all agents are asked, as alone, or some."""
    plain, other = (
        testing.scenario(TEXT % unit, kinds=[Keeper]).sample(1)[0].run() for unit in (1, 4)
    )
    np.testing.assert_allclose(other.trace.agents["ego"].speed, plain.trace.agents["ego"].speed)
    assert plain.trace.agents["ego"].speed.min() > 2.0
    beside = TEXT % 4 + "agent other is car on main at 60m { lane: 1, drive with brake }"
    among = testing.scenario(beside, kinds=[Keeper]).sample(1)[0].run()
    np.testing.assert_array_equal(among.trace.agents["ego"].x, other.trace.agents["ego"].x)


@pytest.mark.filterwarnings("error")
def test_infinite_controls_are_an_error_and_no_warning_of_numpy() -> None:
    @dataclass(frozen=True)
    class Endless(Keeper):
        """Wants to be infinitely fast."""

        name: ClassVar[str] = "keeper"

        def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
            zero = np.zeros(len(observations.speed))
            return ControlBatch(zero, zero + np.inf)

    scene = testing.scenario(TEXT % 1, kinds=[Endless]).sample(1)[0]
    with pytest.raises(roadlang.DiagnosticError, match="not finite"):
        scene.run()
