"""What stands in the way: objects in the lane, vehicles that back into it, things that overlap."""

from __future__ import annotations

import numpy as np

from .driven_roads import drive

STREET = "road street { draw with segments { pieces: [straight(300m)] }, lanes: 2 }\n"


def test_car_follow_stops_before_an_object_in_its_lane() -> None:
    (trace,) = drive(STREET + """
    object broken is parked_car on street at 150m { lane: -1 }
    agent ego is car on street at 20m { drive with car_follow { speed: 70km/h } }
    """, duration=25)  # fmt: skip
    assert trace.events == ()
    assert 150.0 - 4.5 - 4.0 < trace.agents["ego"].station[-1] < 150.0 - 4.5


def test_car_follow_goes_past_an_object_beside_its_lane() -> None:
    (trace,) = drive(STREET + """
    object parked is parked_car on street at 150m { side: right, offset: 0.2m }
    agent ego is car on street at 20m { drive with car_follow { speed: 50km/h } }
    """, duration=25)  # fmt: skip
    assert trace.agents["ego"].speed.min() > 13.0


def test_reverse_backs_out_turns_and_stops() -> None:
    (trace,) = drive("""
    road lot {
      draw with segments { pieces: [straight(200m)] }
      right: [drive, parking(5m)], left: [drive]
    }
    agent ego is car on lot at 100m {
      lane: parking, heading: -90deg, start_speed: 0m/s
      drive with reverse { distance: 9m, straight: 3m, turn: 90deg, when: time > 1s }
    }
    """, duration=20)  # fmt: skip
    ego = trace.agents["ego"]
    assert ego.speed.min() < -1.4
    assert abs(ego.speed[-1]) < 1e-9
    assert abs(ego.heading[-1]) < 0.01
    assert abs(ego.y[-1] - ego.y[0] - (3.0 + 6.0 / 1.5708 + 1.35 - 1.35)) < 1.5


def test_traffic_stops_for_a_car_that_backs_into_its_lane() -> None:
    (trace,) = drive("""
    road street {
      draw with segments { pieces: [straight(200m)] }, speed_limit: 30km/h
      left: [drive(3m)], right: [drive(3m), parking(5m)]
    }
    agent backer is car on street at 82m {
      lane: parking, heading: -90deg, start_speed: 0m/s
      drive with reverse { distance: 4m, when: distance(ego, backer) < 25m }
    }
    agent ego is car on street at 5m { drive with traffic }
    """, duration=45)  # fmt: skip
    assert trace.events == ()
    ego, backer = trace.agents["ego"], trace.agents["backer"]
    assert ego.speed[ego.station < 82].min() < 0.1
    # It took it for something parked before, and goes around where it stands now.
    beside = np.abs(ego.x - backer.x[-1]) < 0.5
    assert beside.any()
    assert ego.y[beside].min() > 1.5


def test_traffic_lets_a_van_out_that_backs_and_turns_before_it() -> None:
    (trace,) = drive("""
    road street {
      draw with segments { pieces: [straight(200m)] }, speed_limit: 30km/h
      left: [drive(3m), sidewalk], right: [drive(3m), sidewalk]
    }
    agent backer is van on street at 90m {
      side: right, offset: 2.5m, heading: -90deg, start_speed: 0m/s
      drive with reverse {
        distance: 10m, turn: -80deg, straight: 2m, when: distance(ego, backer) < 35m
      }
    }
    agent ego is car on street at 10m { drive with traffic }
    """, duration=20)  # fmt: skip
    assert trace.events == ()
    assert trace.agents["backer"].y.max() > -4.0
    assert trace.agents["ego"].speed.min() < 3.0


def test_two_that_may_overlap_drive_through_each_other() -> None:
    (trace,) = drive(STREET + """
    agent one is car on street at 20m { overlap: true, drive with pure_pursuit { speed: 12m/s } }
    agent other is car on street at 20m { overlap: true, drive with stanley { speed: 10m/s } }
    """, duration=10)  # fmt: skip
    assert trace.events == ()
    assert trace.agents["one"].station[-1] > trace.agents["other"].station[-1] + 10.0


def test_who_backs_out_waits_while_somebody_stands_behind_it() -> None:
    (trace,) = drive(STREET + """
    object parked is parked_car on street at 84m { lane: -1 }
    agent backer is car on street at 95m {
      lane: -1, start_speed: 0m/s, drive with reverse { distance: 12m }
    }
    """, duration=15)  # fmt: skip
    backer = trace.agents["backer"]
    assert trace.events == ()
    assert backer.speed[-1] == 0.0
    assert 84.0 + 4.5 < backer.station[-1] < 84.0 + 4.5 + 1.0


def test_change_lane_waits_where_it_can_still_pull_out() -> None:
    (trace,) = drive("""
    road street { draw with segments { pieces: [straight(300m)] }, lanes: 2, oneway: true }
    object broken is parked_car on street at 120m { lane: -2 }
    agent ego is car on street at 20m {
      lane: -2
      drive with traffic { speed: 12m/s }
      drive with change_lane { to: left, when: gap(ego, broken) < 30m }
    }
    agent flow is car on street at 15m {
      lane: -1, count: 7, spacing: 15m, drive with traffic { speed: 9m/s }
    }
    """, duration=45)  # fmt: skip
    ego = trace.agents["ego"]
    assert trace.events == ()
    assert ego.speed.min() < 0.5
    assert ego.station[-1] > 200.0


def test_change_lane_right_of_the_last_lane_pulls_over_to_the_shoulder() -> None:
    (trace,) = drive("""
    road street {
      draw with segments { pieces: [straight(300m)] }, right: [drive, shoulder(3m)], left: [drive]
    }
    agent ego is car on street at 20m { drive with traffic, drive with change_lane { to: right } }
    """, duration=15)  # fmt: skip
    assert trace.agents["ego"].lane[-1] == -2


def test_change_lane_goes_on_where_the_one_ahead_stops_during_the_change() -> None:
    (trace,) = drive("""
    road street { draw with segments { pieces: [straight(300m)] }, lanes: 2, oneway: true }
    agent cab is car on street at 60m {
      lane: -2, drive with traffic { speed: 11m/s }, drive with stop_at { station: 120m }
    }
    agent ego is car on street at behind(cab, 12m) {
      drive with traffic { speed: 13m/s }
      drive with change_lane { to: left, when: cab.speed < 2m/s }
    }
    agent flow is car on street at 40m { lane: -1, count: 3, spacing: 20m, drive with traffic }
    """, duration=30)  # fmt: skip
    assert trace.events == ()
    assert trace.agents["ego"].station[-1] > trace.agents["cab"].station[-1] + 10.0
