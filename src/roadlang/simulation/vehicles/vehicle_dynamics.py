"""The motion of a car for one short time step: a dynamic bicycle on brush tires.

One source for two machines: the formulas use `+ - * /`, `sqrt`, `least` and `greatest` alone, so
that numpy on arrays and numba on numbers give the same bits.

- single track model with load transfer: R. Rajamani, Vehicle Dynamics and Control, ch. 2 and 4
- brush tire (cubic in the slip, saturated): H. B. Pacejka, Tire and Vehicle Dynamics, ch. 3
- a friction circle for each axle shares the grip between braking and cornering
"""

from __future__ import annotations

from typing import Any

import numpy as np

GRAVITY = 9.81
"""m/s^2"""
HALF = 0.5 * GRAVITY
"""m/s^2: load of an axle of a car that does not accelerate"""
FRONT_STIFFNESS = 12.0
"""cornering stiffness of the front axle for each newton of load, 1/rad: less than at the rear, so
that the car understeers"""
REAR_STIFFNESS = 14.0
SLOW = 1.2 * REAR_STIFFNESS * GRAVITY
"""m/s for each second of the time step: below it, slip angles are those at this speed, or the
equations would be too stiff for the step"""
LEAST_POWER_SPEED = 1.0
"""m/s: below it, the engine's force is that at this speed"""
LEAST_SCALE = 0.1
"""how much shorter the inside of a bend may be than its middle, at most"""


def least(a: Any, b: Any) -> Any:
    """The lesser of two, as compiled loops have it too."""
    return np.minimum(a, b)


def greatest(a: Any, b: Any) -> Any:
    """The greater of two."""
    return np.maximum(a, b)


def steered(tangent: Any, wanted: Any, lag: Any, rate: Any) -> Any:
    """The tangent of the steering angle after one step.

    It approaches what is wanted (`lag` is the share of the difference that one step closes) at no
    more than `rate` radians for each step.
    """
    most = rate * (1.0 + tangent * tangent)
    return tangent + least(greatest(approach(tangent, wanted, lag), -most), most)


def approach(tangent: Any, wanted: Any, lag: Any) -> Any:
    """What `steered` adds where the steering is not too slow for it."""
    return (wanted - tangent) * lag


def brush(slip: Any) -> Any:
    """Share of the grip that a tire uses, -1 to 1, at a slip of 1 where it begins to slide."""
    return brush_share(least(greatest(slip, -1.0), 1.0))


def brush_share(slip: Any) -> Any:
    """The same of a slip within -1 and 1."""
    return slip * (3.0 - 3.0 * np.abs(slip) + slip * slip)


def demand(wanted: Any, speed: Any, power: Any, grip: Any, dt: float) -> Any:
    """Share of the grip that drive or brakes use, -1 to 1.

    `wanted`: acceleration; `power`: of the engine, W/kg; `grip`: friction times gravity. Brakes
    hold what stands, and do not push it back.
    """
    driven = least(wanted, power / greatest(speed, LEAST_POWER_SPEED))
    held = greatest(driven, -speed / dt)
    return least(greatest(held / grip, -1.0), 1.0)


def forces(vx: Any, vy: Any, yaw_rate: Any, tangent: Any, used: Any, load: Any, car: Any) -> Any:
    """Forces of the axles for each kilogram of the car, in its own axes: front and rear, each along
    and to the left, m/s^2. `load`: of the front and the rear axle; `used`: of the grip, by drive or
    brakes. `car`: distance of the axles, friction, slopes of the tires, least speed of slips.
    """
    half_base, friction, front_slope, rear_slope, slow = car
    swing = half_base * yaw_rate
    side = vy + swing
    front_slip = (side - vx * tangent) / greatest(vx + side * tangent, slow)
    rear_slip = (vy - swing) / greatest(vx, slow)
    front = brush(front_slip * front_slope)
    rear = brush(rear_slip * rear_slope)
    of_both = used * used
    front_grip = friction * load[0] / greatest(np.sqrt(of_both + front * front), 1.0)
    rear_grip = friction * load[1] / greatest(np.sqrt(of_both + rear * rear), 1.0)
    return axle_forces(tangent, used, (front, rear), (front_grip, rear_grip))


def axle_forces(tangent: Any, used: Any, share: Any, grip: Any) -> Any:
    """What `forces` gives. `share`, of the front and the rear axle: of the grip that they use to
    the side; `grip`: what they have of it, m/s^2."""
    cosine = 1.0 / np.sqrt(1.0 + tangent * tangent)
    along, right = used * grip[0], share[0] * grip[0]
    return (
        (along + right * tangent) * cosine,
        (along * tangent - right) * cosine,
        used * grip[1],
        -share[1] * grip[1],
    )


def loads(acceleration: Any, transfer: Any) -> Any:
    """Load of the front and the rear axle for each kilogram of the car, m/s^2; the center of mass
    lies between them. `transfer`: its height over the wheelbase."""
    return loads_after(least(greatest(transfer * acceleration, -HALF), HALF))


def loads_after(moved: Any) -> Any:
    """The same where so much of it moves from the front to the rear axle."""
    return HALF - moved, HALF + moved


def accelerated(motion: Any, force: Any, half_base: Any, inertia: Any, drag: Any, dt: float) -> Any:
    """Speeds after a step: along, to the left, yaw rate; and the acceleration along the car.

    Nothing rolls backward: who spins turns until it slides sideways, and slides on like that.
    `motion`: the same before; `inertia`: square of the radius of gyration, m^2; `drag`: quadratic
    in 1/m and rolling resistance in m/s^2.
    """
    vx = motion[0]
    drag = (drag[0], least(drag[1], vx / dt))
    ahead, left, turning, along = pushed(motion, force, half_base, inertia, drag, dt)
    across = ahead <= 0.0
    return (
        greatest(greatest(ahead, (vx + along * dt) * across), 0.0),
        left,
        turning * (ahead > 0.0),
        along,
    )


def pushed(motion: Any, force: Any, half_base: Any, inertia: Any, drag: Any, dt: float) -> Any:
    """The same of a car that goes on ahead and does not stop within the step."""
    vx, vy, yaw_rate = motion
    front_along, front_left, rear_along, rear_left = force
    along = front_along + rear_along - drag[0] * vx * vx - drag[1]
    return (
        vx + (along + vy * yaw_rate) * dt,
        vy + (front_left + rear_left - vx * yaw_rate) * dt,
        yaw_rate + half_base * (front_left - rear_left) / inertia * dt,
        along,
    )


def walked(motion: Any, tangent: Any, wanted: Any, half_base: Any, dt: float) -> Any:
    """What `accelerated` gives, of someone on foot: no tires, no sliding."""
    speed = greatest(motion[0] + wanted * dt, 0.0)
    return speed, 0.0 * speed, speed * tangent / (2.0 * half_base), wanted


def displaced(along: Any, left: Any, cosine: Any, sine: Any, offset: Any, curvature: Any) -> Any:
    """Speeds along and to the left of the line, whose curvature is that at the foot point.

    `cosine`, `sine`: of the car's heading from that of the line.
    """
    scale = greatest(1.0 - offset * curvature, LEAST_SCALE)
    return (along * cosine - left * sine) / scale, along * sine + left * cosine


def turned(cosine: Any, sine: Any, angle: Any) -> Any:
    """Cosine and sine of an angle that grows by a small one (Cayley; exact to `angle^3 / 12`)."""
    half = 0.5 * angle
    square = half * half
    scale = 1.0 / (1.0 + square)
    along, across = (1.0 - square) * scale, angle * scale
    return cosine * along - sine * across, sine * along + cosine * across


def driven(motion: Any, tangent: Any, before: Any, wanted: Any, car: Any, dt: float) -> Any:
    """Speeds after a step, along, to the left and yaw rate, and the acceleration along the car.

    `before`: the acceleration in the last step; `car`: axles, friction, slopes, least speed of
    slips, power, grip, load transfer, inertia, drag and rolling resistance, as `Bodies` has them.
    """
    half_base, friction, front_slope, rear_slope, slow, power, grip, transfer, inertia = car[:9]
    used = demand(wanted, motion[0], power, grip, dt)
    load = loads(before, transfer)
    tires = (half_base, friction, front_slope, rear_slope, slow)
    force = forces(motion[0], motion[1], motion[2], tangent, used, load, tires)
    return accelerated(motion, force, half_base, inertia, (car[9], car[10]), dt)


def moved(place: Any, speeds: Any, direction: Any, curvature: Any, dt: float) -> Any:
    """Arc length and offset after a step. `speeds`: along before and after it, to the left;
    `direction`: cosine and sine of the heading from that of the line."""
    along = 0.5 * (speeds[0] + speeds[1])
    ds, dn = displaced(along, speeds[2], direction[0], direction[1], place[1], curvature)
    return place[0] + ds * dt, place[1] + dn * dt
