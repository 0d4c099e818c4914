"""Where lanes change their widths, agents follow the middles of their lanes."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.simulation.lines.lane_guides import lane_guide

from .driven_roads import drive

TAPERED = """
road wide {{
  draw with segments {{ pieces: [straight(90m)] }}, left: [drive(3.5m), sidewalk(2m)],
  right: [drive(3.5m), sidewalk(2m)]
}}
road narrow {{
  draw with segments {{ pieces: [straight(60m), arc(80m, {turn}), straight(40m)] }},
  left: [drive(2.75m), sidewalk(2m)], right: [drive(2.75m), sidewalk(2m)]
}}
road street from wide {{ then: narrow, taper: 30m }}
"""
ENDING = """
road three { draw with segments { pieces: [straight(150m)] }, oneway: true, lanes: 3 }
road two { draw with segments { pieces: [straight(250m)] }, oneway: true, lanes: 2 }
road street from three { then: two, taper: 60m }
"""
TAPERED_LANE = """
road three {{ draw with segments {{ pieces: [straight(150m)] }}, oneway: true,
  right: [drive(3.5m), drive(3.5m), drive(3.5m)] }}
road two {{ draw with segments {{ pieces: [straight(150m)] }}, oneway: true,
  right: [drive(3.5m), drive(3.5m)] }}
road street from three {{ then: two, taper: {taper}m }}
"""
WIDENING = """
road three { draw with segments { pieces: [straight(150m)] }, oneway: true,
  right: [drive(3.5m), drive(3.5m), drive(3.5m)] }
road four { draw with segments { pieces: [straight(350m)] }, oneway: true,
  right: [drive(3.5m), drive(3.5m), drive(3.5m), drive(3.5m)] }
road street from three { then: four, taper: 36m }
"""
FUNNEL = """
road three { draw with segments { pieces: [straight(250m)] }, speed_limit: 60km/h,
  right: [drive(3.25m), drive(3.25m), drive(3.25m)] }
road one { draw with segments { pieces: [straight(60m), arc(60m, 20deg), straight(200m)] },
  right: [drive(3.25m)], speed_limit: 60km/h }
road street from three { then: one, taper: 50m }
agent a is choice(car, van, truck) on street at 20m {
  lane: -1, count: 4, spacing: 22m..28m, drive with traffic { speed_factor: 0.85..1.1 } }
agent b is choice(car, van, truck) on street at 10m..40m {
  lane: -2, count: 3, spacing: 22m..28m, drive with traffic { speed_factor: 0.85..1.1 } }
agent c is choice(car, van, truck) on street at 10m..40m {
  lane: -3, count: 4, spacing: 22m..28m, drive with traffic { speed_factor: 0.85..1.1 } }
"""
BESIDE = """
road wide { draw with segments { pieces: [straight(100m)] }, oneway: true,
  right: [drive(4m), drive(4m)] }
road narrow { draw with segments { pieces: [straight(250m)] }, oneway: true,
  right: [drive(2.75m), drive(2.75m)] }
road street from wide { then: narrow, taper: 60m }
"""

SIDE_BY_SIDE = """
road two {{ draw with segments {{ pieces: [straight(180m)] }}, speed_limit: 100km/h,
  right: [drive(3.25m), drive(3.25m)] }}
road one {{ draw with segments {{ pieces: [straight(200m)] }}, speed_limit: 100km/h,
  right: [drive(3.25m)] }}
road street from two {{ then: one, taper: 60m }}
agent bus is bus on street at 74m {{
  lane: -1, start_speed: 105km/h, drive with traffic {{ politeness: {politeness} }}
}}
agent ego is car on street at {place}m {{
  lane: -2, start_speed: 100km/h, drive with traffic {{ politeness: 0.5 }}
}}
"""


def tapered(agents: str, turn: str = "30deg", before: str = "", control_step: float = 0.1) -> Trace:
    text = before + TAPERED.format(turn=turn) + agents
    return drive(text, duration=16.0, control_step=control_step)[0]


def off_lane(trace: AgentTrace) -> float:
    return float(np.abs(trace.lane_offset).max())


@pytest.mark.parametrize(
    "controller", ["lane_follow", "stanley", "pure_pursuit", "traffic", "car_follow"]
)
def test_agents_of_both_directions_stay_in_the_middle_of_their_lanes(controller: str) -> None:
    with_speed = f"drive with {controller} {{ speed: 40km/h }}"
    trace = tapered(
        f"agent ego is car on street at 30m {{ {with_speed} }}\n"
        f"agent back is car on street at 200m {{ facing: back, {with_speed} }}\n",
        control_step=0.04,
    )
    for name in ("ego", "back"):
        agent = trace.agents[name]
        straight = (agent.station < 140.0) & (agent.station > 20.0)
        assert np.abs(agent.lane_offset[straight]).max() < 0.04, name
        assert off_lane(agent) < 0.25, name
        assert np.abs(agent.cross_track_error - agent.lane_offset).max() < 0.06, name
        assert agent.off_road.max() < 0.0, name


def test_a_long_truck_stays_on_the_road() -> None:
    trace = tapered("agent ego is truck on street at 30m { drive with lane_follow }", "1deg")
    assert trace.agents["ego"].off_road.max() < 0.0


def test_pedestrians_stay_in_the_middle_of_the_sidewalk() -> None:
    trace = tapered(
        "agent ego is pedestrian on street at 70m"
        " { lane: sidewalk, drive with walk { speed: 2.5m/s } }\n"
        "agent back is pedestrian on street at 105m"
        " { lane: sidewalk, facing: back, drive with walk { speed: 2.5m/s } }\n"
    )
    for name in ("ego", "back"):
        assert off_lane(trace.agents[name]) < 0.06


def test_left_hand_traffic_is_the_mirror_image() -> None:
    agents = "agent ego is car on street at 30m { drive with stanley { speed: 40km/h } }\n"
    right = tapered(agents, "30deg").agents["ego"]
    left = tapered(agents, "-30deg", "world { traffic: left }\n").agents["ego"]
    assert np.array_equal(right.x, left.x)
    assert np.array_equal(right.y, -left.y)


@pytest.mark.parametrize(("place", "politeness"), [(77, 0.0), (80, 0.5), (83, 0.0), (77, 1.0)])
def test_of_two_side_by_side_one_falls_back_in_time(place: int, politeness: float) -> None:
    (trace,) = drive(SIDE_BY_SIDE.format(place=place, politeness=politeness), duration=4.0)
    assert trace.events == ()


def test_who_is_in_a_lane_that_ends_goes_over_to_the_next_in_turn() -> None:
    trace = drive(
        ENDING + "agent ego is car on street at 40m { lane: -3, drive with traffic }\n"
        "agent before is car on street at 52m { lane: -2, drive with traffic }\n"
        "agent after is car on street at 28m { lane: -2, drive with traffic }\n"
        "agent alone is truck on street at 5m { lane: -3, drive with traffic }\n",
        duration=18.0,
    )[0]
    assert not trace.events
    for agent in trace.agents.values():
        assert agent.lane[-1] == -2.0
        assert abs(agent.lane_offset[-1]) < 0.02
        assert agent.off_road.max() < 0.0
    order = sorted(trace.agents, key=lambda name: -trace.agents[name].x[-1])
    assert order[:3] == ["before", "ego", "after"]


def test_three_lanes_become_one_without_contact() -> None:
    """In most such scenes, who came from the outer lane met who was in the inner one."""
    for one in drive(FUNNEL, 3, seed=7, duration=34.0):
        assert not one.events
        last = [agent.lane[-1] for agent in one.agents.values() if agent.present[-1]]
        assert last.count(-1.0) >= len(last) - 2


def test_lanes_are_changed_to_their_middles() -> None:
    trace = drive(
        BESIDE + "agent ego is car on street at 30m { lane: -2,"
        " drive with lane_follow { speed: 60km/h },"
        " drive with change_lane { to: left, when: time > 1.5s },"
        " drive with change_lane { to: right, when: time > 9s } }\n"
        "agent other is car on street at 200m { lane: -1,"
        " drive with lane_follow { speed: 15km/h } }\n"
        "agent slow is car on street at 120m { lane: -2,"
        " drive with lane_follow { speed: 15km/h } }\n",
        duration=16.0,
    )[0]
    ego = trace.agents["ego"]
    settled = (ego.time > 7.0) & (ego.time < 9.0)
    assert set(ego.lane[settled]) == {-1.0}
    assert np.abs(ego.lane_offset[settled]).max() < 0.05
    assert ego.lane[-1] == -2.0
    assert abs(ego.lane_offset[-1]) < 0.02


def test_an_overtaking_car_comes_back_to_the_middle_of_its_lane() -> None:
    trace = drive(
        BESIDE + "agent slow is car on street at 60m { lane: -2,"
        " drive with lane_follow { speed: 15km/h } }\n"
        "agent ego is car on street at 30m { lane: -2, drive with lane_follow { speed: 30km/h },"
        " drive with overtake { target: slow, speed: 50km/h } }\n",
        duration=20.0,
    )[0]
    ego = trace.agents["ego"]
    assert set(ego.lane) == {-1.0, -2.0}
    assert ego.x[-1] > trace.agents["slow"].x[-1]
    assert ego.lane[-1] == -2.0
    assert abs(ego.lane_offset[-1]) < 0.02


def test_a_lane_of_constant_width_has_no_guide() -> None:
    plain = "road main { draw with segments { pieces: [straight(90m)] }, lanes: 4, width: 14m }"
    scene = testing.sample(plain + "\nagent ego is car on main at 5m { drive with traffic }", 1)[0]
    assert lane_guide(scene.record.roads[0], -2) is None


@pytest.mark.parametrize(("kind", "speed", "station"), [("bus", 52, 61), ("truck", 60, 94)])
def test_long_vehicles_stay_on_the_road_where_the_outer_lane_ends(
    kind: str, speed: int, station: int
) -> None:
    """The bus went .22 m off the road, as their lines had less than the taper to lead over."""
    roads = TAPERED_LANE.format(taper=46 if kind == "bus" else 35)
    ego = drive(
        roads + f"agent ego is {kind} on street at {station}m {{ lane: -3,"
        f" start_speed: {speed}km/h, drive with traffic {{ speed: {speed}km/h }} }}\n",
        duration=6.0,
    )[0].agents["ego"]
    assert ego.off_road.max() < -0.1
    assert ego.lane[-1] == -2.0


def test_who_begins_in_a_lane_that_widens_does_not_swing_outward() -> None:
    """A car that merged from there went 6 m off the road."""
    ego = drive(
        WIDENING + "agent ego is car on street at 173m { lane: -4, start_speed: 90km/h,"
        " drive with car_follow { speed: 90km/h }, drive with merge { to: left } }\n",
        duration=4.0,
    )[0].agents["ego"]
    assert ego.off_road.max() < 0.1
    assert ego.lane[-1] == -3.0
