"""Agents and objects as the entities of OpenSCENARIO."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from roadlang.api import ON_FOOT, vehicle_parameters

from ..opendrive.elements import put
from ..opendrive.objects import object_type

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
    tracks: int = 2


_CAR = VehicleClass("car", 70.0, 10.0, 10.0, 0.65)
VEHICLES = {
    "van": VehicleClass("van", 55.0, 8.0, 10.0, 0.7),
    "truck": VehicleClass("truck", 40.0, 5.0, 8.0, 1.0),
    "tractor": VehicleClass("truck", 40.0, 5.0, 8.0, 1.0),
    "bus": VehicleClass("bus", 40.0, 5.0, 8.0, 1.0),
    "motorcycle": VehicleClass("motorbike", 80.0, 12.0, 10.0, 0.62, tracks=1),
    "bicycle": VehicleClass("bicycle", 17.0, 3.0, 8.0, 0.68, tracks=1),
}
_ROLES = {"police": "police", "ambulance": "ambulance", "fire": "fire"}
_TURNS = 0.6
"""Radians that front wheels turn where a kind does not say it."""


def wheelbase(actor: SceneActor) -> float:
    """Meters between the axles of an agent; 0 for who walks."""
    return 0.0 if actor.category in ON_FOOT else vehicle_parameters(actor).wheelbase


def rear_axle(actor: SceneActor, x: float, y: float, heading: float) -> tuple[float, float, float]:
    """The reference point of an entity, with its center at x and y: of a vehicle the middle of its
    rear axle, of all others the center."""
    back = 0.5 * wheelbase(actor)
    return x - back * math.cos(heading), y - back * math.sin(heading), heading


def vehicle_class(actor: SceneActor) -> VehicleClass | None:
    """None for who walks."""
    return None if actor.category in ON_FOOT else VEHICLES.get(actor.category, _CAR)


def put_agent(parent: Element, actor: SceneActor, unexpressed: Sequence[str]) -> None:
    """A `ScenarioObject`. `unexpressed`: controllers that it has in roadlang alone."""
    found = put(parent, "ScenarioObject", name=actor.name)
    vehicle = vehicle_class(actor)
    mass = float(actor.options.get("mass", 0.0))
    if vehicle is None:
        element = put(found, "Pedestrian", name=actor.kind, mass=mass)
        element.set("pedestrianCategory", actor.category)
        _put_box(element, actor, 0.0)
    else:
        element = put(
            found,
            "Vehicle",
            name=actor.kind,
            vehicleCategory=vehicle.category,
            role="publicTransport" if actor.category == "bus" else _ROLES.get(actor.role, "civil"),
            mass=mass,
        )
        _put_box(element, actor, wheelbase(actor))
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
        miscObjectCategory=object_type(thing),
    )
    _put_box(element, thing, 0.0)
    put(element, "Properties")


def _put_box(parent: Element, actor: SceneActor, base: float) -> None:
    box = put(parent, "BoundingBox")
    put(box, "Center", x=0.5 * base, y=0.0, z=0.5 * actor.height)
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
