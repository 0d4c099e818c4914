"""The car that is driven: a chassis with four wheels, of which two are steered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from roadlang.api import body_of, vehicle_parameters
from roadlang_standard.engine_tables import BODIES

from .elements import put

if TYPE_CHECKING:
    from roadlang.api import SceneActor

_GRAVITY = 9.81
_WHEEL_SHARE = 0.012
"""Of the mass, for each wheel."""
_STEERING = (100.0, 0.01)
"""For each kilogram of the car: N m for each radian, and kg m^2 about the steering axis."""
_SECONDS = 0.4
"""In which the drive makes up for most of a difference in speed."""
_LOW = 0.35
"""Height of the center of mass, at most, for each meter of width."""
_ROOM = 0.02
"""Meters between the wheels and the sides of the car."""


@dataclass(frozen=True)
class Wheels:
    """Radius and width, and where they are: ± `x` and ± `y` from the middle, meters."""

    radius: float
    width: float
    x: float
    y: float


def wheels_of(actor: SceneActor, wheelbase: float) -> Wheels:
    """Of a vehicle of this size."""
    radius = min(0.5, 0.22 * actor.height, 0.2 * wheelbase)
    width = min(0.25, 0.15 * actor.width)
    return Wheels(radius, width, wheelbase / 2.0, (actor.width - width) / 2.0 - _ROOM)


def put_car(world: Element, actor: SceneActor, height: float, friction: float) -> None:
    """The body of the car, standing on ground of a height."""
    numbers = vehicle_parameters(actor, body_of(actor, BODIES))
    wheels = wheels_of(actor, numbers.wheelbase)
    length, width, tall = actor.length, actor.width, actor.height
    mass = numbers.mass * (1.0 - 4.0 * _WHEEL_SHARE)
    body = put(world, "body", name=actor.name, pos=(actor.x, actor.y, height))
    body.set("euler", f"0 0 {actor.heading:.9g}")
    put(body, "freejoint", name=actor.name)
    inertia = ((width, tall), (length, tall), (length, width))
    put(
        body,
        "inertial",
        # Low enough to slide before it tips over, also where it is as narrow as a bicycle.
        pos=(0.0, 0.0, min(numbers.mass_height, _LOW * width)),
        mass=mass,
        diaginertia=tuple(mass * (a * a + b * b) / 12.0 for a, b in inertia),
    )
    low = 1.1 * wheels.radius
    for name, share, above, half in (
        ("chassis", 1.0, low, 0.3 * tall),
        ("cabin", 0.55, low + 0.6 * tall, (tall - low - 0.6 * tall) / 2.0),
    ):
        if half > 0.0:
            size = (share * length / 2.0, width / 2.0, half)
            pos = (0.0, 0.0, above + half)
            put(body, "geom", name=f"{actor.name} {name}", type="box", size=size, pos=pos)
            body[-1].set("class", "chassis")
    for end, x in (("front", wheels.x), ("rear", -wheels.x)):
        for side, y in (("left", wheels.y), ("right", -wheels.y)):
            name = f"{actor.name} {end} {side}"
            wheel = put(body, "body", name=name, pos=(x, y, wheels.radius))
            if end == "front":
                turns = (-numbers.max_steering, numbers.max_steering)
                steering = put(wheel, "joint", name=f"{actor.name} steering {side}", range=turns)
                steering.set("class", "steering")
                steering.set("armature", f"{_STEERING[1] * numbers.mass:.6g}")
            put(wheel, "joint", name=name).set("class", "axle")
            tire_size = (wheels.radius, wheels.width / 2.0)
            tire = put(wheel, "geom", name=name, size=tire_size, mass=_WHEEL_SHARE * numbers.mass)
            tire.set("class", "tire")
            tire.set("friction", f"{friction:.6g} 0.005 0.0001")


def put_defaults(defaults: Element) -> None:
    """Classes that the parts of cars have in common."""
    steering = put(defaults, "default", class_="steering")
    put(steering, "joint", type="hinge", axis=(0, 0, 1))
    axle = put(defaults, "default", class_="axle")
    put(axle, "joint", type="hinge", axis=(0, 1, 0), armature=0.1, damping=0.1)
    tire = put(defaults, "default", class_="tire")
    put(tire, "geom", type="cylinder", zaxis=(0, 1, 0), rgba=(0.06, 0.06, 0.06, 1), condim=4)
    chassis = put(defaults, "default", class_="chassis")
    put(chassis, "geom", rgba=(0.12, 0.37, 0.66, 1), mass=0)


def put_controls(root: Element, actor: SceneActor, friction: float) -> None:
    """Two controls: the steering angle (radians, left positive) and the speed of the rear axle
    (radians a second), which drives both wheels as an open differential does."""
    numbers = vehicle_parameters(actor, body_of(actor, BODIES))
    radius = wheels_of(actor, numbers.wheelbase).radius
    name = actor.name
    equality = put(put(root, "equality"), "joint", polycoef=(0, 1, 0, 0, 0))
    equality.set("joint1", f"{name} steering right")
    equality.set("joint2", f"{name} steering left")
    axle = put(put(root, "tendon"), "fixed", name=f"{name} axle")
    for side in ("left", "right"):
        put(axle, "joint", joint=f"{name} rear {side}", coef=0.5)
    actuators = put(root, "actuator")
    limit = (-numbers.max_steering, numbers.max_steering)
    steering = put(actuators, "position", name=f"{name} steering", ctrlrange=limit)
    steering.set("kp", f"{_STEERING[0] * numbers.mass:.6g}")
    steering.set("joint", f"{name} steering left")
    steering.set("dampratio", "1")
    most = min(friction, 1.0) * numbers.mass * _GRAVITY * radius / 2.0
    drive = put(actuators, "velocity", name=f"{name} drive", forcerange=(-most, most))
    drive.set("tendon", f"{name} axle")
    drive.set("kv", f"{numbers.mass * radius * radius / _SECONDS:.6g}")
