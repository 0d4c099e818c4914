"""Steps of vehicles that come near no limit: fewer formulas, the same bytes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry.arrays import Floats
from roadlang.simulation.lanes.surfaces import TireSurface
from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.lines.lines import Lines
from roadlang.simulation.tapes.numpy_calls import TableRows
from roadlang.simulation.tapes.registers import aligned
from roadlang.simulation.vehicles.bodies import Bodies, Body
from roadlang.simulation.vehicles.free_steps import LATER, FreeSteps
from roadlang.simulation.vehicles.motion import Track
from roadlang.simulation.vehicles.vehicle_steps import columns_after

from .test_vehicle_dynamics import CAR

DT, STEPS = 0.02, 5
TURN = np.linspace(0.0, 1.5, 200)
ARC = LineSource(80.0 * TURN, 80.0 * np.sin(TURN), 80.0 - 80.0 * np.cos(TURN), TURN, 7.0)


class Agents:
    """Some cars on an arc. `motion`: (10, N), as of `Motion`; `wanted`: (2, N)."""

    def __init__(self, motion: Floats, wanted: Floats, friction: float) -> None:
        count = motion.shape[1]
        self.motion, self.wanted = motion, wanted
        self.track = Track.of(Lines.of([ARC], 0.0), np.zeros(count, dtype=np.int64))
        self.bodies = Bodies.of([CAR] * count, [TireSurface(friction)] * count, {"car": Body()}, DT)

    def expected(self) -> Floats:
        """The motion after the steps, by all formulas."""
        with np.errstate(all="ignore"):
            after = columns_after(
                [*self.motion],
                self.bodies.in_order,
                [*self.wanted],
                None,
                self.track.bend,
                STEPS,
                DT,
            )
        return np.array(after)

    def free(self, with_limits: Any, rows: Floats) -> FreeSteps:
        """The steps that fill `rows`."""
        columns = [*self.motion, *self.bodies.in_order, *self.wanted, *self.track.places]
        lines = TableRows.of(self.track.lines.table, self.track.first)
        return FreeSteps(columns, list(rows), [with_limits], lines, STEPS, DT)


@given(st.integers(0, 2**32 - 1), st.sampled_from([1, 2, 9]), st.sampled_from([0.1, 0.4, 0.9]))
def test_they_are_those_with_limits_wherever_an_agent_is(
    seed: int, count: int, friction: float
) -> None:
    draw = np.random.default_rng(seed)
    low = [0.0, -3.0, 0.0, -0.5, -0.4, 0.9, -0.3, -0.2, -0.1, -9.0]
    high = [110.0, 3.0, 40.0, 0.5, 0.4, 1.0, 0.3, 0.2, 0.1, 5.0]
    wide = draw.uniform(0.0, 1.5, (10, 1))  # some near a limit, most of them not
    motion = draw.uniform(low, high, (count, 10)).T
    motion[[1, 3, 4, 6, 7]] *= wide[[1, 3, 4, 6, 7]] * 0.3
    wanted = draw.uniform([-0.1, -7.0], [0.1, 4.0], (count, 2)).T
    agents = Agents(motion, wanted * draw.uniform(0.0, 1.2), friction)
    rows, expected = aligned(10, count), agents.expected()

    def with_limits() -> None:
        rows[:] = expected

    with np.errstate(all="ignore"):
        agents.free(with_limits, rows)()
    assert rows.tobytes() == expected.tobytes()


def cruising() -> tuple[Floats, Floats]:
    """Two cars that hold their lanes in the bend, at 15 m/s and 16 m/s."""
    motion, wanted = np.zeros((10, 2)), np.zeros((2, 2))
    motion[0], motion[2], motion[4], motion[5] = 20.0, (15.0, 16.0), 0.19, 1.0
    wanted[0] = motion[7] = 0.035
    return motion, wanted


NEAR = {
    "brakes": (1, -8.9), "engine": (1, 5.0), "steering": (0, 0.5),
}  # fmt: skip
STATES = {"slow": (2, 2.0), "slides": (3, 4.0), "nothing": (2, np.nan)}


def test_one_near_a_limit_is_enough_to_ask_for_all_formulas() -> None:
    made = []
    for wanted_of, state_of in ((None, None), *((name, None) for name in NEAR),
                                *((None, name) for name in STATES)):  # fmt: skip
        motion, wanted = cruising()
        if wanted_of:
            place, value = NEAR[wanted_of]
            wanted[place, 1] = value
        if state_of:
            place, value = STATES[state_of]
            motion[place, 1] = value
        made.append(0)

        def with_limits() -> None:
            made[-1] += 1

        agents = Agents(motion, wanted, 0.9)
        with np.errstate(all="ignore"):
            agents.free(with_limits, aligned(10, 2))()
    assert made == [0] + [1] * (len(NEAR) + len(STATES))


def test_after_that_nobody_asks_for_a_while() -> None:
    motion, wanted = cruising()
    wanted[1, 0] = -8.9
    made = []
    agents = Agents(motion, wanted, 0.9)
    rows = aligned(10, 2)
    steps = agents.free(lambda: made.append(1), rows)
    steps()
    wanted[1, 0] = 0.0
    for _ in range(LATER):
        steps()
    assert len(made) == 1 + LATER
    steps()
    assert len(made) == 1 + LATER
    assert rows.tobytes() == agents.expected().tobytes()


@pytest.mark.parametrize("speed", [15.0, 18.0])
def test_cars_in_a_bend_are_free(speed: float) -> None:
    motion, wanted = cruising()
    motion[2] = speed
    agents = Agents(motion, wanted, 0.9)
    rows = aligned(10, 2)

    def with_limits() -> None:
        raise AssertionError("far from any limit")

    agents.free(with_limits, rows)()
    assert rows.tobytes() == agents.expected().tobytes()
