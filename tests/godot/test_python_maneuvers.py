"""Maneuvers that Godot's project does not have itself: Python drives them there, in lock-step."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Trace
from roadlang.drive.controllers import python_controllers
from roadlang.plugins.discovery import load_registry
from roadlang_godot.drive.simulate import Settings, drive_in
from roadlang_godot.net.session import Session

pytestmark = pytest.mark.godot

EXAMPLES = Path(__file__).parents[2] / "examples"

ROAD = """
road main { draw with segments { pieces: [straight(500m)] }, lanes: 4, width: 14m }
"""
OUTER, INNER = -5.25, -1.75


def driven(session: Session, text: str, duration: float) -> Trace:
    scene = testing.sample(text)[0].record
    settings = Settings(duration=duration, step=0.05)
    return drive_in(session, scene, settings, python_controllers(scene, load_registry()))


def test_a_lane_change_and_a_speed_profile_with_conditions(session: Session) -> None:
    text = (
        ROAD
        + """
    agent ego is car on main at 20m {
      lane: -2, start_speed: 14m/s
      drive with lane_follow { speed: 14m/s }
      drive with change_lane { to: left, duration: 3s, when: time > 2s }
      drive with speed_profile { points: [(0m, 14m/s), (60m, 7m/s)], when: ego.station > 150m }
      drive with stop_at { station: 260m, when: ego.station > 230m }
    }
    """
    )
    ego = driven(session, text, 30.0).agents["ego"]
    assert np.abs(ego.y[ego.time < 2] - OUTER).max() < 0.1
    after = (ego.time > 7) & (ego.station < 250)
    assert ego.y[after] == pytest.approx(np.full(after.sum(), INNER), abs=0.15)
    speed = np.gradient(ego.y, ego.time)
    assert speed.max() == pytest.approx(1.875 * 3.5 / 3.0, rel=0.25)
    assert np.interp(220.0, ego.station, ego.speed) == pytest.approx(7.0, abs=0.6)
    assert ego.station[-1] == pytest.approx(260.0, abs=1.0)


def test_a_cut_in_before_a_car_that_godot_itself_drives(session: Session) -> None:
    text = (
        ROAD
        + """
    agent ego is car on main at 60m {
      lane: -2, start_speed: 12m/s, drive with lane_follow { speed: 12m/s }
    }
    agent cutter is car on main at 35m {
      lane: -1, start_speed: 12m/s
      drive with lane_follow { speed: 12m/s }
      drive with cut_in { target: ego, gap: 10m, when: time > 1s }
    }
    """
    )
    trace = driven(session, text, 25.0)
    ego, cutter = trace.agents["ego"], trace.agents["cutter"]
    assert trace.events == ()
    assert cutter.y[-1] == pytest.approx(OUTER, abs=0.2)
    there = int(np.flatnonzero(np.abs(cutter.y - ego.y) < 0.2)[0])
    assert cutter.x[there] - ego.x[there] - 4.5 == pytest.approx(10.0, abs=2.0)


def test_a_pedestrian_walks_along_the_edge(session: Session) -> None:
    text = (
        ROAD
        + """
    agent ego is pedestrian on main at 60m { side: right, offset: 1.5m, drive with walk }
    """
    )
    ego = driven(session, text, 12.0).agents["ego"]
    assert ego.x[-1] - ego.x[0] == pytest.approx(1.4 * 12, abs=1.5)
    assert ego.y[-1] == pytest.approx(-7.5, abs=0.2)


def recording(folders: pytest.TempPathFactory, text: str) -> Path:
    file = folders.mktemp("replay") / "recorded.csv"
    file.write_text(text, encoding="utf-8")
    return file


def test_an_agent_goes_where_a_recording_had_it(
    session: Session, tmp_path_factory: pytest.TempPathFactory
) -> None:
    file = recording(tmp_path_factory, "time,x,y,heading\n0,20,0,0\n4,60,0,0\n8,100,4,0.1\n")
    text = (
        ROAD
        + f"""
    agent ego is car on main at 20m {{ lane: none, drive with replay {{ file: "{file}" }} }}
    """
    )
    ego = driven(session, text, 8.0).agents["ego"]
    assert np.interp([2.0, 4.0], ego.time, ego.x) == pytest.approx([40.0, 60.0], abs=0.6)
    assert (ego.x[-1], ego.y[-1]) == pytest.approx((100.0, 4.0), abs=0.6)
    assert np.interp(2.0, ego.time, ego.speed) == pytest.approx(10.0, abs=0.5)


def test_who_goes_by_a_recording_is_moved_by_physics_after_a_crash(
    session: Session, tmp_path_factory: pytest.TempPathFactory
) -> None:
    file = recording(tmp_path_factory, "time,x,y,heading\n0,20,-5.25,0\n10,120,-5.25,0\n")
    text = (
        ROAD
        + f"""
    agent ego is car on main at 20m {{ lane: -2, drive with replay {{ file: "{file}" }} }}
    agent van is van on main at 70m {{ lane: -2, drive with stop_at {{ station: 70m }} }}
    """
    )
    trace = driven(session, text, 10.0)
    event = next(one for one in trace.events if one["agent"] == "ego")
    assert event["other"] == "van"
    assert event["speed"] == pytest.approx(10.0, abs=0.3)
    assert trace.agents["ego"].x[-1] < 70.0
    assert trace.agents["ego"].speed[-1] < 0.1
    assert trace.agents["ego"].collision[-1] == event["speed"]


def test_traffic_obeys_a_signal_and_every_column_of_a_trace_is_known(session: Session) -> None:
    text = (EXAMPLES / "signals.rl").read_text(encoding="utf-8")
    scene = testing.sample(text)[0].record
    settings = Settings(duration=40.0, step=0.05)
    controllers = python_controllers(scene, load_registry())
    trace = drive_in(session, scene, settings, controllers)
    cars = [trace.agents[actor.name] for actor in scene.agents]
    assert all(car.red_light.max() == 0 and car.contacts.max() == 0 for car in cars)
    assert any((car.speed[car.time > 2] < 0.2).any() for car in cars), "nobody has waited"
    assert np.mean([car.route_progress[-1] for car in cars]) > 60.0
    for car in cars:
        for column in ("road", "lane", "lane_offset", "speed_limit", "off_road", "progress"):
            assert np.isfinite(getattr(car, column)).all(), column
        assert car.off_road.max() < 0.3
    settings = Settings(duration=10.0, step=0.05)
    again = drive_in(session, scene, settings, python_controllers(scene, load_registry()))
    for name, agent in again.agents.items():
        assert agent.x.tobytes() == trace.agents[name].x[: len(agent.x)].tobytes()


def test_any_drive_signal_begins_a_controller(session: Session) -> None:
    text = (
        ROAD
        + """
    agent ego is car on main at 20m {
      lane: -2, start_speed: 14m/s
      drive with lane_follow { speed: 14m/s }
      drive with brake { when: ego.route_progress > 60m and ego.lane == -2 and ego.off_road < 0m }
    }
    """
    )
    ego = driven(session, text, 12.0).agents["ego"]
    braked = ego.x[np.flatnonzero(ego.acceleration < -3.0)[0]]
    assert braked == pytest.approx(80.0, abs=2.5)
    assert ego.speed[-1] < 0.1


@pytest.mark.parametrize("never", ["ego.speed > 99m/s", "ego.lane == 7"])
def test_who_arrives_leaves_whether_the_engine_or_python_drives(
    session: Session, never: str
) -> None:
    """The engine does not know lanes: there Python decides."""
    text = (
        ROAD
        + f"""
    agent lead is car on main at 460m {{
      lane: -2, start_speed: 14m/s, drive with lane_follow {{ speed: 14m/s }}
    }}
    agent ego is car on main at 430m {{
      lane: -2, start_speed: 14m/s
      drive with lane_follow {{ speed: 14m/s }}
      drive with brake {{ when: {never} }}
    }}
    """
    )
    trace = driven(session, text, 20.0)
    assert trace.agents["ego"].progress[-1] == 1.0
    assert trace.agents["lead"].present[-1] == 0.0
    assert trace.events == ()


STREET = """
road main { draw with segments { pieces: [straight(200m)] }, lanes: 2 }
agent walker is pedestrian on main at 60m { side: right, offset: 1m, drive with crossing }
"""


def test_a_pedestrian_crosses_and_a_car_that_does_not_look_touches_it(session: Session) -> None:
    crossed = driven(session, STREET, 8.0).agents["walker"]
    assert crossed.y[0] == pytest.approx(-4.8, abs=0.05)
    assert crossed.y[-1] == pytest.approx(3.5 + 1.0, abs=0.1)
    assert np.ptp(crossed.x) == pytest.approx(0.0, abs=0.05)
    ego = "agent ego is car on main at 22m { drive with lane_follow { speed: 14m/s } }\n"
    hit = driven(session, STREET + ego, 8.0)
    assert hit.agents["ego"].contacts.max() >= 1
    assert hit.events[0]["event"] == "contact"


def test_a_pedestrian_does_not_walk_into_a_van_that_stands_in_the_way(session: Session) -> None:
    van = "agent van is van on main at 60.5m { start_speed: 0m/s }\n"
    trace = driven(session, STREET + van, 14.0)
    assert trace.agents["van"].contacts.max() == 0
    assert trace.agents["walker"].y[-1] == pytest.approx(3.5 + 1.0, abs=0.2)
