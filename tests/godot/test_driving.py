"""Cars with real tires: they keep their lane, slide out where physics says, and repeat exactly."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.api import Control, Observation, Scene, SceneActor, SceneRoad, Trace
from roadlang.ir.scene import Call
from roadlang_godot.build.layout import layout_of
from roadlang_godot.drive import driving
from roadlang_godot.drive.simulate import Settings, drive_batch, drive_in
from roadlang_godot.net.session import Session
from tests.godot.godot_scenes import bend, bends, call, car, pieces, road, scene, straight, thing

pytestmark = pytest.mark.godot


def driven(session: Session, made: Scene, duration: float = 70.0) -> Trace:
    return drive_in(session, made, Settings(duration=duration), {})


def pursuit(speed: float) -> Call:
    """Constant speed: it does not slow down for bends."""
    options: dict[str, Any] = {
        "lookahead": 1.0,
        "lookahead_time": 0.4,
        "lateral_acceleration": 100.0,
    }
    return call("pure_pursuit", speed=speed, **options)


@pytest.mark.parametrize(
    ("kind", "widest"),
    [("pure_pursuit", 1.0), ("stanley", 0.4), ("lane_follow", 0.4), ("car_follow", 0.6)],
)
def test_a_car_at_15_m_s_keeps_to_bends_of_37_m(session: Session, kind: str, widest: float) -> None:
    """At 0.62 g tires slip: as much as in the embedded engine."""
    bent = bends()
    chosen = pursuit(15.0) if kind == "pure_pursuit" else call(kind, speed=15.0)
    ego = car("ego", bent, 5.0, chosen)
    trace = driven(session, scene(bent, agents=[ego], world={"friction": 1.0}))
    assert trace.agents["ego"].progress[-1] == 1.0  # so that `ego.progress >= 100%` is reached
    assert trace.agents["ego"].speed.max() == pytest.approx(15.0, abs=0.6)
    assert np.abs(trace.agents["ego"].cross_track_error).max() <= widest


def circle(friction: float, speed: float) -> tuple[Scene, SceneRoad]:
    ring = road("ring", pieces(straight(160), bend(60, 350)), width=9.0)
    ego = car("ego", ring, 3.0, call("lane_follow", speed=speed, lateral_acceleration=100.0))
    return scene(ring, agents=[ego], world={"friction": friction}), ring


@pytest.mark.parametrize("friction", [0.5, 0.9])
def test_a_car_slides_out_where_friction_ends(session: Session, friction: float) -> None:
    limit = math.sqrt(friction * 9.81 * 60.0)
    inside = driven(session, circle(friction, 0.85 * limit)[0], 45)
    assert np.abs(inside.agents["ego"].cross_track_error).max() < 1.3
    beyond = driven(session, circle(friction, 1.15 * limit)[0], 45)
    assert np.abs(beyond.agents["ego"].cross_track_error).max() > 3.0


def test_two_drives_of_one_scene_are_equal_to_the_last_bit(session: Session) -> None:
    bent = bends()
    cars = [car(f"car[{i}]", bent, 5.0 + 9 * i, call("car_follow", speed=12.0)) for i in range(5)]
    made = scene(bent, agents=cars)
    one, two = driven(session, made, 20), driven(session, made, 20)
    for name, agent in one.agents.items():
        for column in ("x", "y", "heading", "speed", "steering", "cross_track_error"):
            assert getattr(agent, column).tobytes() == getattr(two.agents[name], column).tobytes()


def test_a_car_brakes_when_its_condition_comes_true(session: Session) -> None:
    main = road("main", pieces(straight(300)))
    when = {
        "formula": {"<": ["d", 30.0]},
        "signals": {"d": {"kind": "distance", "options": {"first": "ego", "second": "van"}}},
    }
    brake = call("brake", when=when, deceleration=6.0)
    ego = car("ego", main, 5.0, call("lane_follow", speed=15.0, acceleration=3.0), brake)
    made = scene(main, agents=[ego], objects=[thing("parked_van", 200.0, 0.0, 5, 2, 2, "van")])
    agent = driven(session, made, 25).agents["ego"]
    stopped = agent.x[-1]
    assert agent.speed[-1] == pytest.approx(0.0, abs=0.1)
    assert stopped == pytest.approx(170.0 + 15.0**2 / (2 * 6.0), abs=1.5)
    assert agent.contacts.max() == 0


def test_a_condition_may_divide_by_the_speed_at_rest(session: Session) -> None:
    """1 / 0 is infinite, so the brakes are not on before the car is fast."""
    when = {
        "formula": {"<": [{"/": [1.0, "v"]}, 0.2]},
        "signals": {"v": {"kind": "speed", "options": {"agent": "ego"}}},
    }
    ego = car("ego", bends(), 5.0, call("lane_follow", speed=9.0), call("brake", when=when))
    speed = driven(session, scene(bends(), agents=[ego]), 8).agents["ego"].speed
    assert 4.9 < speed.max() < 5.2
    assert speed[-1] < 0.1


def test_a_follower_keeps_its_distance(session: Session) -> None:
    main = road("main", pieces(straight(500)))
    lead = car("lead", main, 60.0, call("lane_follow", speed=8.0))
    ego = car("ego", main, 5.0, call("car_follow", speed=20.0, headway=1.5, gap=2.0))
    trace = driven(session, scene(main, agents=[ego, lead]), 40)
    gap = trace.agents["lead"].x - trace.agents["ego"].x - 4.5
    assert gap.min() > 2.0
    assert trace.agents["ego"].speed[-1] == pytest.approx(8.0, abs=0.3)
    assert gap[-1] == pytest.approx(2.0 + 8.0 * 1.5, abs=3.0)


@pytest.mark.parametrize("height", [1.0, 1.75])
def test_who_is_struck_gives_way_and_takes_momentum(session: Session, height: float) -> None:
    main = road("main", pieces(straight(120)), width=8.0)
    stands = car("walker", main, 40.0, kind="pedestrian", offset=0.0)
    walker = replace(stands, height=height)
    ego = replace(car("ego", main, 20.0, call("brake", deceleration=0.1)), start_speed=15.0)
    made = layout_of(scene(main, agents=[ego, walker]), python_driven={"ego", "walker"})
    session.begin(made.settings(60), clear=True)
    session.update(made.parts)
    states = []
    with driving.LockStep(session) as lock:
        for _ in range(240):
            controls = {number: driving.EngineControl.steer(0.0, 0.0) for number in (1, 2)}
            states.append(lock.step(controls))
    (contact,) = np.concatenate([state.contacts for state in states])
    speeds = np.array([state.poses["speed"] for state in states])
    struck = int(np.diff(speeds[:, 0]).argmin()) + 1
    before, after = speeds[struck - 1, 0], speeds[struck, 0]
    mass = 75.0 * (height / 1.75) ** 3
    assert contact["speed"] == pytest.approx(before, rel=0.02)
    assert after / before == pytest.approx(1200.0 / (1200.0 + mass), rel=0.01)
    assert speeds[struck, 1] == pytest.approx(after, rel=0.02)
    x = np.array([state.poses["x"][1] for state in states])
    assert speeds[-1, 1] == 0.0
    assert x[-1] - x[0] == pytest.approx(after**2 / 12.0, rel=0.05), "slides with 6 m/s^2"


def test_a_cone_is_pushed_away_and_stands_again_in_the_next_drive(session: Session) -> None:
    main = road("main", pieces(straight(200)), width=8.0)
    cones = [thing("cone", 40.0, y, 0.4, 0.4, 0.7, name=f"cone{y:+g}") for y in (-0.6, 0.6)]
    ego = replace(car("ego", main, 10.0, call("pure_pursuit", speed=15.0)), start_speed=15.0)
    layout = layout_of(scene(main, agents=[ego], objects=cones))
    drives = []
    for built_anew in (True, True, False):
        if built_anew:
            session.begin(layout.settings(60), clear=True)
            session.update(layout.parts)
        drives.append(driving.run(session, 300))
    first, second, again = (drive.trace for drive in drives)
    assert first["x"][-1] + layout.frame.x > 70.0
    assert first["speed"].min() > 14.0
    struck = drives[0].contacts
    names = {layout.objects[int(c["other"])][int(c["index"])] for c in struck}
    assert names == {"cone-0.6", "cone+0.6"}
    assert first.tobytes() == second.tobytes()
    assert struck.tobytes() == drives[1].contacts.tobytes()
    assert len(drives[2].contacts) == len(struck), "they stand where they stood"
    np.testing.assert_allclose(again["speed"], first["speed"], atol=0.2)
    session.prove()


class Steady:
    """A controller in Python: pure pursuit, written with what an observation has."""

    def __init__(self, speed: float) -> None:
        self.speed = speed
        self.steps = 0

    def control(self, seen: Observation) -> Control:
        self.steps += 1
        x, y, _, _ = seen.line_ahead(7.0)
        rear_x = seen.x - 0.5 * seen.wheelbase * math.cos(seen.heading)
        rear_y = seen.y - 0.5 * seen.wheelbase * math.sin(seen.heading)
        bearing = math.atan2(y - rear_y, x - rear_x) - seen.heading
        away = math.hypot(x - rear_x, y - rear_y)
        steering = math.atan2(2 * seen.wheelbase * math.sin(bearing), away)
        return Control(steering, max(-6.0, min(3.0, 2.0 * (self.speed - seen.speed))))


def test_a_controller_in_python_drives_in_lock_step(session: Session) -> None:
    bent = bends()
    ego: SceneActor = car("ego", bent, 5.0, call("acme.steady"))
    controller = Steady(13.0)
    made = scene(bent, agents=[ego], world={"friction": 1.0})
    settings = Settings(duration=75.0, step=1 / 60)
    trace = drive_in(session, made, settings, {"ego": controller})  # type: ignore[dict-item]
    assert trace.agents["ego"].progress[-1] == 1.0  # so that `ego.progress >= 100%` is reached
    assert np.abs(trace.agents["ego"].cross_track_error).max() < 0.6
    assert controller.steps >= len(trace.time) - 1


def test_worlds_of_one_engine_do_not_touch_each_other(session: Session) -> None:
    main = road("main", pieces(straight(120), bend(50, 90), straight(60)))

    def at(speed: float) -> Scene:
        return scene(main, agents=[car("ego", main, 5.0, call("lane_follow", speed=speed))])

    speeds = [6.0, 9.0, 12.0]
    settings = Settings(duration=12.0)
    together = drive_batch(session, [at(speed) for speed in speeds], settings)
    for speed, trace in zip(speeds, together, strict=True):
        alone = drive_in(session, at(speed), settings, {})
        # Three worlds run until the slowest is done, so compare what both have.
        count = min(len(alone.time), len(trace.time))
        assert trace.agents["ego"].x[:count] == pytest.approx(alone.agents["ego"].x[:count])
