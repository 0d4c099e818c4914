"""Junctions: their connections, right of way and signals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal
from xml.etree.ElementTree import Element

from .connecting_roads import ConnectingRoad, RoadEnd
from .direct_links import direct_links
from .elements import put
from .road_parts import PartEnds

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneJunction, SceneLaneEnd

    from .road_parts import OpenDriveRoad


@dataclass(frozen=True)
class NumberedJunction:
    """A junction of the scene with its number in OpenDRIVE, and its connecting roads."""

    id: int
    name: str
    junction: SceneJunction
    roads: tuple[ConnectingRoad, ...]

    def road(self, connection: int) -> ConnectingRoad:
        """That of a connection of the scene."""
        return next(road for road in self.roads if road.connection.id == connection)


def numbered_junctions(
    scene: Scene, parts: Sequence[OpenDriveRoad], rule: Literal["RHT", "LHT"]
) -> tuple[NumberedJunction, ...]:
    """Junctions have numbers after those of all roads, so that none is the number of both. `rule`:
    that of their roads."""
    ends = PartEnds.of(parts)
    linked = direct_links(scene)
    lane = 1 if rule == "LHT" else -1
    found: list[NumberedJunction] = []
    built = [
        (network.name, junction)
        for network in scene.networks
        for junction in network.junctions
        # Of a network that was perturbed on, only the last is built.
        if junction.connections and all(ends.has(arm.road) for arm in junction.arms)
        # A joint of roads that are linked to one another is no junction.
        if not (
            junction.kind == "joint" and (junction.arms[0].road, junction.arms[0].end) in linked
        )
    ]
    number = max((part.id for part in parts), default=0)
    first = number + sum(len(junction.connections) for _, junction in built) + 1
    for id, (network, junction) in enumerate(built, start=first):
        roads = []
        for connection in junction.connections:
            number += 1
            at = connection.source
            source = _end(at, *ends.leaving(at.road, at.end))
            at = connection.target
            target = _end(at, *ends.entering(at.road, at.end))
            roads.append(ConnectingRoad(number, id, connection, source, target, lane))
        name = f"{network}/junction {junction.id}"
        found.append(NumberedJunction(id, name, junction, tuple(roads)))
    return tuple(found)


def _end(at: SceneLaneEnd, part: OpenDriveRoad, end: str) -> RoadEnd:
    return RoadEnd(part, end, part.lane_ids[at.lane])


def put_junction(root: Element, junction: NumberedJunction, controllers: Sequence[int]) -> None:
    """A `junction` element."""
    found = put(root, "junction", id=junction.id, name=junction.name, type="default")
    for place, road in enumerate(junction.roads):
        connection = put(
            found,
            "connection",
            id=place,
            incomingRoad=road.source.part.id,
            connectingRoad=road.id,
            contactPoint="start",
        )
        put(connection, "laneLink", from_=road.source.lane, to=road.lane)
    for low, high in sorted({
        (junction.road(low).id, junction.road(high).id) for low, high in junction.junction.yields
    }):  # fmt: skip
        put(found, "priority", high=high, low=low)
    for sequence, id in enumerate(controllers):
        put(found, "controller", id=id, sequence=sequence)


def end_roads(junctions: Sequence[NumberedJunction]) -> dict[tuple[str, str], int]:
    """The numbers of junctions by the roads, and their ends, that lead to them."""
    return {
        (arm.road, arm.end): junction.id for junction in junctions for arm in junction.junction.arms
    }
