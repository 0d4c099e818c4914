"""Agents and objects as the entities of OpenSCENARIO."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from ..opendrive.elements import put

if TYPE_CHECKING:
    from roadlang.api import SceneActor


@dataclass(frozen=True)
class VehicleClass:
    """A category of OpenSCENARIO, and what roadlang's kinds do not say of such a vehicle: greatest
    speed (m/s), acceleration and deceleration (m/s^2), diameter of the wheels (m)."""

    category: str
    speed: float
    acceleration: float
    deceleration: float
    wheel: float
    role: str = "civil"
    tracks: int = 2


_CAR = VehicleClass("car", 70.0, 10.0, 10.0, 0.65)
_TRUCK = VehicleClass("truck", 40.0, 5.0, 8.0, 1.0)
_BICYCLE = VehicleClass("bicycle", 17.0, 3.0, 8.0, 0.68, tracks=1)
VEHICLES = {
    "car": _CAR,
    "taxi": _CAR,
    "police_car": VehicleClass("car", 70.0, 10.0, 10.0, 0.65, "police"),
    "van": VehicleClass("van", 55.0, 8.0, 10.0, 0.7),
    "ambulance": VehicleClass("van", 55.0, 8.0, 10.0, 0.7, "ambulance"),
    "truck": _TRUCK,
    "fire_truck": VehicleClass("truck", 40.0, 5.0, 8.0, 1.0, "fire"),
    "tractor": _TRUCK,
    "bus": VehicleClass("bus", 40.0, 5.0, 8.0, 1.0, "publicTransport"),
    "motorcycle": VehicleClass("motorbike", 80.0, 12.0, 10.0, 0.62, tracks=1),
    "bicycle": _BICYCLE,
    "scooter": _BICYCLE,
}
_ON_FOOT = {
    "pedestrian": "pedestrian",
    "child": "pedestrian",
    "animal": "animal",
    "dog": "animal",
}
_OBJECTS = {
    "tree": "tree",
    "bush": "vegetation",
    "hedge": "vegetation",
    "building": "building",
    "wall": "barrier",
    "fence": "barrier",
    "barrier": "barrier",
    "guardrail": "railing",
    "lamp": "streetLamp",
    "pole": "pole",
    "bollard": "pole",
    "sign": "pole",
    "traffic_light": "pole",
}
_TURNS = 0.6
"""Radians that front wheels turn where a kind does not say it."""


def wheelbase(actor: SceneActor) -> float:
    """Meters between the axles; 0 for who walks."""
    return float(actor.options.get("wheelbase", 0.0))


def rear_axle(actor: SceneActor, x: float, y: float, heading: float) -> tuple[float, float, float]:
    """The reference point of an entity, with its center at x and y: of a vehicle the middle of its
    rear axle, of all others the center."""
    back = 0.5 * wheelbase(actor)
    return x - back * math.cos(heading), y - back * math.sin(heading), heading


def vehicle_class(actor: SceneActor) -> VehicleClass | None:
    """None for who walks; kinds of plugins are cars where they have axles."""
    if actor.kind in _ON_FOOT or not wheelbase(actor):
        return None
    return VEHICLES.get(actor.kind, _CAR)


def put_agent(parent: Element, actor: SceneActor, unexpressed: Sequence[str]) -> None:
    """A `ScenarioObject`. `unexpressed`: controllers that it has in roadlang alone."""
    found = put(parent, "ScenarioObject", name=actor.name)
    vehicle = vehicle_class(actor)
    mass = float(actor.options.get("mass", 0.0))
    if vehicle is None:
        category = _ON_FOOT.get(actor.kind, "pedestrian")
        element = put(found, "Pedestrian", name=actor.kind, mass=mass, pedestrianCategory=category)
        _put_box(element, actor)
    else:
        element = put(
            found,
            "Vehicle",
            name=actor.kind,
            vehicleCategory=vehicle.category,
            role=vehicle.role,
            mass=mass,
        )
        _put_box(element, actor)
        put(
            element,
            "Performance",
            maxSpeed=vehicle.speed,
            maxAcceleration=vehicle.acceleration,
            maxDeceleration=vehicle.deceleration,
        )
        _put_axles(element, actor, vehicle)
    properties = put(element, "Properties")
    for number, controller in enumerate(unexpressed):
        put(properties, "Property", name=f"roadlang.drive.{number}", value=controller)


def put_object(parent: Element, thing: SceneActor) -> None:
    """A `ScenarioObject` that stands."""
    found = put(parent, "ScenarioObject", name=thing.name)
    element = put(
        found,
        "MiscObject",
        name=thing.kind,
        mass=float(thing.options.get("mass", 0.0)),
        miscObjectCategory=_OBJECTS.get(thing.kind, "obstacle"),
    )
    _put_box(element, thing)
    put(element, "Properties")


def _put_box(parent: Element, actor: SceneActor) -> None:
    box = put(parent, "BoundingBox")
    put(box, "Center", x=0.5 * wheelbase(actor), y=0.0, z=0.5 * actor.height)
    put(box, "Dimensions", length=actor.length, width=actor.width, height=actor.height)


def _put_axles(parent: Element, actor: SceneActor, vehicle: VehicleClass) -> None:
    axles = put(parent, "Axles")
    turns = float(actor.options.get("max_steering", _TURNS))
    track = 0.85 * actor.width if vehicle.tracks == 2 else 0.0
    for tag, steering, x in (
        ("FrontAxle", turns, wheelbase(actor)),
        ("RearAxle", 0.0, 0.0),
    ):
        put(
            axles,
            tag,
            maxSteering=steering,
            wheelDiameter=vehicle.wheel,
            trackWidth=track,
            positionX=x,
            positionZ=0.5 * vehicle.wheel,
        )
