"""Agents that arrive at the end of their road or route leave: nobody sees or touches them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.scene import Scene
from roadlang.simulation.world_building import world_of

from .crossing_traffic import before_junction, contacts, entries
from .routed_scenes import CROSSING, call, car, drive_scenes, network_scene, route

ROW = """
road main { draw with segments { pieces: [straight(100m)] }, lanes: 2, speed_limit: 50km/h }
agent cars is car on main at 40m { count: 3, spacing: 12m, drive with KIND }
agent lead is car on main at 78m { drive with KIND }
agent walker is pedestrian on main at 100m { side: right, offset: 1m }
expect apart: always (distance(cars, lead) > 5m)
"""


def driven(kind: str) -> Any:
    return testing.sample(ROW.replace("KIND", kind), 1).run("builtin", duration=15.0)


@pytest.mark.parametrize("kind", ["traffic", "lane_follow { speed: 36km/h }"])
def test_a_row_of_cars_leaves_one_after_another(kind: str) -> None:
    ((one,)) = driven(kind)
    trace = one.trace
    assert contacts(trace) == []
    rows = [trace.agents[name] for name in ("cars[0]", "cars[1]", "cars[2]", "lead")]
    left = [float(row.time[row.present.argmin()]) for row in rows]
    assert left == sorted(left, reverse=True)
    for row in rows:
        assert row.present[-1] == 0.0
        assert row.progress[row.present.argmin()] == 1.0
        assert (row.present[row.progress < 1.0] == 1.0).all()


def test_who_begins_at_the_end_of_its_road_stays() -> None:
    ((one,)) = driven("traffic")
    assert (one.trace.agents["walker"].present == 1.0).all()


def test_the_distance_to_who_has_left_is_infinite() -> None:
    ((one,)) = driven("traffic")
    trace = one.trace
    last, lead = trace.agents["cars[2]"], trace.agents["lead"]
    apart = np.hypot(lead.x - last.x, lead.y - last.y)
    there = lead.present > 0.0
    assert apart[~there].min() < 5.0 < apart[there].min()
    assert one.verdicts["apart"].robustness == pytest.approx(apart[there].min() - 5.0, abs=1e-6)


def queue_to_the_end() -> Scene:
    """Cars one behind another whose routes end in the middle of the road beyond a crossing."""
    scene = network_scene(CROSSING, "lanes: 2, speed_limit: 50km/h")
    road, lane = entries(scene)[0]
    agents = []
    for number in range(5):
        start = before_junction(scene, road, lane, 10.0 + 9.0 * number)
        path = route(scene, road, lane, start, ["straight"])
        last = path.steps[-1]
        way = 1.0 if last.stop > last.start else -1.0
        path = replace(path, steps=(*path.steps[:-1], replace(last, stop=last.start + 8.0 * way)))
        agents.append(car(scene, f"car{number}", path, drive=call("traffic")))
    return replace(scene, agents=tuple(agents))


def test_a_route_that_ends_on_the_road_is_no_obstacle_to_others() -> None:
    (trace,) = drive_scenes([queue_to_the_end()], duration=30.0)
    assert contacts(trace) == []
    assert all(agent.present[-1] == 0.0 for agent in trace.agents.values())


def test_a_world_that_is_reset_has_everybody_again() -> None:
    world = world_of([queue_to_the_end()], {}, 0.02, 0.1)
    world.motion.speed = np.full(5, 20.0)
    zero = np.zeros(5)
    for _ in range(60):
        world.step(zero, zero, None, 5)
    assert not world.present.all()
    world.restart(np.arange(5))
    assert world.present.all()
    for _ in range(60):
        world.motion.speed = np.full(5, 20.0)
        world.step(zero, zero, None, 5)
    world.reset()
    assert world.present.all()
    assert world.time == 0.0


def test_on_a_closed_road_nobody_leaves() -> None:
    text = """
    road ring { draw with segments { pieces: [arc(20m, 180deg), arc(20m, 180deg)] }, closed: true }
    agent ego is car on ring at 0m { drive with lane_follow { speed: 36km/h } }
    agent other is car on ring at 60m { drive with lane_follow { speed: 36km/h } }
    """
    ((one,)) = testing.sample(text, 1).run("builtin", duration=50.0)
    assert one.trace.agents["ego"].progress[-1] == 1.0
    assert all((agent.present == 1.0).all() for agent in one.trace.agents.values())


def test_encroachment_remembers_who_has_left() -> None:
    from roadlang_standard.drive_signals_conflict import PostEncroachmentTime

    time = np.arange(0.0, 6.0, 0.1)
    zero = np.zeros(len(time))
    first = testing.agent_trace(
        "first", time=time, x=10.0 * time - 20.0, y=zero, heading=zero, speed=10.0, length=4.0,
        width=2.0, present=np.where(time < 4.0, 1.0, 0.0),
    )  # fmt: skip
    second = testing.agent_trace(
        "second", time=time, x=zero, y=10.0 * time - 40.0, heading=zero + math.pi / 2,
        speed=10.0, length=4.0, width=2.0, present=zero + 1.0,
    )  # fmt: skip
    values = PostEncroachmentTime(first, second).values()
    assert np.isinf(values[:10]).all()
    everybody = replace(first, present=zero + 1.0)
    there = PostEncroachmentTime(everybody, second).values()
    assert values[38] == there[38]
    assert (np.diff(values[np.isfinite(values)]) <= 0.0).all()
