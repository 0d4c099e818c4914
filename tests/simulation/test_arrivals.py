"""Agents that arrive at the end of their road or route leave: nobody sees or touches them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.scene import Scene
from roadlang.simulation.building.world_building import world_of

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
    return testing.sample(ROW.replace("KIND", kind), 1).run(
        "builtin", duration=15.0, control_step=0.1
    )


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


LOOSE = "agent NAME is car at (0m, PLACE) { drive with lane_follow { speed: 5m/s } }\n"


@pytest.mark.parametrize("count", [1, 2])
def test_where_nobody_is_on_a_road_time_ends_the_drive(count: int) -> None:
    cars = [LOOSE.replace("NAME", f"car{i}").replace("PLACE", f"{9 * i}m") for i in range(count)]
    ((one,)) = testing.sample("".join(cars), 1).run("builtin", duration=3.0)
    assert one.trace.agents["car0"].time[-1] == pytest.approx(3.0)
    assert one.trace.agents["car0"].x[-1] > 5.0


def test_who_is_on_no_road_does_not_hold_up_the_end() -> None:
    text = ROW.replace("KIND", "lane_follow { speed: 36km/h }") + LOOSE.replace(
        "NAME", "other"
    ).replace("PLACE", "50m")
    ((one,)) = testing.sample(text, 1).run("builtin", duration=30.0)
    assert one.trace.agents["other"].time[-1] < 12.0


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
    ((one,)) = testing.sample(text, 1).run("builtin", duration=20.0, control_step=0.1)
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


LEAVER = """
road main { draw with segments { pieces: [straight(60m), arc(40m, 30deg)] }, lanes: 2 }
agent ego is car on main at 10m { start_speed: 40km/h, drive with lane_follow { speed: 60km/h } }
agent witness is car on main at 0m {
  drive with stop_at { distance: 0m }
  drive with lane_follow { speed: 20km/h, when: ego.speed < 5m/s }
}
expect comes_to_rest: eventually (ego.speed < 1m/s)
expect moves: always (ego.speed > 30km/h and ego.acceleration > -2m/s^2)
expect calm: always (abs(ego.jerk) < 15m/s^3 and abs(ego.yaw_rate) < 40deg/s)
"""


def test_what_is_known_of_who_has_left_stays_as_it_was() -> None:
    ((one,)) = testing.sample(LEAVER, 1).run("builtin", duration=10.0, control_step=0.1)
    ego = one.trace.agents["ego"]
    left = ego.samples_there
    assert 0 < left < len(ego.time) - 20
    assert ego.speed[left] > 12.0
    constant = ("x", "y", "heading", "speed", "steering", "station", "cross_track_error",
                "progress", "route_progress", "off_road", "lane_offset")  # fmt: skip
    for name in constant:
        values = getattr(ego, name)[left:]
        assert (values == values[0]).all(), name
    assert (ego.acceleration[left:] == ego.acceleration[left - 1]).all()
    assert ego.acceleration[left - 1] == pytest.approx(ego.acceleration[left - 2], abs=0.3)


def test_who_has_left_has_not_stopped() -> None:
    ((one,)) = testing.sample(LEAVER, 1).run("builtin", duration=10.0, control_step=0.1)
    margins = {name: verdict.robustness or 0.0 for name, verdict in one.verdicts.items()}
    assert margins["comes_to_rest"] < -5.0
    assert margins["moves"] > 0.0
    assert margins["calm"] > 0.0
    assert one.trace.agents["witness"].speed.max() == 0.0


def test_the_rate_of_a_signal_of_who_has_left_is_that_of_its_last_moment() -> None:
    from roadlang_standard.drive_signal_yaw_rate import YawRate

    time = np.arange(0.0, 3.0, 0.1)
    there = time < 2.0
    heading = np.where(there, 0.5 * time**2, 0.5 * 2.0**2)
    zero = np.zeros(len(time))
    agent = testing.agent_trace(
        "ego", time=time, x=zero, y=zero, heading=heading, speed=10.0, length=4.0, width=2.0,
        present=np.where(there, 1.0, 0.0),
    )  # fmt: skip
    values = YawRate(agent).values()
    assert values[there][1:-1] == pytest.approx(time[there][1:-1])
    assert (values[~there] == values[there][-1]).all()
    assert values[there][-1] == pytest.approx(1.85)


def test_another_engine_may_bring_back_who_had_left() -> None:
    world = world_of([queue_to_the_end()], {}, 0.1, 0.1)
    start = world.poses
    pose = np.stack([start.x, start.y, start.heading, np.full(5, 5.0)], axis=1)
    gone = pose.copy()
    ahead = world.end - world.motion.along + 5.0
    gone[0, 0] += ahead[0] * math.cos(start.heading[0])
    gone[0, 1] += ahead[0] * math.sin(start.heading[0])
    world.follow(gone, np.zeros(5), world.poses, passed=True)
    assert world.present.tolist() == [False, True, True, True, True]
    there = world.poses.x[0], world.motion.speed[0]
    gone[0] += [0.5 * math.cos(start.heading[0]), 0.5 * math.sin(start.heading[0]), 0.0, -3.0]
    world.follow(gone, np.zeros(5), world.poses, passed=True)
    assert (world.poses.x[0], world.motion.speed[0]) == there
    world.follow(pose, np.zeros(5), world.poses, passed=True)
    assert world.present.all()
    assert world.poses.x[0] == pytest.approx(start.x[0], abs=1e-6)
