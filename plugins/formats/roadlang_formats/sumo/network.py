"""The network of a scene for SUMO: its edges and nodes, and their file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

import numpy as np

from roadlang.geometry import Floats

from ..decimals import decimals
from ..opendrive.elements import put
from ..surfaces.built import built_junctions, built_roads, is_loop
from .edges import SumoEdge, SumoLane, road_edges
from .nodes import SumoNode, dead_end, junction_node, nodes_between
from .signal_programs import put_program
from .vehicle_classes import lane_use

if TYPE_CHECKING:
    from roadlang.api import Scene

VERSION = "1.20"
"""Of the format of networks."""


@dataclass(frozen=True)
class SumoNetwork:
    """Edges and nodes in the order of the file."""

    edges: tuple[SumoEdge, ...]
    nodes: tuple[SumoNode, ...]
    left_hand: bool

    @classmethod
    def of(cls, scene: Scene) -> SumoNetwork:
        """Of a scene."""
        left_hand = scene.world.get("traffic") == "left"
        roads, use = built_roads(scene), lane_use(scene)
        junctions = [
            (f"{network}/j{junction.id}", junction)
            for network, junction in built_junctions(scene)
            if junction.arms
        ]
        ends = {(arm.road, arm.end): id for id, found in junctions for arm in found.arms}
        by_road: dict[str, list[SumoEdge]] = {}
        nodes: list[SumoNode] = []
        for road in roads:
            at = [ends.get((road.name, end), f"{road.name}.{end}") for end in ("start", "end")]
            edges = road_edges(road, (at[0], at[1]), left_hand, use)
            by_road[road.name] = edges
            nodes += nodes_between(road, edges)
            alone = [id for id in at if id == f"{road.name}.start" or id == f"{road.name}.end"]
            found = [] if is_loop(road) else [dead_end(id, edges) for id in alone]
            nodes += [node for node in found if node is not None]
        crossings = [junction_node(id, found, by_road, left_hand) for id, found in junctions]
        edges_ = tuple(edge for edges in by_road.values() for edge in edges)
        return cls(edges_, (*crossings, *nodes), left_hand)

    @cached_property
    def by_road(self) -> dict[str, list[SumoEdge]]:
        """The edges of each road of the scene."""
        found: dict[str, list[SumoEdge]] = {}
        for edge in self.edges:
            found.setdefault(edge.road.name, []).append(edge)
        return found

    def text(self) -> str:
        """The `.net.xml`."""
        root = Element("net")
        root.set("version", VERSION)
        if self.left_hand:
            root.set("lefthand", "true")
        _put_location(root, [lane.line for edge in self.edges for lane in edge.lanes])
        for node in self.nodes:
            for number, link in enumerate(node.links):
                edge = put(root, "edge", id=f":{node.id}_{number}", function="internal")
                width = link.source.lanes[link.source_lane].width
                allow = link.source.lanes[link.source_lane].permissions
                lane = SumoLane(0, width, link.speed, link.line, allow)
                _put_lane(edge, f":{node.id}_{number}", 0, lane, link.length)
        for edge_ in self.edges:
            edge = put(root, "edge", id=edge_.id)
            edge.set("from", edge_.source)
            edge.set("to", edge_.target)
            edge.set("priority", "-1")
            if edge_.road.street:
                edge.set("name", edge_.road.street)
            for number, lane in enumerate(edge_.lanes):
                _put_lane(edge, edge_.id, number, lane, edge_.length)
        for node in self.nodes:
            put_program(root, node)
        for node in self.nodes:
            _put_junction(root, node)
        for node in self.nodes:
            _put_connections(root, node)
        indent(root, " ")
        text = tostring(root, encoding="unicode")
        return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'


def _put_location(root: Element, lines: Sequence[Floats]) -> None:
    points = np.concatenate([*lines, np.zeros((0, 2))]) if lines else np.zeros((1, 2))
    low, high = points.min(axis=0), points.max(axis=0)
    bounds = ",".join(decimals(value, 2) for value in (*low, *high))
    put(
        root,
        "location",
        netOffset="0.00,0.00",
        convBoundary=bounds,
        origBoundary=bounds,
        projParameter="!",
    )


def shape(points: Floats) -> str:
    """Points as SUMO writes them, to the millimeter."""
    return " ".join(f"{decimals(x, 3)},{decimals(y, 3)}" for x, y in points.tolist())


def _put_lane(edge: Element, id: str, number: int, lane: SumoLane, length: float) -> None:
    found = put(edge, "lane", id=f"{id}_{number}", index=number)
    if lane.permissions:
        found.set("allow", lane.permissions)
    else:
        found.set("disallow", "pedestrian")
    for name, value in (("speed", lane.speed), ("length", length), ("width", lane.width)):
        found.set(name, f"{value:.3f}")
    found.set("shape", shape(lane.line))


def _put_junction(root: Element, node: SumoNode) -> None:
    x, y = node.area.mean(axis=0).tolist()
    found = put(root, "junction", id=node.id, type=node.kind)
    found.set("x", decimals(x, 3))
    found.set("y", decimals(y, 3))
    lanes = [f"{edge.id}_{number}" for edge in node.incoming for number in range(len(edge.lanes))]
    found.set("incLanes", " ".join(lanes))
    found.set("intLanes", " ".join(f":{node.id}_{number}_0" for number in range(len(node.links))))
    found.set("shape", shape(node.area))
    count = len(node.links)
    for number in range(count):
        put(
            found,
            "request",
            index=number,
            response=_bits(node.yields, number, count),
            foes=_bits(node.conflicts, number, count),
            cont=0,
        )


def _bits(pairs: frozenset[tuple[int, int]], number: int, count: int) -> str:
    """One digit for each link, the last one first."""
    return "".join("01"[(number, other) in pairs] for other in reversed(range(count)))


def _put_connections(root: Element, node: SumoNode) -> None:
    for number, link in enumerate(node.links):
        found = _put_connection(
            root, link.source.id, link.source_lane, link.target.id, link.target_lane
        )
        found.set("via", f":{node.id}_{number}_0")
        if node.kind == "traffic_light":
            found.set("tl", node.id)
            found.set("linkIndex", str(number))
        found.set("dir", link.turn)
        found.set("state", node.state(number))
    for number, link in enumerate(node.links):
        found = _put_connection(root, f":{node.id}_{number}", 0, link.target.id, link.target_lane)
        found.set("dir", link.turn)
        found.set("state", "M")


def _put_connection(root: Element, source: str, lane: int, target: str, to: int) -> Element:
    found = put(root, "connection")
    found.set("from", source)
    found.set("to", target)
    found.set("fromLane", str(lane))
    found.set("toLane", str(to))
    return found
