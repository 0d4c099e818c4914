"""How fast agents begin is said by the kind of their first controller."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Control, Controller, InitialSpeed, Number, Observation, option
from roadlang.diagnostics.errors import DiagnosticError

ROAD = """
road main {
  draw with waypoints { points: [(0m, 0m), (100m, 0m), (130m, 30m), (130m, 130m)] }
  lanes: 2, speed_limit: 20m/s
}
"""
TOWN = '''
image plan from """
.....
#####
.....
""" { scale: 40m/px }
network town from plan { lanes: 2 }
'''


@dataclass(frozen=True)
class Hasty(Controller):
    """Its target is not called `speed`."""

    name: ClassVar[str] = "hasty"
    target: Number = option(12.0, help="m/s")

    def control(self, observation: Observation) -> Control:
        return Control(0.0, 0.0)

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.target, lateral_acceleration=2.0, deceleration=4.0)


@dataclass(frozen=True)
class Patient(Controller):
    """Does not say how fast it begins."""

    name: ClassVar[str] = "patient"
    speed: Number = option(12.0, help="m/s")

    def control(self, observation: Observation) -> Control:
        return Control(0.0, 0.0)


@dataclass(frozen=True)
class ByLimit(Hasty):
    """Goes by the speed limit."""

    name: ClassVar[str] = "by_limit"

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(None)


@dataclass(frozen=True)
class Wrong(Hasty):
    """Returns a number."""

    name: ClassVar[str] = "wrong"

    def initial_speed(self) -> Any:
        return 12.0


def begins(drive: str, at: str = "10m") -> float | None:
    text = f"{ROAD}\nagent ego is car on main at {at} {{ lane: -1, {drive} }}"
    (scene,) = testing.sample(text, 1, kinds=[Hasty, Patient, ByLimit, Wrong])
    speed: float | None = scene.record.agents[0].start_speed
    return speed


def test_a_controller_says_how_fast_its_agent_begins() -> None:
    assert begins("drive with hasty") == 12.0
    assert begins("drive with by_limit") == pytest.approx(20.0)
    assert begins("drive with hasty, start_speed: 3m/s") == 3.0
    assert begins("drive with hasty { target: 100 }", "90m") < 15.0  # type: ignore[operator]


def test_an_agent_stands_where_its_controller_says_nothing_or_waits() -> None:
    assert begins("drive with patient") == 0.0
    assert begins("drive with hasty { when: ego.speed > 1m/s }") == 0.0


@pytest.mark.parametrize(
    ("drive", "speed"),
    [
        ("", 0.0),
        ("drive with patient", 0.0),
        ("drive with hasty { target: 3, when: car[1].speed > 1m/s }", 0.0),
        ("drive with hasty { target: 3 }", 3.0),
    ],
)
def test_so_do_agents_and_groups_on_a_network(drive: str, speed: float) -> None:
    text = f"{TOWN}\nagent car is car on town at random {{ count: 2, {drive} }}"
    for scene in testing.sample(text, 2, kinds=[Hasty, Patient]):
        assert [actor.start_speed for actor in scene.record.agents] == [speed, speed]


def test_what_is_no_initial_speed_is_a_fault_of_the_plugin() -> None:
    with pytest.raises(DiagnosticError) as found:
        begins("drive with wrong")
    assert found.value.diagnostics[0].code == "RL474"


@pytest.mark.parametrize(
    ("parts", "says"),
    [
        (("fast",), "initial speeds as text, not as real numbers"),
        ((np.array([1.0, 2.0]),), "initial speeds of shape (2,), not a number"),
        ((-1.0,), "the initial speed -1.0"),
        ((float("nan"),), "the initial speed nan"),
        ((9.0, None), "lateral accelerations as None"),
        ((9.0, 3.0, "hard"), "decelerations as text"),
    ],
)
def test_an_initial_speed_of_anything_but_numbers(parts: tuple[Any, ...], says: str) -> None:
    @dataclass(frozen=True)
    class Odd(Patient):
        """Gives odd parts."""

        name: ClassVar[str] = "odd"

        def initial_speed(self) -> InitialSpeed:
            return InitialSpeed(*parts)

    text = f"{ROAD}\nagent ego is car on main at 10m {{ drive with odd }}"
    with pytest.raises(DiagnosticError) as found:
        testing.sample(text, 1, kinds=[Odd])
    assert found.value.diagnostics[0].code == "RL474"
    assert says in found.value.diagnostics[0].message


def test_a_group_of_none_has_no_start_speeds() -> None:
    scenes = testing.sample(
        """
        road main { draw with waypoints { points: [(0m, 0m), (400m, 0m)] } }
        agent others is car on main at 10m..300m {
          count: integer(0, 2), start_speed: 3m/s..5m/s
        }
        """,
        12,
    )
    assert {len(scene.record.agents) for scene in scenes} == {0, 1, 2}
    speeds = [actor.start_speed for scene in scenes for actor in scene.record.agents]
    assert all(speed is not None and 3.0 <= speed <= 5.0 for speed in speeds)


def test_traffic_begins_at_its_share_of_the_limit() -> None:
    assert begins("drive with traffic { speed_factor: 0.5 }") == pytest.approx(10.0)
    assert begins("drive with traffic { speed_factor: 0.5, speed: 12m/s }") == pytest.approx(12.0)


def test_who_follows_begins_so_slowly_that_it_can_keep_its_distance() -> None:
    text = """
    road main { draw with segments { pieces: [straight(300m)] }, lanes: 2, speed_limit: 90km/h }
    agent slow is tractor on main at 60m { drive with lane_follow { speed: 7m/s } }
    agent ego is car on main at behind(slow, 10m) { DRIVE }
    """
    for drive, most in (
        ("drive with car_follow", 7.0),
        ("drive with car_follow { speed: 6m/s }", 6.0),
        ("drive with car_follow, start_speed: 20m/s", 20.0),
    ):
        (scene,) = testing.sample(text.replace("DRIVE", drive), 1)
        speed = scene.record.agents[1].start_speed
        assert speed is not None
        assert 0.9 * most - 1.0 < speed <= most
