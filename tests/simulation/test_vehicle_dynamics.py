"""The car obeys first principles: braking, cornering, the circle of friction, top speed."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.ir.scene import SceneActor
from roadlang.simulation.lanes.surfaces import TireSurface
from roadlang.simulation.lines.line_sources import straight_line
from roadlang.simulation.lines.lines import Lines
from roadlang.simulation.vehicles import vehicle_dynamics as vehicle
from roadlang.simulation.vehicles.bodies import Bodies, Body, vehicle_parameters
from roadlang.simulation.vehicles.motion import Motion, Track, advance

DT = 0.02
CAR = SceneActor(
    "ego", "ego", "car", 0, 0, 0, 4.5, 1.8, 1.5,
    options={"mass": 1500.0, "wheelbase": 2.7, "max_steering": 0.61},
)  # fmt: skip


def car(speed: float, friction: float, body: Body | None = None) -> tuple[Motion, Bodies, Track]:
    """A car on an endless plane at a speed."""
    lines = Lines.of([straight_line(0.0, 0.0, 0.0)], 0.0)
    track = Track.of(lines, np.array([0]))
    values = [np.array([value]) for value in (0.0, 0.0, speed, 0, 0, 1.0, 0, 0, 0, 0)]
    motion = Motion(*(value.astype(float) for value in values))
    return motion, Bodies.of([CAR], [TireSurface(friction)], {"car": body or Body()}, DT), track


def go(parts: tuple[Motion, Bodies, Track], tangent: float, acceleration: float, n: int) -> Motion:
    motion, bodies, track = parts
    advance(motion, bodies, track, (np.array([tangent]), np.array([acceleration])), n, DT)
    return motion


@pytest.mark.parametrize("friction", [0.3, 0.5, 0.9])
@pytest.mark.parametrize("speed", [10.0, 20.0, 35.0])
def test_braking_distance_follows_from_friction_and_drag(speed: float, friction: float) -> None:
    parts = car(speed, friction)
    go(parts, 0.0, -30.0, 2000)
    drag = float(parts[1].drag[0])
    a0 = (friction + 0.012) * vehicle.GRAVITY
    expected = np.log(1 + drag * speed**2 / a0) / (2 * drag)
    assert parts[0].speed[0] == 0.0
    assert parts[0].along[0] == pytest.approx(expected, rel=0.01)


def peak_lateral(speed: float, friction: float, acceleration: float) -> float:
    """The greatest lateral acceleration while the wheel is turned slowly, at one speed."""
    parts = car(speed, friction)
    motion, peak = parts[0], 0.0
    for tangent in np.linspace(0.0, 0.5, 500):
        motion.speed[:] = speed
        slide, yaw_rate = motion.slide[0], motion.yaw_rate[0]
        go(parts, float(tangent), acceleration, 1)
        lateral = (motion.slide[0] - slide) / DT + speed * yaw_rate
        peak = max(peak, abs(float(lateral)))
    return peak


@pytest.mark.parametrize("friction", [0.3, 0.6, 0.9])
@pytest.mark.parametrize("speed", [12.0, 20.0, 30.0])
def test_lateral_acceleration_peaks_at_the_grip(speed: float, friction: float) -> None:
    assert 0.95 <= peak_lateral(speed, friction, 0.0) / (friction * vehicle.GRAVITY) <= 1.02


@given(
    st.floats(0, 60), st.floats(-8, 8), st.floats(-2, 2), st.floats(-0.7, 0.7),
    st.floats(-1, 1), st.floats(0.05, 1.2), st.floats(-12, 12),
)  # fmt: skip
def test_no_axle_ever_has_more_force_than_grip(
    vx: float, vy: float, yaw_rate: float, tangent: float, used: float, mu: float, ax: float
) -> None:
    load = vehicle.loads(ax, 0.16)
    slopes = (vehicle.FRONT_STIFFNESS / (3 * mu), vehicle.REAR_STIFFNESS / (3 * mu))
    tires = (1.35, mu, *slopes, vehicle.SLOW * DT)
    front_x, front_y, rear_x, rear_y = vehicle.forces(vx, vy, yaw_rate, tangent, used, load, tires)
    assert np.hypot(front_x, front_y) <= mu * load[0] * (1 + 1e-9)
    assert np.hypot(rear_x, rear_y) <= mu * load[1] * (1 + 1e-9)
    assert load[0] + load[1] == pytest.approx(vehicle.GRAVITY)


def test_braking_in_a_bend_costs_lateral_grip() -> None:
    grip = 0.8 * vehicle.GRAVITY
    assert peak_lateral(25.0, 0.8, -6.0) < 0.93 * peak_lateral(25.0, 0.8, 0.0)
    assert peak_lateral(25.0, 0.8, -30.0) < 0.8 * grip


@pytest.mark.parametrize("friction", [0.35, 0.6])
@pytest.mark.parametrize("speed", [18.0, 33.0])
def test_tires_alone_change_the_velocity_of_a_car_that_spins(speed: float, friction: float) -> None:
    parts = car(speed, friction)
    motion, bodies, _ = parts
    motion.slide[:], motion.yaw_rate[:] = -0.6 * speed, 1.5
    greatest = friction * vehicle.GRAVITY + bodies.drag[0] * speed**2 * 2 + 0.012 * vehicle.GRAVITY
    velocities = []
    for _ in range(300):
        go(parts, 0.3, 4.0, 1)
        along, left = motion.speed[0], motion.slide[0]
        east = along * motion.cosine[0] - left * motion.sine[0]
        velocities.append((east, along * motion.sine[0] + left * motion.cosine[0]))
    changes = np.hypot(*np.diff(velocities, axis=0).T) / DT
    assert motion.speed.min() >= 0.0
    assert changes.max() <= 1.05 * greatest


def test_power_and_drag_limit_the_speed() -> None:
    parts = car(30.0, 0.9)
    motion = go(parts, 0.0, 30.0, 20_000)
    top = float(motion.speed[0])
    drag, rolling = float(parts[1].drag[0]), float(parts[1].rolling[0])
    assert 66.0 / top == pytest.approx(drag * top**2 + rolling, rel=1e-3)
    assert 55 < top < 70


@pytest.mark.parametrize("tangent", [-0.6, 0.0, 0.6])
def test_what_stands_with_the_brake_on_stays(tangent: float) -> None:
    parts = car(0.0, 0.9)
    motion = go(parts, tangent, -9.0, 2000)
    assert (motion.along[0], motion.offset[0], motion.yaw_rate[0]) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("speed", [0.5, 2.0, 5.0])
def test_slowly_it_drives_the_circle_of_its_wheels(speed: float) -> None:
    parts = car(speed, 0.9, Body(drag_area=0.0, rolling=0.0))
    motion = go(parts, 0.3, 0.0, 300)
    assert motion.yaw_rate[0] == pytest.approx(motion.speed[0] * 0.3 / 2.7, rel=0.05)


@pytest.mark.parametrize("speed", [0.0, 1.0, 4.0, 12.0, 30.0, 60.0])
@pytest.mark.parametrize("friction", [0.05, 0.3, 0.9, 1.2])
def test_straight_on_it_is_stable_after_a_push(speed: float, friction: float) -> None:
    parts = car(speed, friction)
    parts[0].slide[:] = 0.2
    motion = go(parts, 0.0, 0.3, 300)
    assert abs(motion.slide[0]) < 0.01
    assert abs(motion.yaw_rate[0]) < 0.01


@pytest.mark.parametrize("friction", [0.2, 0.5, 1.1])
def test_a_car_on_other_ground_is_as_one_that_was_built_there(friction: float) -> None:
    others = [replace(CAR, options={**CAR.options, "mass": mass}) for mass in (900.0, 2500.0)]
    kinds = {"car": Body()}
    ground, other = TireSurface(0.9), TireSurface(friction)
    built = Bodies.of([CAR, *others], [ground, other, other], kinds, DT)
    rows = np.array([1, 2])
    moved = Bodies.of([CAR, *others], [ground] * 3, kinds, DT).on_ground(
        rows, built.friction[rows], built.rolling[rows]
    )
    for field in fields(Bodies):
        found, expected = (getattr(one, field.name) for one in (moved, built))
        np.testing.assert_allclose(found, expected, rtol=1e-12, err_msg=field.name)
    np.testing.assert_allclose(moved.stacked, built.stacked, rtol=1e-12)
    for found, expected in zip(moved.columns, built.columns, strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_the_numbers_of_a_car_are_those_of_its_options_and_its_kind() -> None:
    body = Body(drag_area=0.8, rolling=0.02, power=50.0, mass_height=0.4)
    found = vehicle_parameters(CAR, body)
    assert (found.mass, found.wheelbase, found.max_steering) == (1500.0, 2.7, 0.61)
    assert found.drag == pytest.approx(0.5 * 1.2 * 0.8 / 1500.0)
    assert found.rolling == pytest.approx(0.02 * 9.81, rel=1e-3)
    assert found.power == 50.0
    assert found.mass_height == pytest.approx(0.4 * 1.5)
    usual = vehicle_parameters(replace(CAR, options={}), body)
    assert usual.mass == 1500.0
    assert usual.wheelbase == pytest.approx(0.6 * 4.5)
    odd = replace(CAR, options={"mass": 0.0, "wheelbase": 0.0, "max_steering": 3.0})
    least = vehicle_parameters(odd, body)
    assert (least.mass, least.wheelbase, least.max_steering) == (1e-3, 0.05, 1.5)
    assert vehicle_parameters(CAR) == vehicle_parameters(CAR, Body())
