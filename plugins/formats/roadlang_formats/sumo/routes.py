"""Agents as vehicles of SUMO: types, routes over edges, and where they depart."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

from ..opendrive.elements import put
from .edges import SumoEdge, in_order
from .persons import PersonTrip, put_walks, walk_of
from .places import places_of
from .vehicle_classes import class_of, has_wheels

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor

    from .network import SumoNetwork

_SPEEDS = {"bicycle": 7.0, "truck": 36.0, "bus": 24.0}
"""m/s at most; others 55."""
_FASTEST = 55.0
_BRAKING, _REACTION = 3.5, 1.0
"""m/s^2 and seconds of the vehicles that SUMO gives the least and the most of them."""
_OPTIONS = {"acceleration": "accel", "deceleration": "decel", "headway": "tau", "gap": "minGap"}
"""Options of controllers that SUMO's models have, by its names."""
_LEAST = {"accel": 0.1, "decel": 0.5, "tau": 0.1, "minGap": 0.1}


@dataclass(frozen=True)
class Trip:
    """A vehicle with its edges. `lane` is the number of the first lane, or what SUMO chooses."""

    actor: SceneActor
    edges: tuple[SumoEdge, ...]
    lane: str
    position: float
    speed: float


def trips_of(scene: Scene, network: SumoNetwork) -> list[Trip]:
    """Of the agents that drive on the network; who has no road is left out."""
    found = [_trip(scene, network, actor) for actor in scene.agents if has_wheels(actor)]
    return [trip for trip in found if trip is not None]


def walks_of(scene: Scene, network: SumoNetwork) -> list[PersonTrip]:
    """Of the agents who walk along a sidewalk."""
    found = [walk_of(scene, network, agent, places_of(scene, agent)) for agent in scene.agents]
    return [walk for walk in found if walk is not None]


def _trip(scene: Scene, network: SumoNetwork, actor: SceneActor) -> Trip | None:
    places = places_of(scene, actor)
    edges: list[SumoEdge] = []
    for place in places:
        of_road = in_order(network.by_road.get(place.road, ()), not place.back)
        low, high = min(place.start, place.stop), max(place.start, place.stop)
        inside = [edge for edge in of_road if edge.stop > low and edge.start < high]
        edges += inside or sorted(of_road, key=lambda edge: _beyond(edge, place.start))[:1]
    if not edges:
        return None
    first = edges[0]
    number = first.index(actor.lane) if actor.lane is not None else None
    can_start = number is not None and _may_use(first, number, actor)
    type_ = _type_of(actor)
    limit = min(lane.speed for lane in first.lanes) * float(type_["speedFactor"])
    start = places[0].start
    share = (start - first.start) / max(first.stop - first.start, 1e-9)
    share = share if first.forward else 1.0 - share
    # SUMO counts to the front bumper.
    position = min(max(share * first.length + 0.5 * actor.length, 0.0), first.length)
    slow = _stopping_speed(first.length - position, type_)
    speed = min(actor.start_speed or 0.0, limit, float(type_["maxSpeed"]), slow)
    return Trip(
        actor,
        tuple(edges),
        str(number) if can_start else "best",
        position,
        math.floor(speed * 1000.0) / 1000.0,
    )


def _stopping_speed(distance: float, type_: Mapping[str, str]) -> float:
    """m/s from which a vehicle can stop within a distance in meters: SUMO lets no faster one depart
    before a junction where it may have to yield."""
    braking = float(type_.get("decel", _BRAKING))
    reaction = braking * float(type_.get("tau", _REACTION))
    return math.sqrt(reaction * reaction + 2.0 * braking * distance) - reaction


def _may_use(edge: SumoEdge, number: int, actor: SceneActor) -> bool:
    allowed = edge.lanes[number].permissions.split()
    return not allowed or class_of(actor) in allowed


def _beyond(edge: SumoEdge, station: float) -> float:
    """Meters from a station to an edge of its road."""
    return max(edge.start - station, station - edge.stop, 0.0)


def routes_text(trips: Sequence[Trip], walks: Sequence[PersonTrip] = ()) -> str:
    """The `.rou.xml`."""
    root = Element("routes")
    types: dict[tuple[tuple[str, str], ...], str] = {}
    counts: Counter[str] = Counter()
    for trip in trips:
        attributes = tuple(_type_of(trip.actor).items())
        if attributes not in types:
            kind = trip.actor.kind
            counts[kind] += 1
            types[attributes] = kind if counts[kind] == 1 else f"{kind}_v{counts[kind]}"
            put(root, "vType", id=types[attributes], **dict(attributes))
    for trip in trips:
        vehicle = put(
            root,
            "vehicle",
            id=trip.actor.name,
            type=types[tuple(_type_of(trip.actor).items())],
            depart="0.00",
            departLane=trip.lane,
            departPos=f"{trip.position:.3f}",
            departSpeed=f"{trip.speed:.3f}",
            arrivalPos="max",
        )
        put(vehicle, "route", edges=" ".join(edge.id for edge in trip.edges))
    put_walks(root, walks)
    indent(root, " ")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{tostring(root, encoding="unicode")}\n'


def _type_of(actor: SceneActor) -> dict[str, str]:
    """The attributes of a `vType`."""
    options = actor.drive[0].options if actor.drive else {}
    found = {"vClass": class_of(actor)}
    found |= {name: f"{getattr(actor, name):.3f}" for name in ("length", "width", "height")}
    found["maxSpeed"] = f"{_SPEEDS.get(class_of(actor), _FASTEST):.3f}"
    # Of the speed limit; without it SUMO draws one.
    found["speedFactor"] = f"{float(options.get('speed_factor') or 1.0):.4f}"
    wanted = options.get("speed")
    if wanted:
        found["maxSpeed"] = f"{max(float(wanted), 0.5):.3f}"
    for option, name in _OPTIONS.items():
        value = options.get(option)
        if isinstance(value, int | float):
            found[name] = f"{max(float(value), _LEAST[name]):.3f}"
    return found
