"""What controllers that decide now and then have decided holds until they decide again."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import pytest

from roadlang import testing
from roadlang.drive.controllers import python_controllers
from roadlang.ir.control import ControlBatch
from roadlang.plugins.discovery import load_registry
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.controlling.controller_groups import HELD, Group
from roadlang.simulation.controlling.driving import DriverGroup

ROW = """
road main {
  draw with segments { pieces: [straight(300m)] }
  width: 8m, lanes: 2, speed_limit: 50km/h
}
agent one is car on main at 5m { lane: -1, drive with traffic }
agent two is car on main at 30m { lane: -1, drive with traffic }
"""


def test_a_held_decision_keeps_the_line_that_it_moved_to() -> None:
    none = cast(Any, None)
    held = np.full((len(HELD), 2), np.nan)
    group = Group(0, none, np.arange(2), {}, None, [], np.full(2, -np.inf), held)
    offset, time = np.array([3.5]), np.array([2.0])
    agent = np.array([1])
    decided = ControlBatch(np.zeros(1), np.ones(1), line_offset=offset, line_time=time)
    group.hold(agent, decided, 0.0)
    later = group.last_decided(agent)
    assert later.line_offset is not None
    assert later.line_time is not None
    assert (later.line_offset[0], later.line_time[0], later.acceleration[0]) == (3.5, 2.0, 1.0)
    assert later.heading is None


def test_until_somebody_decides_anew_the_decision_is_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene, registry = testing.sample(ROW, 1)[0].record, load_registry()
    world = world_of([scene], {}, 0.02, 0.04)
    drivers = DriverGroup(world, [python_controllers(scene, registry)], 0.04)
    first = drivers.decide(world, world.poses)
    kept = first.steering.copy(), first.acceleration.copy()
    world.step(first.steering, first.acceleration, None, 2)
    first.acceleration[:] = 9.0  # it belongs to who asked
    with monkeypatch.context() as patched:
        patched.delattr(Group, "last_decided")  # not even that is asked for
        held = drivers.decide(world, world.poses)
    np.testing.assert_array_equal(held.steering, kept[0])
    np.testing.assert_array_equal(held.acceleration, kept[1])
    world.step(held.steering, held.acceleration, None, 4)
    new = drivers.decide(world, world.poses)
    assert (new.acceleration != kept[1]).any()
    drivers.restart(np.arange(2))
    again = drivers.decide(world, world.poses)
    assert (again.acceleration == new.acceleration).all()  # decided anew, at the same place
