"""`overtake`: it passes where there is time for it, waits or falls back where there is none."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.trace import Trace

from .driven_roads import drive
from .routed_scenes import drive_scenes

ROAD = """
road main {
  draw with segments { pieces: [straight(1200m), arc(500m, 40deg), straight(900m)] }
  lanes: 2, width: 7.5m
}
"""
PASSES = """
agent ego is car on main at 40m {
  drive with car_follow { speed: 90km/h }
  drive with overtake { target: slow, gap: 8m }
}
agent slow is choice(car, truck) on main at 80m..110m {
  drive with lane_follow { speed: (40km/h)..(55km/h) }
}
"""
ONCOMING = """
agent oncoming is car on main at 300m..600m {
  facing: back, count: integer(1, 4), spacing: 120m..500m
  drive with car_follow { speed: (50km/h)..(100km/h) }
}
"""


def passed(trace: Trace) -> bool:
    ego, slow = trace.agents["ego"], trace.agents["slow"]
    return bool((ego.station > slow.station + 20.0).any())


def test_with_a_free_road_it_passes_and_pulls_in_with_its_gap() -> None:
    (trace,) = drive(ROAD + PASSES.replace("choice(car, truck)", "car"), duration=30)
    ego, slow = trace.agents["ego"], trace.agents["slow"]
    out = ego.station < 1150.0
    assert ego.y[out].max() > 1.5
    assert ego.y[out][-1] == pytest.approx(-1.875, abs=0.2)
    pulls_in = (ego.y < 1.4) & (ego.x > slow.x) & out
    begins = int(np.flatnonzero(pulls_in)[0])
    assert 8.0 < ego.x[begins] - slow.x[begins] - 4.5 < 8.0 + 12.0  # 1 s later, 10 m/s faster
    assert trace.events == ()


def test_no_collision_over_twenty_draws_of_oncoming_traffic() -> None:
    traces = drive(ROAD + PASSES + ONCOMING, 20, seed=3, duration=70)
    assert [trace.events for trace in traces] == [()] * 20
    assert sum(map(passed, traces)) >= 19
    waits = sum(
        trace.agents["ego"].y[trace.agents["ego"].time < 5].max() < -1.0 for trace in traces
    )
    assert 2 <= waits <= 18  # it depends on the draw whether it can pass at once


def test_who_is_not_beside_the_target_yet_falls_back() -> None:
    late = """
    agent oncoming is car on main at 420m {
      lane: 1, start_speed: 0m/s
      drive with brake
      drive with lane_follow { speed: 35m/s, acceleration: 9m/s^2, when: ego.y > -0.5m }
    }
    """
    (trace,) = drive(ROAD + PASSES.replace("80m..110m", "85m") + late, duration=40)
    ego = trace.agents["ego"]
    assert trace.events == ()
    met = int(np.flatnonzero(trace.agents["oncoming"].x < ego.x)[0])
    assert ego.y[met] < -1.0
    assert ego.y[:met].max() > 0.0  # it had pulled out
    assert passed(trace)


def test_it_never_passes_where_the_speed_limit_leaves_nothing_to_gain() -> None:
    limited = ROAD.replace("lanes: 2", "lanes: 2, speed_limit: 50km/h")
    text = limited + PASSES.replace("(40km/h)..(55km/h)", "48km/h")
    (trace,) = drive(text, duration=30)
    assert not passed(trace)
    assert trace.agents["ego"].y[:100].max() < -1.5


def test_in_left_hand_traffic_it_passes_on_the_right() -> None:
    straight = ROAD.replace("arc(500m, 40deg)", "straight(100m)")
    scenes = [
        one.record
        for side in ("right", "left")
        for one in testing.sample(straight + PASSES + ONCOMING + f"world {{ traffic: {side} }}", 2)
    ]
    traces = drive_scenes(scenes, duration=30.0)
    for one, other in zip(traces[:2], traces[2:], strict=True):
        assert one.agents["ego"].y == pytest.approx(-other.agents["ego"].y, abs=1e-9)


def test_a_drive_is_the_same_alone_and_in_a_batch() -> None:
    many = drive(ROAD + PASSES + ONCOMING, 3, seed=3, duration=15)
    (alone,) = drive(ROAD + PASSES + ONCOMING, 1, seed=3, duration=15)
    for column in ("x", "y", "speed", "cross_track_error"):
        values = (getattr(one.agents["ego"], column) for one in (alone, many[0]))
        assert len({value.tobytes() for value in values}) == 1


STANDING = """
road street { draw with segments { pieces: [straight(300m)] }, lanes: 2, speed_limit: 50km/h }
agent ego is car on street at 10m { drive with traffic, drive with overtake { target: things } }
agent oncoming is car on street at 190m..295m { facing: back, drive with traffic }
"""


def test_what_stands_in_the_lane_is_passed_when_the_road_is_free() -> None:
    cases = [
        "object things is parked_car on street at 90m..130m { lane: -1, offset: -0.5m }",
        "object things is cone on street at 110m { count: 8, spacing: 5m, lane: -1 }",
        "agent things is bus on street at 100m { drive with stop_at { station: 120m } }",
    ]
    drawn = [(case, one.record) for case in cases for one in testing.sample(STANDING + case, 3)]
    traces = drive_scenes([scene for _, scene in drawn], duration=45.0)  # in one block
    for (case, _), trace in zip(drawn, traces, strict=True):
        ego, oncoming = trace.agents["ego"], trace.agents["oncoming"]
        assert trace.events == (), case
        assert ego.station.max() > 200.0, case
        last = ego.station > 200.0
        assert np.abs(ego.y[last][0] + 1.75) < 0.3, case
        out = ego.y > 0.0
        meeting = np.abs(ego.x - oncoming.x) < 5.0
        assert not (out & meeting).any(), case


@pytest.mark.parametrize("gap", [3, 7])
def test_it_pulls_out_from_close_behind_a_bus_that_stands(gap: int) -> None:
    (trace,) = drive(f"""
    road main {{ draw with segments {{ pieces: [straight(300m)] }}, lanes: 2, speed_limit: 50km/h }}
    agent bus is bus on main at 120m {{ start_speed: 0m/s, drive with stop_at }}
    agent ego is car on main at behind(bus, {gap}m) {{
      start_speed: 0m/s, drive with car_follow, drive with overtake {{ target: bus }}
    }}
    """, duration=24)  # fmt: skip
    assert trace.events == ()
    assert trace.agents["ego"].station[-1] > 200.0


def test_it_does_not_begin_a_pass_that_would_hit_what_stands() -> None:
    (trace,) = drive("""
    road main { draw with segments { pieces: [straight(300m)] }, lanes: 2, speed_limit: 50km/h }
    agent bus is bus on main at 40m { drive with traffic, drive with stop_at { station: 120m } }
    agent ego is car on main at 10m {
      drive with traffic, drive with overtake { target: bus, when: bus.speed < 0.1m/s }
    }
    """, duration=35)  # fmt: skip
    assert trace.events == ()
    assert trace.agents["ego"].station[-1] > 200.0


def test_in_the_innermost_lane_of_a_oneway_road_it_passes_on_the_other_side() -> None:
    (trace,) = drive("""
    road highway { draw with segments { pieces: [straight(500m)] }, lanes: 2, oneway: true }
    object tire is tire on highway at 250m { lane: -1 }
    agent ego is car on highway at 20m {
      lane: -1, drive with car_follow { speed: 90km/h }, drive with overtake { target: tire }
    }
    """, duration=25)  # fmt: skip
    ego = trace.agents["ego"]
    assert trace.events == ()
    assert set(ego.lane.tolist()) == {-1.0, -2.0}
    assert ego.lane[-1] == -1


def test_the_members_of_a_group_are_passed_one_after_the_other() -> None:
    text = """
    agent ego is car on main at 20m {
      drive with car_follow { speed: 70km/h }
      drive with overtake { target: slow, speed: 80km/h }
    }
    agent slow is car on main at 80m {
      count: 3, spacing: 70m
      drive with lane_follow { speed: 25km/h }
    }
    """
    (trace,) = drive(ROAD + text, duration=70)
    ego = trace.agents["ego"]
    first, last = trace.agents["slow[0]"], trace.agents["slow[2]"]
    beside = (ego.y > 1.0) & (ego.x < 1150.0)
    begins = np.flatnonzero(np.diff(beside.astype(int)) == 1)
    assert len(begins) == 3
    assert (ego.station > first.station + 20.0).any()
    assert (ego.station > last.station + 20.0).any()
    assert trace.events == ()


def test_a_queue_is_passed_together_with_what_it_waits_for() -> None:
    text = """
    road street { draw with segments { pieces: [straight(300m)] }, lanes: 2, speed_limit: 50km/h }
    agent ego is car on street at 10m {
      drive with car_follow, drive with overtake { target: queue }
    }
    agent queue is car on street at 95m {
      count: 2, spacing: -8m, start_speed: 0m/s, drive with car_follow { speed: 20km/h }
    }
    object broken is parked_van on street at 120m { lane: -1 }
    """
    (trace,) = drive(text, duration=32)
    ego = trace.agents["ego"]
    assert trace.events == ()
    past = ego.station > 160.0
    assert past.any()
    assert np.abs(ego.y[past][0] + 1.75) < 0.3
