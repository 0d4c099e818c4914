"""Cars obey first principles: braking distance, one circle of friction, drag, power, crashes."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import CURB_HEIGHT, Scene, vehicle_parameters
from roadlang.ir.scene_surface import SurfaceName, SurfacePatch
from roadlang.simulation.lanes.surfaces import SURFACES
from roadlang_godot.build.layout import layout_of
from roadlang_godot.drive import driving
from roadlang_godot.net.session import Session
from roadlang_godot.net.telemetry import Records
from roadlang_standard.engine_tables import BODIES
from tests.godot.godot_scenes import bend, call, car, pieces, road, scene, straight, thing

pytestmark = pytest.mark.godot

RATE = 60
GRAVITY = 9.81
LONG = road("long", pieces(straight(900)))


def driven(session: Session, made: Scene, seconds: float) -> driving.GodotDrive:
    build(session, made)
    return driving.run(session, round(seconds * RATE))


def build(session: Session, made: Scene) -> None:
    layout = layout_of(made)
    session.begin(layout.settings(RATE), clear=True)
    session.update(layout.parts)
    session.prove()


def accelerations(trace: Records) -> np.ndarray:
    """(T, 2) over the ground, averaged over 0.1 s."""
    velocity = np.stack([trace["velocity_x"], trace["velocity_y"]], axis=1).astype(float)
    slope = np.gradient(velocity, 1 / RATE, axis=0)
    mean = np.ones(6) / 6
    return np.stack([np.convolve(slope[:, i], mean, "valid") for i in (0, 1)], axis=1)


@pytest.mark.parametrize(("friction", "speed"), list(product((0.3, 0.6, 1.0), (10.0, 20.0, 35.0))))
def test_the_braking_distance_is_that_of_friction_and_drag(
    session: Session, friction: float, speed: float
) -> None:
    ego = replace(car("ego", LONG, 50.0, call("brake", deceleration=20.0)), start_speed=speed)
    trace = driven(session, scene(LONG, agents=[ego], world={"friction": friction}), 16).trace
    numbers = vehicle_parameters(ego, BODIES["car"])
    slowing = friction * GRAVITY + numbers.rolling
    expected = math.log(1 + numbers.drag * speed**2 / slowing) / (2 * numbers.drag)
    assert trace["speed"][0] == pytest.approx(speed)
    assert trace["x"][-1] - trace["x"][0] == pytest.approx(expected, rel=0.05)
    stands = trace["x"][trace["tick"] > trace["tick"][-1] - 2 * RATE]
    assert np.ptp(stands) < 1e-4


@pytest.mark.parametrize(
    ("offset", "world", "names"),
    [
        (0.0, {"weather": "snow"}, ("snow",)),
        (8.0, {}, ("turf",)),
        (-8.0, {"weather": "rain"}, ("turf",)),
        (3.5, {}, ("asphalt", "turf")),
    ],
)
def test_cars_have_the_grip_and_the_resistance_of_what_is_below_their_wheels(
    session: Session, offset: float, world: dict[str, str], names: tuple[SurfaceName, ...]
) -> None:
    ego = replace(car("ego", LONG, 50.0, offset=offset), start_speed=20.0)
    numbers = vehicle_parameters(ego, BODIES["car"])
    below = [SURFACES[name] for name in names]
    rolling = sum(surface.rolling for surface in below) / len(below) * GRAVITY + numbers.rolling
    friction = sum(surface.friction for surface in below) / len(below)
    for acceleration, braking in ((-20.0, friction * GRAVITY), (0.0, 0.0)):
        build(session, scene(LONG, agents=[ego], world=world))
        with driving.LockStep(session) as lock:
            control = {1: driving.EngineControl.steer(0.0, acceleration)}
            lock.step(control, 30)  # off the road, the ground is 5 cm lower
            speeds = [float(lock.step(control, 15).poses["speed"][0]) for _ in range(2)]
        lost = (speeds[0] - speeds[1]) / (15 / RATE)
        drag = numbers.drag * (sum(speeds) / 2) ** 2
        assert lost == pytest.approx(braking + rolling + drag, rel=0.05)


SPLIT = replace(LONG, surface="gravel", surface_patches=(SurfacePatch("ice", 40.0, 200.0, (-1,)),))


@pytest.mark.parametrize(
    ("start", "names"), [(210.0, ("gravel",)), (50.0, ("gravel", "ice")), (45.0, ("ice",))]
)
def test_the_wheels_of_each_side_have_the_grip_of_the_surface_below_them(
    session: Session, start: float, names: tuple[SurfaceName, ...]
) -> None:
    offset = -1.75 if names == ("ice",) else 0.0
    ego = replace(car("ego", SPLIT, start, offset=offset), start_speed=20.0)
    numbers = vehicle_parameters(ego, BODIES["car"])
    below = [SURFACES[name] for name in names]
    grip = sum(surface.friction + surface.rolling for surface in below) / len(below) * GRAVITY
    build(session, scene(SPLIT, agents=[ego]))
    with driving.LockStep(session) as lock:
        control = {1: driving.EngineControl.steer(0.0, -20.0)}
        lock.step(control, 10)
        states = [lock.step(control, 15).poses[0] for _ in range(2)]
    lost = (states[0]["speed"] - states[1]["speed"]) / (15 / RATE)
    drag = numbers.drag * float(states[0]["speed"] + states[1]["speed"]) ** 2 / 4
    # Turned by the difference, the car slides a little aside.
    within = 0.05 if len(names) == 1 else 0.12
    assert lost == pytest.approx(grip + numbers.rolling + drag, rel=within)
    turned = float(states[1]["heading"])
    assert turned > 0.01 if len(names) == 2 else abs(turned) < 1e-3


def test_commands_below_the_grip_are_followed_and_power_and_drag_limit_the_speed(
    session: Session,
) -> None:
    ego = replace(car("ego", LONG, 5.0, call("brake", deceleration=3.0)), start_speed=20.0)
    slowed = driven(session, scene(LONG, agents=[ego]), 3).trace
    numbers = vehicle_parameters(ego, BODIES["car"])
    drag = numbers.drag * 20.0**2 + numbers.rolling
    assert (slowed["speed"][30] - slowed["speed"][0]) / 0.5 == pytest.approx(-3.0 - drag, rel=0.05)
    fast = replace(car("ego", LONG, 5.0), start_speed=45.0)
    build(session, scene(LONG, agents=[fast]))
    with driving.LockStep(session) as lock:
        for _ in range(12):
            state = lock.step({1: driving.EngineControl.steer(0.0, 9.0)}, 60)
    top = next(v for v in np.arange(20.0, 90.0, 0.01)
               if numbers.power / v <= numbers.drag * v * v + numbers.rolling)  # fmt: skip
    assert 45.0 < float(state.poses["speed"][0]) <= top
    build(session, scene(LONG, agents=[replace(fast, start_speed=float(top))]))
    with driving.LockStep(session) as lock:
        state = lock.step({1: driving.EngineControl.steer(0.0, 9.0)}, 240)
    assert float(state.poses["speed"][0]) == pytest.approx(top, rel=0.02)


@pytest.mark.parametrize(
    ("friction", "speed"), [(0.9, 10.0), (1.0, 10.0), (0.3, 15.0), (0.6, 20.0), (0.9, 25.0)]
)
def test_the_peak_lateral_acceleration_is_that_of_friction(
    session: Session, friction: float, speed: float
) -> None:
    field = road("field", pieces(straight(400)), width=300.0)
    ego = replace(car("ego", field, 150.0), start_speed=speed)
    build(session, scene(field, agents=[ego], world={"friction": friction}))
    places = []
    with driving.LockStep(session) as lock:
        for step in range(300):
            pose = lock.state.poses[0]
            places.append((float(pose["x"]), float(pose["y"])))
            hold = 2.0 * (speed - float(pose["speed"]))
            lock.step({1: driving.EngineControl.steer(0.0015 * step, hold)})
    velocity = np.gradient(np.array(places), 1 / RATE, axis=0)
    slope = np.gradient(velocity, 1 / RATE, axis=0)
    lateral = velocity[:, 0] * slope[:, 1] - velocity[:, 1] * slope[:, 0]
    lateral = np.convolve(lateral / np.hypot(*velocity.T), np.ones(6) / 6, "valid")
    assert 0.95 <= lateral[:-6].max() / (friction * GRAVITY) <= 1.02


@pytest.mark.parametrize("friction", [0.3, 0.6, 0.9])
def test_braking_in_a_bend_uses_no_more_than_the_grip_and_widens_the_bend(
    session: Session, friction: float
) -> None:
    speed = 0.92 * math.sqrt(friction * GRAVITY * 60.0)
    ring = road("ring", pieces(straight(60), bend(60, 350)), width=12.0)
    when = {
        "formula": {">": ["s", 150.0]},
        "signals": {"s": {"kind": "station", "options": {"agent": "ego"}}},
    }
    follow = call("lane_follow", speed=speed, lateral_acceleration=100.0)
    ego = car("ego", ring, 5.0, follow, call("brake", when=when, deceleration=8.0))
    made = scene(ring, agents=[replace(ego, start_speed=speed)], world={"friction": friction})
    trace = driven(session, made, 30).trace
    numbers = vehicle_parameters(ego, BODIES["car"])
    resistance = numbers.drag * speed**2 + numbers.rolling
    most = np.hypot(*accelerations(trace).T).max()
    assert most <= 1.05 * friction * GRAVITY + resistance
    assert most >= 0.9 * friction * GRAVITY
    assert trace["speed"][-1] == pytest.approx(0.0, abs=0.01)


def test_a_braking_car_dives_and_load_moves_to_the_front(session: Session) -> None:
    """Seen in what it does: in a bend the lighter rear slides, and the car turns in."""
    ring = road("ring", pieces(straight(60), bend(60, 350)), width=30.0)
    yaw = {}
    for braking in (0.0, 4.0):
        ego = replace(car("ego", ring, 70.0), start_speed=18.0)
        build(session, scene(ring, agents=[ego], world={"friction": 0.9}))
        with driving.LockStep(session) as lock:
            lock.step({1: driving.EngineControl.steer(0.055, 0.0)}, 60)
            before = float(lock.state.poses["heading"][0])
            speed = float(lock.state.poses["speed"][0])
            lock.step({1: driving.EngineControl.steer(0.055, -braking)}, 20)
            turned = math.remainder(float(lock.state.poses["heading"][0]) - before, math.tau)
            mean = 0.5 * (speed + float(lock.state.poses["speed"][0]))
        yaw[braking] = turned / mean
    assert yaw[4.0] > 1.05 * yaw[0.0]


def test_a_contact_says_with_whom_and_how_hard(session: Session) -> None:
    ego = replace(car("ego", LONG, 50.0), start_speed=15.0)
    lead = replace(car("lead", LONG, 75.0), start_speed=5.0)
    box = thing("barrier", 140.0, 0.0, 1.0, 4.0, 1.0, "box")
    build(session, scene(LONG, agents=[ego, lead], objects=[box]))
    touched = []
    with driving.LockStep(session) as lock:
        for _ in range(600):
            state = lock.step({1: driving.EngineControl.steer(0.0, 0.0),
                               2: driving.EngineControl.steer(0.0, 0.0)})  # fmt: skip
            touched += list(state.contacts)
    first = touched[0]
    assert (first["agent"], first["other"], first["index"]) in ((1, 2, -1), (2, 1, -1))
    assert first["speed"] == pytest.approx(10.0, abs=0.4)
    with_box = [one for one in touched if one["index"] == 0]
    assert [one["agent"] for one in with_box] == [2]
    assert with_box[0]["speed"] == pytest.approx(9.5, abs=1.5)


def test_raised_lanes_are_solid(session: Session) -> None:
    text = """
    road main {
      draw with segments { pieces: [straight(60m)] }
      left: [drive(3m), sidewalk(2m)], right: [drive(3m), sidewalk(2m)]
    }
    agent child is pedestrian on main at 20m { side: right, offset: -1m, drive with walk }
    """
    made = testing.sample(text)[0].record
    build(session, made)
    frame = layout_of(made).frame
    heights = [session.probe(30.0 - frame.x, y - frame.y) for y in (0.0, 4.0, -4.0)]
    assert heights == pytest.approx([0.0, CURB_HEIGHT, CURB_HEIGHT], abs=1e-3)
    walker = driving.run(session, RATE).trace
    assert walker["z"][-1] == pytest.approx(CURB_HEIGHT, abs=1e-3)
