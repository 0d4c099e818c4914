"""`change_lane`: to the lane that was said, smoothly, and only where there is room."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.ir.trace import AgentTrace, Trace

from .driven_roads import drive

ROAD = """
road main { draw with segments { pieces: [straight(900m)] }, lanes: 4, width: 14m }
"""
# The lanes lie at 5.25 and 1.75 m (back), -1.75 and -5.25 m (forth).
OUTER, INNER = -5.25, -1.75


def traffic(change: str, others: str = "", world: str = "", **options: float) -> Trace:
    text = (
        ROAD
        + f"""
    agent ego is car on main at 100m {{
      lane: -2, start_speed: 20m/s
      drive with lane_follow {{ speed: 20m/s }}
      drive with change_lane {{ {change}, when: time > 1s }}
    }}
    {others}
    {world}
    """
    )
    (trace,) = drive(text, duration=options.pop("duration", 12.0))
    return trace


def other(name: str, at: int, speed: int, lane: int = -1, facing: str = "forward") -> str:
    return f"""
    agent {name} is car on main at {at}m {{
      lane: {lane}, facing: {facing}, start_speed: {speed}m/s
      drive with lane_follow {{ speed: {speed}m/s }}
    }}"""


def sideways(ego: AgentTrace) -> tuple[float, float]:
    """Peak speed and acceleration across the road."""
    speed = np.gradient(ego.y, ego.time)
    return float(np.abs(speed).max()), float(np.abs(np.gradient(speed, ego.time)).max())


@pytest.mark.parametrize("time", [3.0, 6.0])
def test_the_peaks_are_those_of_the_quintic(time: float) -> None:
    ego = traffic(f"to: left, duration: {time}s").agents["ego"]
    speed, acceleration = sideways(ego)
    assert ego.y[-1] == pytest.approx(INNER, abs=0.02)
    assert 1.0 < speed / (1.875 * 3.5 / time) < 1.25
    assert 0.95 < acceleration / (5.774 * 3.5 / time**2) < 1.7  # the car swings a little
    assert np.abs(ego.speed - 20.0).max() < 0.3  # `lane_follow` keeps the speed


def test_a_distance_is_driven_at_the_speed_with_which_it_begins() -> None:
    ego = traffic("to: left, distance: 100m").agents["ego"]  # 5 s at 20 m/s
    assert sideways(ego)[0] == pytest.approx(1.875 * 3.5 / 5.0, rel=0.12)
    between = (ego.y > OUTER + 0.05) & (ego.y < INNER - 0.05)
    assert np.ptp(ego.x[between]) == pytest.approx(72.0, abs=8.0)


@pytest.mark.parametrize(("lane", "y"), [("-1", INNER), ("1", 1.75)])
def test_a_lane_may_be_said_by_its_id_even_of_oncoming_traffic(lane: str, y: float) -> None:
    assert traffic(f"to: {lane}").agents["ego"].y[-1] == pytest.approx(y, abs=0.05)


def test_the_lane_is_changed_while_a_later_controller_brakes() -> None:
    """`stop_at` leaves steering, and with it the line, to the change before it."""
    text = (
        ROAD
        + """
    agent ego is car on main at 100m {
      lane: -2, start_speed: 20m/s
      drive with lane_follow { speed: 20m/s }
      drive with change_lane { to: left, when: time > 1s }
      drive with stop_at { distance: 120m, deceleration: 2m/s^2 }
    }
    """
    )
    (trace,) = drive(text, duration=14.0)
    ego = trace.agents["ego"]
    assert ego.y[-1] == pytest.approx(INNER, abs=0.05)
    assert ego.x[-1] == pytest.approx(220.0, abs=0.3)


def test_the_last_controller_that_moves_the_line_decides_about_it() -> None:
    text = (
        ROAD
        + """
    agent ego is car on main at 100m {
      lane: -2, start_speed: 20m/s
      drive with lane_follow { speed: 20m/s }
      drive with change_lane { to: left, when: time > 1s }
      drive with change_lane { to: -2 }
      drive with brake { deceleration: 2m/s^2, when: time > 2s }
    }
    """
    )
    (trace,) = drive(text, duration=12.0)
    assert np.abs(trace.agents["ego"].y - OUTER).max() < 0.05


def test_there_is_no_change_to_where_there_is_no_lane() -> None:
    assert np.abs(traffic("to: right").agents["ego"].y - OUTER).max() < 0.01


def test_left_means_no_lane_of_oncoming_traffic() -> None:
    text = (
        ROAD
        + """
    agent ego is car on main at 100m {
      lane: -1, drive with lane_follow { speed: 20m/s }
      drive with change_lane { to: left, when: time > 1s }
    }
    """
    )
    (trace,) = drive(text, duration=8.0)
    assert np.abs(trace.agents["ego"].y - INNER).max() < 0.01


@pytest.mark.parametrize(
    ("at", "speed"),
    [(100, 20), (96, 20), (105, 20), (60, 35), (125, 5)],
    ids=["beside", "just behind", "just ahead", "fast from behind", "slow ahead"],
)
def test_a_change_waits_while_the_lane_is_occupied(at: int, speed: int) -> None:
    trace = traffic("to: left, duration: 3s", other("they", at, speed), duration=4.0)
    ego = trace.agents["ego"]
    if speed == 20:
        assert np.abs(ego.y - OUTER).max() < 0.05
    assert trace.events == ()


def test_with_force_nobody_looks() -> None:
    ego = traffic("to: left, force: true", other("they", 97, 20)).agents["ego"]
    assert ego.y.max() > OUTER + 1.0
    assert ego.contacts[-1] > 0


def test_who_waited_changes_when_the_other_has_gone_by() -> None:
    trace = traffic("to: left", other("they", 92, 26))
    ego, they = trace.agents["ego"], trace.agents["they"]
    begins = int(np.flatnonzero(ego.y > OUTER + 0.1)[0])
    assert they.x[begins] - ego.x[begins] > 4.5 + 1.5
    assert ego.y[-1] == pytest.approx(INNER, abs=0.05)
    assert trace.events == ()


def test_a_change_turns_back_when_its_room_is_taken() -> None:
    cutter = """
    agent they is car on main at 104m {
      lane: 1, start_speed: 20m/s
      drive with lane_follow { speed: 20m/s }
      drive with change_lane { to: -1, duration: 2s, force: true, when: time > 1.4s }
    }"""
    trace = traffic(
        "to: left, duration: 6s", cutter.replace("lane: 1,", "lane: 1, facing: forward,")
    )
    ego = trace.agents["ego"]
    peak = int(ego.y[ego.time < 6].argmax())
    assert OUTER + 0.1 < ego.y[peak] < 0.5 * (OUTER + INNER)
    assert ego.y[peak:].min() < ego.y[peak] - 0.05
    assert trace.events == ()


def test_who_brakes_for_something_ahead_waits_for_a_gap_that_stays() -> None:
    """The gap beside it is wide enough at its speed, but not once it has braked further."""
    text = """
    road motorway {
      draw with segments { pieces: [straight(500m)] }
      lanes: 2, oneway: true, speed_limit: 100km/h
    }
    object pallet is pallet on motorway at 300m { lane: -1 }
    agent ego is car on motorway at 30m {
      lane: -1
      drive with traffic
      drive with change_lane { to: right, when: gap(ego, pallet) < 120m }
    }
    agent beside is car on motorway at 15m {
      lane: -2, count: 3, spacing: 30m, drive with traffic
    }
    """
    (trace,) = drive(text, duration=20.0)
    assert trace.events == ()
    assert trace.agents["ego"].station[-1] > 330.0


def test_in_left_hand_traffic_all_is_mirrored() -> None:
    right = traffic("to: left", other("they", 92, 26))
    text = (
        ROAD
        + """
    agent ego is car on main at 100m {
      lane: 2, start_speed: 20m/s
      drive with lane_follow { speed: 20m/s }
      drive with change_lane { to: right, when: time > 1s }
    }
    agent they is car on main at 92m {
      lane: 1, start_speed: 26m/s, drive with lane_follow { speed: 26m/s }
    }
    world { traffic: left }
    """
    )
    (left,) = drive(text, duration=12.0)
    for name in ("ego", "they"):
        assert left.agents[name].y == pytest.approx(-right.agents[name].y, abs=1e-9)
        assert left.agents[name].x == pytest.approx(right.agents[name].x, abs=1e-9)
