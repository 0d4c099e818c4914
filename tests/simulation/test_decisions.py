"""What a controller leaves open is decided by the one before; what it moves, stays moved."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import (
    Acceleration,
    Control,
    ControlBatch,
    Controller,
    Duration,
    Length,
    Observation,
    ObservationBatch,
    Speed,
    option,
)
from roadlang.ir.trace import AgentTrace


@dataclass(frozen=True)
class Aside(Controller):
    """Moves the line, and leaves all else to the controller before."""

    name: ClassVar[str] = "aside"
    by: Length = option(help="to here")
    time: Duration = option(4.0, help="of the move")

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        open_ = np.full(len(observations.x), np.nan)
        target, time = np.broadcast_arrays(self.by, self.time, open_)[:2]
        return ControlBatch(open_, open_, line_offset=target, line_time=time)


@dataclass(frozen=True)
class Gas(Controller):
    """Accelerates, and does not steer."""

    name: ClassVar[str] = "gas"
    rate: Acceleration = option(help="all the time")

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        count = len(observations.x)
        return ControlBatch(np.full(count, np.nan), np.zeros(count) + self.rate)


@dataclass(frozen=True)
class Alone(Controller):
    """Decides for one agent: moves the line once it sees that it is fast."""

    name: ClassVar[str] = "alone"
    speed: Speed = option(help="from here on")

    def control(self, observation: Observation) -> Control:
        left = 2.0 if observation.speed > self.speed else float("nan")
        steering = -0.5 * observation.heading_error - 0.05 * observation.cross_track_error
        return Control(steering, 1.0, line_offset=left, line_time=3.0)


@dataclass(frozen=True)
class Looks(Controller):
    """Brakes before what stands in its way."""

    name: ClassVar[str] = "looks"

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        free = np.isinf(observations.obstacle_ahead())
        return ControlBatch(np.zeros(len(free)), np.where(free, 1.0, -1.0))


KINDS = [Aside, Gas, Alone, Looks]
ROAD = "road main { draw with waypoints { points: [(0m, 0m), (900m, 0m)] }, width: 12m }\n"


def ego(drives: str, **options: Any) -> AgentTrace:
    text = ROAD + "agent ego is car on main at 5m { lane: none, start_speed: 20m/s, " + drives + "}"
    scenes = testing.sample(text, kinds=KINDS).run("builtin", **options)
    return next(iter(scenes)).trace.agents["ego"]


KEEPERS = {"lane_follow": "", "pure_pursuit": "lookahead: 6m, ", "stanley": "", "car_follow": ""}


@pytest.mark.parametrize("keeper", KEEPERS)
def test_a_lane_change_has_the_peaks_of_its_quintic_whoever_steers(keeper: str) -> None:
    car = ego(
        f"drive with {keeper} {{ {KEEPERS[keeper]}speed: 20m/s }}\n"
        "drive with aside { by: 3.5m, when: time > 2s }", duration=14, control_step=0.04
    )  # fmt: skip
    assert car.y[-1] == pytest.approx(3.5, abs=0.1)
    assert car.y.max() < 3.7
    sideways = np.gradient(car.y, car.time)
    assert 1.0 < sideways.max() / (1.875 * 3.5 / 4.0) < 1.2
    lateral = np.gradient(sideways, car.time)
    assert 0.97 < np.abs(lateral).max() / (5.774 * 3.5 / 16.0) < 1.6  # a car swings a little
    assert np.abs(car.cross_track_error).max() < 0.25
    assert np.abs(car.speed - 20).max() < 0.8  # left to the controller before


def test_what_stands_beside_its_old_line_is_seen_as_soon_as_the_line_is_moved() -> None:
    others = "agent other is car on main at 200m { lane: none, drive with looks }\n"
    car = ego(
        "drive with looks\n drive with aside { by: 4m, time: 0s }\n}\n"
        + others
        + "object crate is box on main at 60m { offset: 4m",
        duration=0.2,
        step=0.02,
        control_step=0.1,
    )
    assert car.speed[1] < car.speed[0]


def test_steering_and_acceleration_are_left_open_one_by_one() -> None:
    car = ego(
        """drive with lane_follow { speed: 20m/s }
           drive with gas { rate: 1m/s^2, when: time > 2s }
           drive with aside { by: 2m, when: time > 4s }""",
        duration=10,
    )
    assert car.speed[car.time < 2].max() < 20.2
    late = (car.time > 4.5) & (car.time < 9.5)  # `aside` is in charge; `gas` still accelerates
    assert np.gradient(car.speed, car.time)[late].mean() == pytest.approx(0.8, abs=0.25)
    assert car.y[-1] == pytest.approx(2.0, abs=0.05)  # and `lane_follow` steers


def test_where_nobody_steers_it_follows_its_line_and_where_nobody_accelerates_it_rolls() -> None:
    car = ego("drive with aside { by: 2m }", duration=5)
    assert car.y[-1] == pytest.approx(2.0, abs=0.1)
    assert 17 < car.speed[-1] < 20  # it rolls


def test_the_line_stays_where_it_was_moved_for_later_controllers() -> None:
    car = ego(
        """drive with lane_follow { speed: 20m/s }
           drive with aside { by: 2m, while: time < 3s }
           drive with brake { when: time > 8s }""",
        duration=15,
    )
    after = car.time > 6
    assert car.y[after] == pytest.approx(np.full(after.sum(), 2.0), abs=0.1)
    assert car.speed[-1] == 0.0


def test_a_controller_for_one_agent_moves_the_line_too() -> None:
    car = ego(
        """drive with alone { speed: 21m/s }
           drive with lane_follow { speed: 25m/s, when: time > 6s }""",
        duration=12,
    )
    assert car.y[-1] == pytest.approx(2.0, abs=0.05)


def test_a_drive_with_moves_is_the_same_alone_and_beside_others() -> None:
    text = (
        ROAD
        + """
    agent ego is car on main at 5m..60m {
      lane: none, start_speed: 15m/s
      drive with lane_follow { speed: (10m/s)..(25m/s) }
      drive with aside { by: -3m..3m, time: 2s..5s, when: time > 1s }
    }
    """
    )
    scenes = testing.sample(text, 4, kinds=KINDS)
    together = [one.trace.agents["ego"] for one in scenes.run("builtin", duration=9)]
    for number, trace in enumerate(together):
        (alone,) = [scenes[number].run("builtin", duration=9).trace.agents["ego"]]
        assert alone.y.tobytes() == trace.y.tobytes()
        assert alone.cross_track_error.tobytes() == trace.cross_track_error.tobytes()
