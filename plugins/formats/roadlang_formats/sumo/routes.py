"""Agents as vehicles of SUMO: types, routes over edges, and where they depart."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

from ..opendrive.elements import put
from .edges import SumoEdge, in_order, is_loop
from .vehicle_classes import class_of, has_wheels

if TYPE_CHECKING:
    from roadlang.api import RoadPart, Scene, SceneActor, SceneRoad

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
    """Of the agents that drive on the network; who walks is left out, and who has no road."""
    found = [_trip(scene, network, actor) for actor in scene.agents if has_wheels(actor)]
    return [trip for trip in found if trip is not None]


def _trip(scene: Scene, network: SumoNetwork, actor: SceneActor) -> Trip | None:
    places = _places(scene, actor)
    edges: list[SumoEdge] = []
    for road, start, stop in places:
        of_road = in_order(network.by_road.get(road, ()), start <= stop)
        low, high = min(start, stop), max(start, stop)
        inside = [edge for edge in of_road if edge.stop > low and edge.start < high]
        edges += inside or of_road[:1]
    if not edges:
        return None
    first = edges[0]
    number = first.index(actor.lane) if actor.lane is not None else None
    can_start = number is not None and _may_use(first, number, actor)
    type_ = _type_of(actor)
    limit = min(lane.speed for lane in first.lanes) * float(type_["speedFactor"])
    start = places[0][1]
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
    """m/s from which a vehicle stops within so many meters: SUMO lets no other depart before a
    junction where it may have to yield."""
    braking = float(type_.get("decel", _BRAKING))
    reaction = braking * float(type_.get("tau", _REACTION))
    return math.sqrt(reaction * reaction + 2.0 * braking * distance) - reaction


def _may_use(edge: SumoEdge, number: int, actor: SceneActor) -> bool:
    allowed = edge.lanes[number].permissions.split()
    return not allowed or class_of(actor) in allowed


def _places(scene: Scene, actor: SceneActor) -> list[tuple[str, float, float]]:
    """Roads with the stations from which and to which an agent drives on them."""
    if actor.route is not None:
        steps = actor.route.steps
        found: list[tuple[str, float, float]] = []
        for step, before in zip(steps, (None, *steps), strict=False):
            if before is not None and before.turn is None and before.road == step.road:
                found[-1] = (step.road, found[-1][1], step.stop)
            else:
                found.append((step.road, step.start, step.stop))
        return found
    road = next((road for road in scene.roads if road.name == actor.road), None)
    if road is None or actor.start is None:
        return []
    back = _is_backward(road, actor)
    if not road.derived:
        return _along(road, actor.start, back)
    first, last = (road.length, 0.0) if back else (0.0, road.length)
    lap = [(road.name, first, actor.start)] if is_loop(road) else []
    return [(road.name, actor.start, last), *lap]


def _is_backward(road: SceneRoad, actor: SceneActor) -> bool:
    """Whether an agent drives against its road: as its lane says, else as it faces."""
    ways = {lane.direction for lane in road.lane_list if lane.id == actor.lane}
    if ways <= {"both", "none"}:
        return actor.facing == "back"
    return ways == {"backward"}


def _along(road: SceneRoad, start: float, back: bool) -> list[tuple[str, float, float]]:
    """Of a road that only runs over others."""
    found, at = [], 0.0
    for part in road.along:
        length = abs(part.stop - part.start)
        found.append((at, at + length, part))
        at += length
    if back:
        ahead = [(low, high, part) for low, high, part in reversed(found) if low < start]
        return [
            (part.road, _inside(part, min(high, start) - low), part.start)
            for low, high, part in ahead
        ]
    ahead = [(low, high, part) for low, high, part in found if high > start]
    return [(part.road, _inside(part, max(low, start) - low), part.stop) for low, _, part in ahead]


def _inside(part: RoadPart, distance: float) -> float:
    return float(part.start + (distance if part.stop >= part.start else -distance))


def routes_text(trips: Sequence[Trip]) -> str:
    """The `.rou.xml`."""
    root = Element("routes")
    types: dict[tuple[tuple[str, str], ...], str] = {}
    for trip in trips:
        attributes = tuple(_type_of(trip.actor).items())
        if attributes not in types:
            same = sum(id.split("_v")[0] == trip.actor.kind for id in types.values())
            types[attributes] = f"{trip.actor.kind}_v{same + 1}" if same else trip.actor.kind
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
