"""Who pulls out, merges or stands turned beside the lane: those who come see it in time."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.scene_lane import SceneLane
from roadlang.simulation.observing.lane_endings import has_lane_endings

from .driven_roads import drive

STREET = """
road street {
  draw with segments { pieces: [straight(60m), arc(300m, 20deg), straight(200m)] }
  left: [drive(3.5m)], right: [drive(3.5m), parking(3m)], speed_limit: 50km/h
}
agent ego is car on street at 22.5m { drive with traffic }
"""


def test_traffic_brakes_for_a_bus_that_comes_out_of_the_parking_lane() -> None:
    coach = """agent coach is bus on street at 110m {
      lane: parking, start_speed: 0km/h
      drive with car_follow { speed: 35km/h }
      drive with change_lane { to: left, when: time > 6s }
    }"""
    (trace,) = drive(STREET + coach, duration=14)
    assert trace.events == ()
    assert (trace.agents["coach"].lane == -1).any()
    assert trace.agents["ego"].speed.min() < 10.0


def test_a_bus_does_not_come_out_right_before_somebody() -> None:
    coach = """agent coach is bus on street at 95m {
      lane: parking, start_speed: 0km/h
      drive with car_follow { speed: 35km/h }
      drive with change_lane { to: left, when: time > 6s }
    }"""
    (trace,) = drive(STREET + coach, duration=20)
    out = trace.agents["coach"].lane == -1
    assert trace.events == ()
    assert out.any()
    first = int(out.argmax())
    assert trace.agents["ego"].station[first] > trace.agents["coach"].station[first]


def test_a_controller_whose_condition_no_longer_holds_is_not_asked() -> None:
    coach = """agent coach is bus on street at 100m {
      lane: parking, start_speed: 0km/h
      drive with car_follow { speed: 35km/h }
      drive with stop_at { while: time < 1s }
      drive with change_lane { to: left, when: time > 1s }
    }"""
    (trace,) = drive(STREET + coach, duration=6)
    coach_, waits = trace.agents["coach"], trace.agents["coach"].time < 1.0
    assert coach_.speed[waits].max() < 0.1
    assert coach_.speed[-1] > 4.0


def test_the_corner_of_what_stands_turned_beside_the_lane_is_in_the_way() -> None:
    text = """
    road main { draw with segments { pieces: [straight(120m)] } }
    agent ego is car on main at 10m { drive with car_follow { speed: 30km/h } }
    agent coach is bus at (70m, 2.35m) { heading: -20deg }
    """
    (trace,) = drive(text, duration=14)
    assert trace.events == ()
    assert trace.agents["ego"].speed[-1] < 0.2


LANE_ENDS = """
road two { draw with segments { pieces: [straight(200m)] }, lanes: 2, oneway: true }
road one { draw with segments { pieces: [straight(200m)] }, lanes: 1, oneway: true }
road street from two { then: one, taper: 40m }
agent keepers is car on street at 20m {
  lane: -1, count: 5, spacing: 17m, drive with traffic { speed: 50km/h, politeness: POLITE }
}
agent mergers is car on street at 12m {
  lane: -2, count: 5, spacing: 18m, drive with traffic { speed: 50km/h, politeness: POLITE }
  drive with merge
}
"""


@pytest.mark.slow
def test_polite_traffic_lets_in_one_by_one_who_has_to_leave_its_lane() -> None:
    turns = {}
    for polite in ("0", "0.9"):
        (trace,) = drive(LANE_ENDS.replace("POLITE", polite), duration=40)
        passing = {
            name: float(agent.time[np.flatnonzero(agent.station > 230.0)[0]])
            for name, agent in trace.agents.items()
            if (agent.station > 230.0).any()
        }
        order = [name[0] for name in sorted(passing, key=passing.__getitem__)]
        turns[polite] = sum(a != b for a, b in pairwise(order))
    assert trace.events == ()
    assert turns["0.9"] > turns["0"]
    assert turns["0.9"] >= 5
    assert max(passing.values()) < 28.0, "they flow: one every two seconds, the first at 10 s"
    keepers = [agent for name, agent in trace.agents.items() if name.startswith("keepers")]
    assert min(agent.acceleration.min() for agent in keepers) > -2.5


@pytest.mark.parametrize(
    ("widths", "kind", "ends"),
    [
        ([(3.5, 1.7)], "drive", True),
        ([(3.5, 3.4, 0.0)], "drive", True),
        ([(3.5, 1.75)], "drive", False),
        ([(0.2, 0.4)], "drive", False),
        ([(3.5,)], "drive", False),
        ([(3.5, 0.0)], "sidewalk", False),
        ([(3.5,), (0.0, 3.5)], "drive", True),
        ([], "drive", False),
    ],
)
def test_a_lane_ends_where_it_has_less_than_half_its_width(
    widths: list[tuple[float, ...]], kind: str, ends: bool
) -> None:
    lanes = tuple(
        SceneLane(-1 - i, kind, "forward", width, drivable=kind == "drive")
        for i, width in enumerate(widths)
    )
    road = replace(testing.sample(STREET)[0].record.roads[0], lane_list=lanes)
    assert has_lane_endings([road]) is ends
    plain = replace(road, lane_list=(SceneLane(-1, "drive", "forward", (3.5,)),))
    assert has_lane_endings([plain, road]) is has_lane_endings([road, plain]) is ends
    assert not has_lane_endings([])


FROM_THE_VERGE = """
road main { draw with segments { pieces: [straight(400m)] }, lanes: 4, speed_limit: 50km/h }
world { traffic: HAND }
agent ego is car on main at 20m { side: HAND, drive with KIND }
agent other is car on main at 380m { side: OTHER, facing: back, drive with KIND }
expect untouched: always (ego.contacts == 0 and other.contacts == 0)
"""


@pytest.mark.parametrize(
    ("kind", "hand"), [("traffic", "right"), ("lane_follow", "left"), ("pure_pursuit", "right")]
)
def test_who_stands_beside_the_road_enters_the_nearest_lane_for_its_direction(
    hand: str, kind: str
) -> None:
    other = {"right": "left", "left": "right"}[hand]
    text = FROM_THE_VERGE.replace("HAND", hand).replace("OTHER", other).replace("KIND", kind)
    ((one,)) = testing.sample(text, 1).run("builtin", duration=20.0, control_step=0.1)
    side = -1.0 if hand == "right" else 1.0
    for name, way in (("ego", 1.0), ("other", -1.0)):
        agent = one.trace.agents[name]
        assert abs(agent.y[0]) > 7.0
        assert agent.y[120] == pytest.approx(side * way * 5.25, abs=0.05)
        assert (side * way * agent.y).min() > 3.5
    assert one.verdicts["untouched"].satisfied
