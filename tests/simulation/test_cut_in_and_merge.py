"""`cut_in` ends closely in front of its target; `merge` finds a gap, or stops before the end."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from roadlang import testing
from roadlang.simulation.observing import lane_endings
from roadlang_standard import drive_merge

from .driven_roads import drive, drive_together

ROAD = """
road main { draw with segments { pieces: [straight(1200m)] }, lanes: 4, width: 14m }
"""
OUTER, INNER = -5.25, -1.75


def cutting(gap: float, start: int, lane: int = -1, speed: int = 20) -> str:
    return (
        ROAD
        + f"""
    agent ego is car on main at 150m {{
      lane: {-3 - lane}, start_speed: 20m/s, drive with lane_follow {{ speed: 20m/s }}
    }}
    agent cutter is car on main at {start}m {{
      lane: {lane}, start_speed: {speed}m/s
      drive with lane_follow {{ speed: 20m/s }}
      drive with cut_in {{ target: ego, gap: {gap}m, duration: 2.5s, when: time > 1s }}
    }}
    """
    )


def test_it_ends_in_front_of_its_target_with_the_gap() -> None:
    """From behind, beside and ahead of it, from the left and from the right."""
    cases = list(product((6.0, 15.0), (110, 150, 185), (-1, -2)))
    traces = drive_together((cutting(*case) for case in cases), duration=22)
    for case, trace in zip(cases, traces, strict=True):
        ego, cutter = trace.agents["ego"], trace.agents["cutter"]
        assert trace.events == (), case
        assert cutter.y[-1] == pytest.approx(ego.y[-1], abs=0.05), case
        inside = np.abs(cutter.y - ego.y) < 0.1
        there = int(np.flatnonzero(inside)[0])
        gap = cutter.x[there] - ego.x[there] - 4.5
        assert gap == pytest.approx(case[0], abs=1.0), case


def test_it_waits_for_a_car_that_is_where_it_would_go() -> None:
    other = """
    agent third is car on main at 169m {
      lane: -2, start_speed: 20m/s, drive with lane_follow { speed: 20m/s }
    }
    """
    (trace,) = drive(cutting(12.0, 140) + other, duration=15)
    assert trace.events == ()
    assert np.abs(trace.agents["cutter"].y - INNER).max() < 0.2


def merging(others: str, within: int = 200) -> str:
    return (
        ROAD
        + f"""
    agent ego is car on main at 50m {{
      lane: -2, start_speed: 15m/s
      drive with car_follow {{ speed: 25m/s }}
      drive with merge {{ within: {within}m, speed: 25m/s }}
    }}
    {others}
    """
    )


def queue(first: int, count: int, spacing: int, speed: int) -> str:
    return f"""
    agent queue is car on main at {first}m {{
      lane: -1, count: {count}, spacing: {spacing}m, start_speed: {speed}m/s
      drive with car_follow {{ speed: {speed}m/s, headway: 1s }}
    }}
    """


def test_on_a_free_road_it_merges_at_once() -> None:
    (trace,) = drive(merging(""), duration=8)
    assert trace.agents["ego"].y[-1] == pytest.approx(INNER, abs=0.05)


def test_it_merges_into_a_gap_before_its_lane_ends() -> None:
    cases = list(product((10, 25, 40, 55), (45, 60)))
    texts = (merging(queue(first, 4, spacing, 22), 300) for first, spacing in cases)
    for case, trace in zip(cases, drive_together(texts, duration=30), strict=True):
        ego = trace.agents["ego"]
        assert trace.events == (), case
        assert ego.y[-1] == pytest.approx(INNER, abs=0.1), case
        assert ego.x[ego.y < 0.5 * (OUTER + INNER)].max() < 50 + 300, case


@pytest.mark.parametrize("first", [42, 46])
def test_it_does_not_drive_beside_a_car_up_to_the_end_of_its_lane(first: int) -> None:
    """It moves up into the gap ahead of that car: it had braked to 8 m/s."""
    (trace,) = drive(f"""
    road main {{
      draw with segments {{ pieces: [straight(900m)] }}
      lanes: 2, oneway: true, speed_limit: 100km/h
    }}
    agent ego is car on main at 50m {{
      lane: -2, start_speed: 19m/s, drive with traffic, drive with merge {{ within: 160m }}
    }}
    agent queue is car on main at {first}m {{
      lane: -1, count: 5, spacing: 30m, start_speed: 19m/s, drive with traffic {{ speed: 18m/s }}
    }}
    """, duration=22)  # fmt: skip
    ego = trace.agents["ego"]
    assert trace.events == ()
    assert ego.lane[-1] == -1.0
    assert ego.speed.min() > 14.0


def test_without_a_gap_it_stops_where_its_lane_ends_and_goes_when_all_have_gone() -> None:
    dense = queue(4, 10, 10, 8).replace("headway: 1s", "headway: 0.4s")
    (trace,) = drive(merging(dense, 45), duration=45)
    ego = trace.agents["ego"]
    assert trace.events == ()
    stands = ego.speed < 0.05
    assert stands.any()
    assert ego.x[stands].max() < 50 + 45
    assert ego.y[stands].max() < OUTER + 0.1


def test_merge_knows_where_its_lane_ends_and_goes_on_when_there_is_room() -> None:
    (trace,) = drive("""
    road wide {
      draw with segments { pieces: [straight(250m)] }, lanes: 2, oneway: true, speed_limit: 60km/h
    }
    road single {
      draw with segments { pieces: [straight(250m)] }, lanes: 1, oneway: true, speed_limit: 60km/h
    }
    road works from wide { then: single, taper: 50m }
    agent flow is car on works at 20m { lane: -1, count: 9, spacing: 14m, drive with lane_follow }
    agent ego is car on works at 83m { lane: -2, drive with traffic, drive with merge }
    """, duration=50)  # fmt: skip
    ego = trace.agents["ego"]
    assert trace.events == ()
    assert ego.speed.min() < 1.0, "there is no room at first"
    assert ego.station[ego.lane == -2].max() < 250.0
    assert ego.station[-1] > 350.0


def test_after_the_merge_it_keeps_its_distance_whatever_drives_then() -> None:
    (trace,) = drive("""
    road main { draw with segments { pieces: [straight(700m)] }, oneway: true, lanes: 2 }
    agent slow is truck on main at 60m { lane: -1, drive with lane_follow { speed: 15m/s } }
    agent ego is car on main at 10m {
      lane: -2, start_speed: 20m/s
      drive with lane_follow { speed: 22m/s }
      drive with merge { duration: 2s }
    }
    """, duration=30)  # fmt: skip
    ego, slow = trace.agents["ego"], trace.agents["slow"]
    assert trace.events == ()
    merged = np.abs(ego.y - slow.y) < 0.2
    gap = slow.x - ego.x - 0.5 * (4.5 + 8.0)
    assert merged.sum() > 200
    assert gap[merged].min() > 5.0
    assert ego.speed[-1] == pytest.approx(15.0, abs=0.3)
    assert np.abs(np.diff(ego.acceleration[merged])).max() < 1.5


def test_without_a_lane_to_merge_into_it_drives_on_in_its_own() -> None:
    """To the left of the first agent is nothing, and of the second one traffic that comes toward
    it."""
    texts = [
        f"road main {{ draw with segments {{ pieces: [straight(700m)] }}, lanes: 2{oneway} }}"
        """
        agent ego is car on main at 10m {
          lane: -1, start_speed: 15m/s, drive with lane_follow { speed: 20m/s }
          drive with merge { to: left, within: 100m, speed: 20m/s, when: ego.speed > 0m/s }
        }
        """
        for oneway in (", oneway: true", "")
    ]
    for trace in drive_together(texts, duration=20):
        ego = trace.agents["ego"]
        assert np.abs(ego.y - ego.y[0]).max() < 0.1
        assert ego.speed.min() > 14.0
        assert ego.speed[-1] == pytest.approx(20.0, abs=0.3)


def test_without_a_lane_to_merge_into_it_stops_where_its_own_ends() -> None:
    """It merges to the right where only the lane to the left goes on."""
    (trace,) = drive("""
    road wide { draw with segments { pieces: [straight(250m)] }, lanes: 2, oneway: true }
    road single { draw with segments { pieces: [straight(250m)] }, lanes: 1, oneway: true }
    road works from wide { then: single, taper: 50m }
    agent ego is car on works at 83m {
      lane: -2, drive with car_follow, drive with merge { to: right, when: ego.speed > 0m/s }
    }
    """, duration=40)  # fmt: skip
    ego = trace.agents["ego"]
    assert ego.speed.min() < 0.05
    assert 180.0 < ego.station[-1] < 250.0


RAMP = """
road before { draw with segments { pieces: [straight(300m)] }, lanes: 2, oneway: true }
road beside { draw with segments { pieces: [straight(250m)] }, lanes: 3, oneway: true }
road after { draw with segments { pieces: [straight(700m)] }, lanes: 2, oneway: true }
road motorway from before { then: [beside, after], taper: 60m }
agent ego is car on motorway at 340m..360m {
  lane: -3, start_speed: 50km/h, drive with traffic, drive with merge { to: left } }
agent slow is choice(car, truck, weights: [3, 1]) on motorway at 150m..230m {
  lane: -2, count: 9, spacing: 14m..40m, drive with traffic { speed: (75km/h)..(110km/h) } }
agent fast is car on motorway at 30m..60m {
  lane: -1, count: 6, spacing: 40m..60m, drive with traffic { speed: 95km/h } }
"""


def test_who_turned_back_changes_one_lane_only() -> None:
    """Its center may be in the new lane for a moment after it has turned back: what is to the left
    of that is not where it wants to go."""
    for one in testing.sample(RAMP, 4, seed=3).run("builtin", duration=26.0):
        ego = one.trace.agents["ego"]
        assert ego.lane.max() == -2
        assert ego.speed.min() > 8.0, "those in the lane let it in"


def test_those_beside_it_have_made_room_before_it_brakes_for_the_end_of_its_lane() -> None:
    braking = drive_merge.STOPS * drive_merge.Merge().deceleration
    assert braking >= lane_endings.STOPPING


CUTTING_IN = """
road main { draw with segments { pieces: [straight(900m)] }, lanes: 4, oneway: true }
agent ego is car on main at 20m {
  lane: -1, start_speed: 90km/h, drive with traffic { speed: 90km/h }
}
agent other is car on main at START {
  lane: -2, start_speed: SPEED, drive with lane_follow { speed: SPEED }
  drive with change_lane { to: left, force: true, duration: 3s, when: ego.station > 60m }
}
"""


@pytest.mark.parametrize(("start", "speed"), [("30m", "90km/h"), ("28m", "94km/h")])
def test_traffic_falls_back_gently_from_who_cuts_in_as_fast_as_it_is(
    start: str, speed: str
) -> None:
    (trace,) = drive(CUTTING_IN.replace("START", start).replace("SPEED", speed), duration=25.0)
    ego, other = trace.agents["ego"], trace.agents["other"]
    assert trace.events == ()
    assert -4.0 < ego.acceleration.min() < -1.0
    gap = (other.station - ego.station - 4.5)[ego.present == 1.0]
    assert gap[30] < 12.0
    assert gap[-1] > 20.0


def test_traffic_brakes_as_hard_as_it_must_for_who_cuts_in_slowly() -> None:
    (trace,) = drive(CUTTING_IN.replace("START", "70m").replace("SPEED", "55km/h"), duration=15.0)
    assert trace.events == ()
    assert trace.agents["ego"].acceleration.min() < -4.0
