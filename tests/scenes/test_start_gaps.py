"""Traffic begins so slowly that it can keep its distance to what is ahead in its lane."""

from __future__ import annotations

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


def wanted(speed: float, ahead: float, headway: float = 1.0) -> float:
    """The gap of the intelligent driver model, 1.2 times what an agent begins with."""
    return (2.0 + speed * headway + speed * (speed - ahead) / 5.6) / 1.2


@pytest.mark.parametrize("headway", [0.8, 1.0, 2.5])
def test_behind_a_slow_car_it_soon_has_the_gap_that_it_wants(headway: float) -> None:
    ego, lead = speeds(ego=f"{{ headway: {headway}s }}")
    assert lead == 5.0
    assert wanted(ego, 5.0, headway) == pytest.approx(10.0 - 4.5)


def test_the_gap_of_car_follow_is_longer() -> None:
    text = ROAD.format(lead="60m", option="", ego="").replace("traffic", "car_follow", 1)
    (scene,) = testing.sample(text, 1)
    assert wanted(scene.record.agents[0].start_speed or 0.0, 5.0, 1.5) == pytest.approx(5.5)


@pytest.mark.parametrize("lead", ["54.6m", "55.5m"])
def test_close_behind_it_does_not_come_closer(lead: str) -> None:
    ego, ahead = speeds(lead, "overlap: true, ")
    assert ahead == 5.0
    assert ego < 1.0


@pytest.mark.parametrize("option", ["lane: 1, ", "lane: 1, facing: forward, "])
def test_in_another_lane_nobody_counts(option: str) -> None:
    assert speeds(option=option)[0] == 20.0


def test_who_is_behind_or_far_ahead_does_not_count() -> None:
    assert speeds("40m")[0] == 20.0
    assert speeds("180m")[0] == 20.0


def test_what_comes_toward_it_may_come_all_the_way() -> None:
    ego = speeds("70m", "facing: back, lane: -1, ")[0]
    assert wanted(ego, 0.0) == pytest.approx(15.5)


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
    begins = [scene.record.agents[0].start_speed or 0.0 for scene in (blocked, free)]
    assert wanted(begins[0], 0.0) == pytest.approx(30.0 - 0.5 * (4.5 + 5.9))
    assert begins[1] == 20.0


def test_a_platoon_is_slowed_from_its_front_to_its_rear() -> None:
    text = """
    road main { draw with segments { pieces: [straight(200m)] }, lanes: 2, speed_limit: 72km/h }
    agent cars is car on main at 20m { count: 6, spacing: 7m, drive with traffic }
    object van is parked_van on main at 66m { lane: -1 }
    """
    (scene,) = testing.sample(text, 1)
    found = [agent.start_speed or 0.0 for agent in scene.record.agents]
    assert found[0] > 0.0
    assert [wanted(one, ahead) for one, ahead in pairwise(found)] == pytest.approx([2.5] * 5)


def test_nobody_in_a_row_brakes_hard_when_the_drive_begins() -> None:
    text = """
    road main { draw with segments { pieces: [straight(400m)] }, lanes: 2, speed_limit: 50km/h }
    agent slow is car on main at 150m { drive with traffic { speed: 3m/s } }
    agent row is car on main at behind(slow, 4m) { count: 8, spacing: 9m, drive with traffic }
    simulate with builtin { duration: 10s }
    """
    scenes = testing.sample(text, 1)
    assert all(len(agent.drive) == 1 for agent in scenes[0].record.agents)
    (drive,) = scenes.run()
    for agent in drive.trace.agents.values():
        assert agent.acceleration.min() > -2.0  # it was -7.8


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
    assert wanted(begins("traffic", "62m"), 1.0) < 62.0 + 1e-9


@pytest.mark.parametrize("before", [6, 9])
def test_before_a_line_at_which_it_may_have_to_stop_it_begins_gently(before: int) -> None:
    text = f"""
    image plan from \"\"\"
    ....#....
    ....#....
    #########
    \"\"\" {{ scale: 15m/px }}
    network town from plan {{
      extract with auto {{ width: 7m }}, lanes: 2, speed_limit: 72km/h, control with stop
    }}
    agent ego is car on town at junction(1, before: {before}m) {{
      drive with traffic {{ headway: 0.8s, aggression: 0 }}
    }}
    """
    (one,) = testing.sample(text, 1).run("builtin", duration=1.0)
    assert (one.scene.record.agents[0].start_speed or 0.0) > 0.0
    assert one.trace.agents["ego"].acceleration.min() > -2.0  # it was -5


@pytest.mark.parametrize("facing", ["forward", "back"])
def test_on_a_closed_road_the_start_follows_the_end(facing: str) -> None:
    """A standing car 15 m ahead is as near across the start of the road as anywhere else."""

    def begins(at: float) -> float:
        way, lead = f"facing: {facing}", (at + (15.0 if facing == "forward" else -15.0)) % 314.0
        text = f"""
        road ring {{ draw with segments {{ pieces: [arc(50m, 360deg)] }}, closed: true, lanes: 2 }}
        agent ego is car on ring at {at}m {{ {way}, drive with traffic {{ speed: 12m/s }} }}
        agent lead is car on ring at {lead}m {{ {way}, start_speed: 0, drive with brake }}
        """
        (scene,) = testing.sample(text, 1)
        return float(scene.record.agents[0].start_speed or 0.0)

    assert wanted(begins(150.0), 0.0) == pytest.approx(10.5, abs=0.01)
    assert begins(305.0 if facing == "forward" else 9.0) == pytest.approx(begins(150.0), abs=0.1)
