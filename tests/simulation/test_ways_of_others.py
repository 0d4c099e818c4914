"""Who may come the other way on a stretch, and what would be touched on a line that moves."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry import Floats
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.observing.observing import View
from roadlang.simulation.observing.surroundings import Surroundings
from roadlang.simulation.state.world import World

CROSSING = '''
image plan from """
....#....
....#....
#########
....#....
....#....
""" {{ scale: 20m/px, legend: {{ "#": road }} }}
network town from plan {{ lanes: 2, speed_limit: 50km/h }}
agent ego is car on town {{ route: [(10m, 50m), (170m, 50m)], drive with traffic }}
agent other is car on town {{ route: [{route}], drive with traffic, {speed} }}
{more}
'''
OPPOSITE = 3.5
"""Meters to the left: the middle of the oncoming lane."""


def view_of(text: str) -> tuple[World, View]:
    world = world_of([testing.sample(text)[0].record], {}, 0.02, 0.1)
    return world, View(world, world.poses, 0.1, Surroundings(world))


def seconds(route: str, speed: str = "start_speed: 10m/s", more: str = "") -> float:
    """Until the other is on the 50 m ahead of the ego."""
    _, view = view_of(CROSSING.format(route=route, speed=speed, more=more))
    seen = view.of(np.arange(2))
    found: Floats = seen.comes_toward(np.array([OPPOSITE, np.nan]), np.array([50.0, np.nan]))
    return float(found[0])


@pytest.mark.parametrize("route", ["(90m, 90m), (10m, 50m)", "(90m, 10m), (10m, 50m)"])
def test_who_will_turn_into_the_road_comes_the_other_way(route: str) -> None:
    assert 2.0 < seconds(route) < 9.0


@pytest.mark.parametrize("route", ["(90m, 90m), (170m, 50m)", "(90m, 90m), (90m, 10m)"])
def test_who_takes_another_road_does_not(route: str) -> None:
    assert seconds(route) == np.inf


def test_who_stands_is_expected_to_gain_speed() -> None:
    moving, standing = (seconds("(90m, 90m), (10m, 50m)", f"start_speed: {v}m/s") for v in (10, 0))
    assert moving < standing < 15.0


def test_who_stands_before_an_object_of_its_own_waits_in_turn_with_the_other() -> None:
    parked = "object parked is parked_car at (88.2m, 75m) { heading: 90deg }"
    assert seconds("(90m, 90m), (10m, 50m)", "start_speed: 0m/s", parked) == np.inf


STREET = """
road street { draw with segments { pieces: [straight(200m)] }, lanes: 2, width: 7m }
agent ego is car on street at 50m { lane: -1, start_speed: 8m/s, drive with traffic }
object parked is parked_car on street at AT { lane: -1 }
"""


@pytest.mark.parametrize(("at", "touches"), [("64m", True), ("85m", False)])
def test_a_line_that_moves_too_late_touches_what_it_is_to_pass(at: str, touches: bool) -> None:
    """In three seconds the line is 3.5 m farther left: 24 m on."""
    world, view = view_of(STREET.replace("AT", at))
    world.followed.move(np.array([1.75]), np.array([3.0]), world.motion.along, world.motion.speed)
    everyone, nobody = np.array([True]), np.array([False])
    gap = float(view.of(np.arange(1)).touches_ahead(everyone, nobody)[0])
    assert (gap < 13.0) if touches else (gap == np.inf)
