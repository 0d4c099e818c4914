"""Traffic goes around what stands in its lane, where others leave it room and time."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.trace import AgentTrace, Trace
from roadlang_standard.ways_around import swing
from tests.simulation.routed_scenes import CONTROL_STEP

STREET = """
road street {
  draw with segments { pieces: [straight(260m)] }
  lanes: 2, width: 7m, speed_limit: 50km/h
}
"""
FOUR_LANES = STREET.replace("lanes: 2, width: 7m", "lanes: 4, width: 14m")
PARKED = "object parked is parked_car on street at 120m { lane: -1 }\n"


def driven(text: str, seconds: float = 60.0) -> Trace:
    (drive,) = testing.sample(text).run("builtin", duration=seconds, control_step=CONTROL_STEP)
    assert not drive.trace.events, "nobody touches anything"
    return drive.trace


def agent(name: str, at: str, options: str) -> str:
    return f"agent {name} is car on street at {at} {{ {options} }}\n"


def arrived(car: AgentTrace) -> bool:
    return bool(car.present[-1] == 0.0)


def farthest_left(car: AgentTrace) -> float:
    return float(car.y.max())


@pytest.mark.parametrize(("offset", "left"), [(-3.2, -1.0), (-1.75, 1.0)])
def test_it_moves_over_by_as_much_as_it_takes(offset: float, left: float) -> None:
    """The middle of the lane is at -1.75 m. Who is partly in it leaves room within the lane or
    nearly so; around a car in the middle it drives on the other side."""
    parked = f"object parked is parked_car on street at 120m {{ lane: none, offset: {offset}m }}\n"
    ego = driven(STREET + agent("ego", "10m", "lane: -1, drive with traffic") + parked).agents[
        "ego"
    ]
    assert arrived(ego)
    assert left - 0.6 < farthest_left(ego) < left + 0.6
    assert ego.y[-1] == pytest.approx(-1.75, abs=0.1), "it is back in its lane"


def test_it_waits_for_oncoming_traffic() -> None:
    others = agent("others", "205m", "lane: 1, facing: back, count: 4, spacing: 12m, "
                   "drive with traffic")  # fmt: skip
    trace = driven(STREET + agent("ego", "50m", "lane: -1, drive with traffic") + PARKED + others)
    ego = trace.agents["ego"]
    last = trace.agents["others[3]"]
    assert arrived(ego)
    assert ego.speed[ego.station < 120.0].min() < 0.5, "it stands before the parked car"
    beside = np.flatnonzero(ego.y > 0.0)[0]
    assert last.x[beside] < ego.x[beside], "the last of them has passed"


def test_with_a_lane_beside_in_its_direction_it_changes_lanes() -> None:
    parked = PARKED.replace("-1", "-2")
    text = FOUR_LANES + agent("ego", "10m", "lane: -2, drive with traffic") + parked
    ego = driven(text).agents["ego"]
    assert arrived(ego)
    assert farthest_left(ego) == pytest.approx(-1.75, abs=0.3), "the middle of lane -1"
    assert ego.speed[ego.station > 20.0].min() > 7.0


def test_a_row_of_parked_cars_is_passed_at_once() -> None:
    parked = PARKED.replace("lane: -1", "lane: -1, count: 3, spacing: 7m")
    ego = driven(STREET + agent("ego", "10m", "lane: -1, drive with traffic") + parked).agents[
        "ego"
    ]
    assert arrived(ego)
    beside = ego.y > 0.0
    assert np.diff(beside.astype(int)).tolist().count(1) == 1


@pytest.mark.parametrize("standing", ["go_around: false", "headway: 1s"])
def test_it_stands_where_it_may_not_or_cannot_go_around(standing: str) -> None:
    """With the option off; or where the only lane is full."""
    narrow = STREET.replace("lanes: 2, width: 7m", "oneway: true, lanes: 1, width: 3.5m")
    road = STREET if "go_around" in standing else narrow
    text = road + agent("ego", "80m", f"lane: -1, drive with traffic {{ {standing} }}") + PARKED
    ego = driven(text, 20.0).agents["ego"]
    assert ego.speed[-1] < 0.1
    assert 110.0 < ego.station[-1] < 120.0


def test_from_a_standstill_close_behind_it_pulls_out() -> None:
    close = agent("ego", "112m", "lane: -1, start_speed: 0m/s, drive with traffic")
    assert arrived(driven(STREET + close + PARKED, 40.0).agents["ego"])


@pytest.mark.parametrize("kind", ["car", "bus"])
def test_where_it_does_not_go_around_it_stands_clear_of_it(kind: str) -> None:
    """The parked car begins at 117.75 m."""
    ego = f"agent ego is {kind} on street at 60m {{ lane: -1, drive with traffic " \
          "{ go_around: false } }\n"  # fmt: skip
    stood = driven(STREET + ego + PARKED, 30.0).agents["ego"]
    assert stood.speed[-1] < 0.1
    assert 2.5 < 117.75 - (stood.station[-1] + 0.5 * stood.length) < 5.0


SECOND = "object second is parked_car on street at {at}m {{ lane: 1 }}\n"


def test_with_room_between_it_passes_two_on_different_sides() -> None:
    text = STREET + agent("ego", "10m", "lane: -1, drive with traffic") + PARKED
    assert arrived(driven(text + SECOND.format(at=165)).agents["ego"])


def test_it_does_not_pull_out_where_more_stands_on_the_lane_beside() -> None:
    """It would have to stand there, in the way of those who come."""
    text = STREET + agent("ego", "60m", "lane: -1, drive with traffic") + PARKED
    ego = driven(text + SECOND.format(at=132), 30.0).agents["ego"]
    assert ego.speed[-1] < 0.1
    assert farthest_left(ego) < -1.5, "it is in its lane"


CORNER = '''
image plan from """
#######
#.....#
#.....#
#######
""" {{ scale: 20m/px, legend: {{ "#": road }} }}
network town from plan {{ lanes: 2, speed_limit: 50km/h }}
agent ego is car on town {{ route: [{route}], drive with traffic {{ go_around: {around} }} }}
object parked is parked_car at ({x}m, {y}m) {{ heading: {heading}deg }}
'''


@pytest.mark.parametrize("around", ["true", "false"])
@pytest.mark.parametrize(("x", "y", "heading"), [(125, 12, 60), (128, 16, 90), (119, 9, 20)])
def test_it_touches_nothing_in_a_corner(x: float, y: float, heading: float, around: str) -> None:
    text = CORNER.format(route="(30m, 10m), (130m, 60m)", around=around, x=x, y=y, heading=heading)
    driven(text, 40.0)


BROKEN = "agent broken is car on street at 120m { lane: -1, start_speed: 0m/s, drive with brake }\n"


@pytest.mark.parametrize("at", ["10m", "100m"])
def test_it_goes_around_a_car_that_stands_and_waits_for_nothing(at: str) -> None:
    trace = driven(STREET + agent("ego", at, "lane: -1, drive with traffic") + BROKEN, 40.0)
    assert arrived(trace.agents["ego"])
    assert farthest_left(trace.agents["ego"]) > 0.0
    assert trace.agents["broken"].speed.max() == 0.0


def test_with_the_option_off_it_stands_behind_that_too() -> None:
    stays = "lane: -1, drive with traffic { go_around: false }"
    ego = driven(STREET + agent("ego", "80m", stays) + BROKEN, 30.0).agents["ego"]
    assert ego.speed[-1] < 0.1
    assert ego.station[-1] < 116.0


LIGHTS = '''
image plan from """
....#....
....#....
#########
....#....
....#....
""" {{ scale: 20m/px, legend: {{ "#": road }} }}
network town from plan {{
  lanes: 2, speed_limit: 50km/h
  control with signals {{ green: 20s, yellow: 3s, all_red: 2s, offset: {offset}s }}
}}
agent first is car on town {{
  route: [(72m, 50m), (170m, 50m)], start_speed: 0m/s, drive with {first}
}}
agent second is car on town {{
  route: [(56m, 50m), (170m, 50m)], start_speed: 0m/s, drive with traffic
}}
'''


@pytest.mark.parametrize("offset", [0, 25])
@pytest.mark.parametrize("first", ["traffic", "brake { while: time < 30s }"])
def test_it_stays_behind_a_car_that_waits_at_a_light(first: str, offset: int) -> None:
    """Of one of the two offsets the light is red at first."""
    cars = driven(LIGHTS.format(offset=offset, first=first), 12.0).agents
    assert np.abs(cars["second"].y - cars["second"].y[0]).max() < 0.5
    assert (cars["second"].x < cars["first"].x).all()


def test_it_goes_around_a_car_that_breaks_down_before_it() -> None:
    drives = "drive with lane_follow { speed: 8m/s }, drive with brake { when: time > 8s }"
    lead = agent("lead", "30m", f"lane: -1, {drives}")
    trace = driven(STREET + agent("ego", "10m", "lane: -1, drive with traffic") + lead, 45.0)
    assert arrived(trace.agents["ego"])
    assert not arrived(trace.agents["lead"])


def test_where_there_is_little_room_it_passes_closely_and_slowly() -> None:
    """2.12 m are left beside the van, and the car is 1.8 m wide."""
    van = "object parked is parked_van on street at 120m { lane: none, offset: -0.12m }\n"
    road = STREET.replace("width: 7m", "width: 6m")
    ego = driven(road + agent("ego", "80m", "lane: -1, drive with traffic") + van).agents["ego"]
    assert arrived(ego)
    assert ego.speed[np.abs(ego.x - 120.0) < 4.0].max() < 2.5


PARKED_BEFORE_A_JUNCTION = '''
image plan from """
....#....
....#....
#########
....#....
....#....
""" { scale: 20m/px, legend: { "#": road } }
network town from plan { lanes: 2, speed_limit: 50km/h }
object parked is parked_car at (76m, 48.25m) { heading: 0deg }
agent behind is car on town {
  route: [(40m, 50m), (170m, 50m)], drive with traffic { go_around: false }
}
agent other is car on town { route: [(90m, 95m), (90m, 5m)], drive with traffic }
'''


def test_who_cannot_get_to_a_junction_keeps_nobody_from_crossing_it() -> None:
    """The other one yields to who comes from its right, where a car is parked."""
    cars = driven(PARKED_BEFORE_A_JUNCTION, 30.0).agents
    assert cars["behind"].speed[-1] < 0.1
    assert arrived(cars["other"])


@pytest.mark.parametrize(("curvature", "line", "meters"), [(0.1, 3.0, 0.36), (-0.1, 3.0, 0.0)])
def test_inside_a_bend_its_front_swings_toward_what_is_outside(
    curvature: float, line: float, meters: float
) -> None:
    """4.5 m long, 3 m inside of a radius of 10 m: `2.25^2 / (2 * 7)`."""
    found = swing(*(np.array([value]) for value in (4.5, curvature, line)))
    assert found == pytest.approx(meters, abs=0.01)
