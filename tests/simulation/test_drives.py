"""Whole drives in the embedded engine: what traces say, triggers, contacts, the end of a road."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Control, Controller, Observation, Speed, option
from roadlang.ir.trace import AgentTrace, Trace

from .driven_roads import drive, driven, straight

BEND = """
road main {
  draw with segments { pieces: [straight(60m), arc(30m, 90deg), straight(60m)] }
  width: 7m
  lanes: 2
}
agent ego is car on main at 5m { lane: LANE, drive with CONTROLLER }
"""


@pytest.mark.parametrize("controller", ["lane_follow", "pure_pursuit", "stanley", "car_follow"])
@pytest.mark.parametrize("lane", ["-1", "1"])
def test_the_lane_is_kept_to_the_end_of_the_road(controller: str, lane: str) -> None:
    text = BEND.replace("LANE", lane).replace("CONTROLLER", f"{controller} {{ speed: 12m/s }}")
    ego = driven(text)
    assert np.abs(ego.cross_track_error).max() < 0.7
    assert ego.progress[-1] == 1.0
    assert np.diff(ego.station).min() >= 0 if lane == "-1" else True
    lateral = np.gradient(ego.heading, ego.time) * ego.speed
    assert np.percentile(np.abs(lateral), 90) < 5.2  # 4.5, and more where the bend begins


def test_positions_speed_and_station_agree() -> None:
    ego = driven(BEND.replace("LANE", "-1").replace("CONTROLLER", "stanley { speed: 9m/s }"))
    moved = np.hypot(np.diff(ego.x), np.diff(ego.y)) / np.diff(ego.time)
    middle = 0.5 * (ego.speed[1:] + ego.speed[:-1])
    there = ego.present[1:] == 1.0
    assert np.abs(moved - middle)[there].max() < 0.1
    direction = np.unwrap(np.arctan2(np.diff(ego.y), np.diff(ego.x))[there])
    assert np.abs(direction - ego.heading[1:][there])[20:].max() < 0.12


def test_a_car_that_brakes_late_on_a_slippery_road_slides_off_the_bend() -> None:
    text = BEND.replace("LANE", "-1").replace(
        "CONTROLLER", "pure_pursuit { speed: 18m/s, lateral_acceleration: 50m/s^2 }"
    )
    slid = driven(text + "world { friction: 0.4 }", duration=30)
    assert np.abs(slid.cross_track_error).max() > 2.0


def test_when_takes_over_for_good() -> None:
    text = straight(
        """drive with lane_follow { speed: 15m/s }
           drive with brake { deceleration: 5m/s^2, when: ego.station > 100m }"""
    )
    ego = driven(text, duration=20)
    braking = np.flatnonzero(ego.station > 100)[0]
    assert ego.speed[braking] == pytest.approx(15, abs=0.2)
    assert ego.speed[-1] == 0.0
    assert ego.station[-1] - 100 == pytest.approx(15**2 / 2 / 5.15, rel=0.15)


def test_conditions_may_look_back() -> None:
    text = straight(
        """drive with lane_follow { speed: 10m/s }
           drive with brake { when: historically[0s, 3s] (ego.speed > 9m/s and time > 5s) }"""
    )
    ego = driven(text, duration=20)
    assert ego.time[ego.speed < 9][-1] > 8
    assert ego.speed[ego.time < 8][-1] > 9


def test_a_pedestrian_crosses_and_stands() -> None:
    text = """
    road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] }, width: 8m }
    agent ego is pedestrian on main at 50m {
      side: right, offset: 1m
      drive with crossing { speed: 1.5m/s, beyond: 2m, when: time > 1s }
    }
    """
    ego = driven(text, duration=15)
    assert ego.y[0] < -4.5
    assert ego.y[-1] == pytest.approx(6.0, abs=0.3)
    assert ego.speed[-1] == pytest.approx(0.0, abs=1e-9)
    assert np.ptp(ego.x) < 0.1
    assert np.abs(ego.heading[ego.time > 2] - np.pi / 2).max() < 1e-6


def test_on_a_closed_road_a_drive_is_one_lap() -> None:
    text = """
    road main {
      draw with waypoints { points: [(0m, 0m), (60m, 0m), (60m, 60m), (0m, 60m)] }
      closed: true, width: 8m
    }
    agent ego is car on main at 20m { drive with pure_pursuit { speed: 8m/s } }
    """
    ego = driven(text, duration=120)
    assert ego.progress[-1] == 1.0
    assert np.hypot(ego.x[-1] - ego.x[0], ego.y[-1] - ego.y[0]) < 2.0
    assert np.abs(ego.cross_track_error).max() < 1.0
    assert (np.diff(ego.progress) > -1e-9).all()
    assert np.abs(np.diff(ego.heading)).max() < 0.5


TWO = """
road main {{ draw with waypoints {{ points: [(0m, 0m), (400m, 0m)] }}, width: 8m }}
agent ego is car on main at 5m {{ drive with lane_follow {{ speed: {speed}m/s }} }}
{other}
"""


def touched(trace: Trace) -> list[tuple[Any, Any]]:
    return [(event["agent"], event["other"]) for event in trace.events]


def test_a_crash_says_who_with_whom_and_how_hard_and_both_stand() -> None:
    other = "agent lead is car on main at 100m { drive with brake }"
    (trace,) = drive(TWO.format(speed=20, other=other), duration=20)
    assert touched(trace) == [("ego", "lead"), ("lead", "ego")]
    assert trace.events[0]["speed"] == pytest.approx(20, abs=2.5)
    ego, lead = trace.agents["ego"], trace.agents["lead"]
    assert ego.contacts[-1] == lead.contacts[-1] == 1
    assert ego.speed[-1] == 0
    assert lead.x[-1] - ego.x[-1] == pytest.approx(4.5, abs=1e-6)


def test_objects_are_solid() -> None:
    other = "object van is parked_van on main at 80m { lane: -1 }"
    (trace,) = drive(TWO.format(speed=15, other=other), duration=20)
    assert touched(trace) == [("ego", "van")]
    assert trace.agents["ego"].x[-1] == pytest.approx(80 - (4.5 + 5.9) / 2, abs=1e-6)


def test_nothing_passes_through_a_post_between_two_samples() -> None:
    other = "object post is box on main at 300m { length: 5cm, width: 5cm, lane: -1 }"
    (trace,) = drive(TWO.format(speed=60, other=other), duration=30, step=1.0, control_step=1.0)
    assert touched(trace) == [("ego", "post")]


def test_what_begins_inside_one_another_never_touches() -> None:
    other = "agent lead is car on main at 7m { overlap: true, drive with brake }"
    (trace,) = drive(TWO.format(speed=20, other=other), duration=2)
    assert trace.events == ()
    assert trace.agents["ego"].station[-1] > 20.0


def test_car_follow_enters_a_lower_speed_limit_at_that_speed() -> None:
    (trace,) = drive("""
    road town { draw with segments { pieces: [straight(150m)] }, lanes: 2, speed_limit: 50km/h }
    road school { draw with segments { pieces: [straight(150m)] }, lanes: 2, speed_limit: 30km/h }
    road street from town { then: school }
    agent ego is car on street at 10m { drive with car_follow }
    """, duration=25)  # fmt: skip
    ego = trace.agents["ego"]
    assert ego.speed.max() > 13.5
    assert (ego.speed - ego.speed_limit).max() < 0.3
    begins = ego.station[np.flatnonzero(ego.speed > 13.5)[-1]]
    needed = (ego.speed.max() ** 2 - (30 / 3.6) ** 2) / 2  # at half of the usual 2 m/s^2
    assert needed < 150.0 - begins < needed + ego.speed.max(), (needed, begins)


def test_car_following_keeps_its_gap() -> None:
    text = """
    road main { draw with waypoints { points: [(0m, 0m), (600m, 0m)] }, width: 8m }
    agent ego is car on main at 5m { drive with car_follow { speed: 20m/s } }
    agent lead is car on main at 40m { drive with lane_follow { speed: 10m/s } }
    """
    (trace,) = drive(text, duration=50)
    ego, lead = trace.agents["ego"], trace.agents["lead"]
    gap = lead.x - ego.x - 4.5
    late = (ego.time > 25) & (ego.time < 45)
    assert gap.min() > 2
    assert gap[late].mean() == pytest.approx(2 + 1.5 * 10, rel=0.15)
    assert trace.events == ()


@dataclass(frozen=True)
class Cautious(Controller):
    """Decides for one agent alone, and looks at the others."""

    name: ClassVar[str] = "cautious"
    speed: Speed = option(9.0, help="kept")

    def control(self, observation: Observation) -> Control:
        lead = observation.others["lead"]
        near = lead.x - observation.x < 25
        return Control(0.0, -5.0 if near else self.speed - observation.speed)


def test_a_controller_for_one_agent_is_looped_over() -> None:
    text = """
    road main { draw with waypoints { points: [(0m, 0m), (400m, 0m)] }, width: 8m }
    agent ego is car on main at 5m { drive with cautious { speed: (6m/s)..(12m/s) } }
    agent lead is car on main at 100m { drive with brake }
    """
    scenes = testing.sample(text, 3, kinds=[Cautious])
    for one in scenes.run("builtin", duration=30, control_step=0.1):
        ego: AgentTrace = one.trace.agents["ego"]
        assert ego.speed[-1] == 0
        assert 75 < ego.x[-1] < 94


def test_while_gives_back_to_the_one_before() -> None:
    text = straight(
        """drive with lane_follow { speed: 15m/s }
           drive with brake {
             speed: 5m/s, while: ego.station > 100m and ego.station < 200m
           }"""
    )
    ego = driven(text, duration=60)
    assert ego.speed[ego.station < 99].max() == pytest.approx(15, abs=0.2)
    assert ego.speed[(ego.station > 140) & (ego.station < 199)].max() < 5.3
    assert ego.speed[ego.station > 300].min() > 14


def test_when_and_while_together_must_both_hold() -> None:
    text = straight(
        """drive with lane_follow { speed: 15m/s }
           drive with brake { speed: 2m/s, when: time > 10s, while: ego.speed > 8m/s }"""
    )
    ego = driven(text, duration=20)
    assert ego.speed[ego.time < 10].max() > 14
    late = ego.speed[ego.time > 13]
    assert 7 < late.min() < late.max() < 11


def test_the_line_to_follow_is_the_middle_of_the_lane() -> None:
    text = """
    road main {
      draw with waypoints { points: [(0m, 0m), (300m, 0m)] }
      right: [drive(4m), parking(2m)], left: [drive(3m)]
    }
    agent ego is car on main at 5m { lane: -1, drive with lane_follow { speed: 9m/s } }
    """
    scene = testing.sample(text)[0]
    section = scene.record.roads[0].cross_section()
    ego = scene.run("builtin", duration=20, control_step=0.1).trace.agents["ego"]
    assert ego.y[-1] == pytest.approx(float(section.offset(-1, 100.0)), abs=0.02)
    assert abs(ego.cross_track_error[-1]) < 0.02


@pytest.mark.parametrize(("kind", "speed"), [("stanley", 45.0), ("car_follow", 36.0)])
def test_fast_cars_do_not_swing_after_a_bend(kind: str, speed: float) -> None:
    text = f"""
    road main {{
      draw with segments {{ pieces: [straight(200m), arc(400m, 40deg), straight(700m)] }}
      width: 8m
    }}
    agent ego is car on main at 20m {{
      start_speed: {speed}m/s
      drive with {kind} {{ speed: {speed}m/s, lateral_acceleration: 30m/s^2 }}
    }}
    """
    (drive,) = testing.sample(text, 1).run("builtin", duration=25, control_step=0.1)
    ego = drive.trace.agents["ego"]
    assert np.abs(ego.cross_track_error).max() < 2.5
    straight = ego.station > 700.0
    assert np.abs(ego.cross_track_error[straight]).max() < 0.1
