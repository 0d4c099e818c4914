"""Vehicles keep to their lines: fast, in lane changes, and where no controller steers."""

from __future__ import annotations

import numpy as np
import pytest

from .driven_roads import drive, driven

FAST = """
road main {
  draw with segments { pieces: [straight(700m)] }
  lanes: 3, oneway: true
}
agent ego is KIND on main at 10m {
  lane: -1, start_speed: SPEED
  drive with lane_follow { speed: SPEED }
  drive with change_lane { to: right, duration: 3s, when: time > 2s }
}
"""


@pytest.mark.parametrize(
    ("kind", "speed"), [("car", 25), ("car", 45), ("car", 60), ("van", 35), ("truck", 25)]
)
def test_it_changes_lanes_without_swinging_at_any_speed(kind: str, speed: int) -> None:
    ego = driven(FAST.replace("KIND", kind).replace("SPEED", f"{speed}m/s"), duration=9)
    assert ego.lane[-1] == -2
    assert np.abs(ego.cross_track_error).max() < 0.9
    assert np.abs(ego.lane_offset[-10:]).max() < 0.15


def test_a_cut_in_with_two_seconds_for_the_change_stays_on_the_road_in_a_bend() -> None:
    (trace,) = drive("""
    road motorway {
      draw with segments { pieces: [straight(200m), arc(500m, 40deg), straight(400m)] }
      lanes: 3, oneway: true
    }
    agent ego is car on motorway at 40m { lane: -2, drive with car_follow { speed: 110km/h } }
    agent cutter is car on motorway at 15m {
      lane: -1, drive with lane_follow { speed: 125km/h }
      drive with cut_in { target: ego, gap: 10m, duration: 2s, when: cutter.station > ego.station }
    }
    """, duration=25)  # fmt: skip
    cutter = trace.agents["cutter"]
    assert cutter.lane[-1] == -2
    assert cutter.off_road.max() < 0.0


def test_a_maneuver_without_a_controller_before_it_follows_the_road() -> None:
    ego = driven("""
    road bend { draw with segments { pieces: [straight(50m), arc(100m, 90deg)] }, lanes: 2 }
    agent ego is car on bend at 10m {
      start_speed: 10m/s, drive with speed_profile { points: [(0m, 10m/s), (100m, 6m/s)] }
    }
    """, duration=15)  # fmt: skip
    assert ego.station[-1] > 120.0
    assert np.abs(ego.cross_track_error).max() < 0.3
