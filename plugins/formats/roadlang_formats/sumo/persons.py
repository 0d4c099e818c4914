"""Agents who walk along a sidewalk as persons of SUMO."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from roadlang.api import ON_FOOT

from ..opendrive.elements import put
from ..target_speed import target_speed
from .edges import SumoEdge, in_order

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor
    from roadlang.geometry import Floats

    from .network import SumoNetwork
    from .places import RoadSpan

_SIDEWALK = "pedestrian"
"""What a lane is for that only they use."""


@dataclass(frozen=True)
class PersonTrip:
    """A person with the edges along whose sidewalk it goes, from and to where (m along the first
    and the last one), and how fast (m/s)."""

    actor: SceneActor
    edges: tuple[SumoEdge, ...]
    start: float
    stop: float
    speed: float


def walk_of(
    scene: Scene, network: SumoNetwork, actor: SceneActor, places: Sequence[RoadSpan]
) -> PersonTrip | None:
    """Of an agent that is driven by `walk`; SUMO has nobody beside a sidewalk, or across a road.

    `places`: the parts of roads along which it goes, of which it walks the first."""
    call = actor.drive[0] if actor.drive else None
    if actor.category not in ON_FOOT or call is None or call.kind.rpartition(".")[2] != "walk":
        return None
    if call.options.get("along") != "sidewalk" or not places:
        return None
    place = places[0]
    nearest = min(_sidewalks(network.by_road.get(place.road, ()), actor), default=None)
    if nearest is None:
        return None
    _, forward, lane = nearest
    edges = [
        edge
        for edge in in_order(network.by_road[place.road], forward)
        if edge.index(lane) is not None
    ]
    # The edges of the direction in which the sidewalk lies are walked either way.
    edges = edges if forward != place.back else edges[::-1]
    inside = [
        edge
        for edge in edges
        if (edge.start < place.start if place.back else edge.stop > place.start)
    ]
    if not inside:
        return None
    first, last = inside[0], inside[-1]
    end = last.length if forward != place.back else 0.0
    speed = target_speed(scene, actor, call)
    return PersonTrip(actor, tuple(inside), _position(first, place.start), end, speed)


def _sidewalks(edges: Sequence[SumoEdge], actor: SceneActor) -> Iterator[tuple[float, bool, int]]:
    """How far the sidewalks of a road are, whether their edges lead along it, and their ids."""
    where = np.array((actor.x, actor.y))
    for edge in edges:
        for lane in edge.lanes:
            if lane.permissions == _SIDEWALK:
                yield _away(where, lane.line), edge.forward, lane.id


def _away(point: Floats, line: Floats) -> float:
    """Meters from a point (2,) to a line (n, 2)."""
    sides = np.diff(line, axis=0)
    squares = np.maximum((sides * sides).sum(axis=1), 1e-12)
    share = np.clip(((point - line[:-1]) * sides).sum(axis=1) / squares, 0.0, 1.0)
    nearest = line[:-1] + share[:, None] * sides
    return float(np.hypot(*(nearest - point).T).min())


def _position(edge: SumoEdge, station: float) -> float:
    share = (station - edge.start) / max(edge.stop - edge.start, 1e-9)
    share = share if edge.forward else 1.0 - share
    return min(max(share, 0.0), 1.0) * edge.length


def put_walks(root: Element, walks: Sequence[PersonTrip]) -> None:
    """Types and persons."""
    for walk in walks:
        actor = walk.actor
        type_ = f"type_of_{actor.name}".replace(" ", "_")
        kind = put(root, "vType", id=type_, vClass="pedestrian")
        for name in ("length", "width", "height"):
            kind.set(name, f"{getattr(actor, name):.3f}")
        kind.set("maxSpeed", f"{walk.speed:.3f}")
        # Without these SUMO draws a speed.
        kind.set("speedFactor", "1.0000")
        kind.set("speedDev", "0")
        person = put(root, "person", id=actor.name, type=type_, depart="0.00")
        person.set("departPos", f"{walk.start:.3f}")
        going = put(person, "walk", edges=" ".join(edge.id for edge in walk.edges))
        going.set("arrivalPos", f"{walk.stop:.3f}")
