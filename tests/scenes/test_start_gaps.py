"""Traffic begins so slowly that it can keep its distance to what is ahead in its lane."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from roadlang import testing

ROAD = """
road main {{ draw with segments {{ pieces: [straight(200m)] }}, lanes: 2, speed_limit: 72km/h }}
agent ego is car on main at 50m {{ drive with traffic {ego} }}
agent lead is car on main at {lead} {{ {option}drive with traffic {{ speed: 5m/s }} }}
"""


def speeds(lead: str = "60m", option: str = "", ego: str = "") -> tuple[float, float]:
    (scene,) = testing.sample(ROAD.format(lead=lead, option=option, ego=ego), 1)
    one, other = scene.record.agents
    return float(one.start_speed or 0.0), float(other.start_speed or 0.0)


def test_behind_a_slow_car_it_can_slow_down_in_time() -> None:
    gap = 10.0 - 4.5 - 2.0
    assert speeds()[0] == pytest.approx(math.sqrt(25.0 + 6.0 * gap))
    assert speeds()[1] == 5.0


@pytest.mark.parametrize("lead", ["54.6m", "56.5m"])
def test_close_behind_it_is_no_faster(lead: str) -> None:
    assert speeds(lead, "overlap: true, ") == (5.0, 5.0)


@pytest.mark.parametrize("option", ["lane: 1, ", "lane: 1, facing: forward, "])
def test_in_another_lane_nobody_counts(option: str) -> None:
    assert speeds(option=option)[0] == 20.0


def test_who_is_behind_or_far_ahead_does_not_count() -> None:
    assert speeds("40m")[0] == 20.0
    assert speeds("130m")[0] == 20.0


def test_what_comes_toward_it_may_come_all_the_way() -> None:
    assert speeds("70m", "facing: back, lane: -1, ")[0] == pytest.approx(math.sqrt(6.0 * 13.5))


def test_what_the_file_says_counts() -> None:
    text = ROAD.format(lead="60m", option="", ego="").replace(
        "at 50m {", "at 50m { start_speed: 15m/s,"
    )
    (scene,) = testing.sample(text, 1)
    assert scene.record.agents[0].start_speed == 15.0


def test_an_object_in_the_lane_counts_and_one_beside_it_does_not() -> None:
    text = """
    road main { draw with segments { pieces: [straight(200m)] }, lanes: 2, speed_limit: 72km/h }
    agent ego is car on main at 50m { drive with traffic }
    object van is parked_van on main at 80m { lane: LANE }
    """
    (blocked,) = testing.sample(text.replace("LANE", "-1"), 1)
    (free,) = testing.sample(text.replace("LANE", "1"), 1)
    begins = [scene.record.agents[0].start_speed for scene in (blocked, free)]
    assert begins == [pytest.approx(math.sqrt(6.0 * (30.0 - 2.0 - 0.5 * (4.5 + 5.9)))), 20.0]


def test_a_platoon_is_slowed_from_its_front_to_its_rear() -> None:
    text = """
    road main { draw with segments { pieces: [straight(200m)] }, lanes: 2, speed_limit: 72km/h }
    agent cars is car on main at 20m { count: 6, spacing: 7m, drive with traffic }
    object van is parked_van on main at 66m { lane: -1 }
    """
    (scene,) = testing.sample(text, 1)
    found = [agent.start_speed for agent in scene.record.agents]
    squares = [speed * speed for speed in found if speed is not None]
    steps = [a - b for a, b in pairwise(squares)]
    assert steps == pytest.approx([6.0 * 0.5] * 5)


def test_ahead_goes_on_through_junctions() -> None:
    text = """
    image plan from \"\"\"
    ....#....
    ....#....
    ....#....
    #########
    ....#....
    ....#....
    \"\"\" { scale: 15m/px }
    network town from plan { extract with auto { width: 7m }, lanes: 2, speed_limit: 72km/h }
    agent ego is car on town { route: [(20m, 37m), (120m, 37m)], drive with TRAFFIC }
    agent lead is car on town at ahead_of(ego, AHEAD) { drive with traffic { speed: 1m/s } }
    """

    def begins(kind: str, ahead: str) -> float:
        made = text.replace("TRAFFIC", kind).replace("AHEAD", ahead)
        (scene,) = testing.sample(made, 1)
        ego, lead = scene.record.agents
        assert lead.road != ego.road
        return float(ego.start_speed or 0.0)

    assert begins("traffic", "62m") <= begins("traffic", "80m")
    assert begins("traffic", "62m") <= math.sqrt(1.0 + 6.0 * 60.0) + 1e-9
