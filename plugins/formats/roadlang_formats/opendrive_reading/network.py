"""The network that an OpenDRIVE file describes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from roadlang.api import Extraction
from roadlang.geometry import Edge, Node, RoadNetwork
from roadlang_formats.map_xml import MapFile

from .built_roads import BuiltRoad
from .controls import map_controls
from .objects import objects_of
from .parsing import parsed_map
from .records import OpenDriveRecord
from .turns import RoadEnd, TurnReader

_LARGEST_ID = 10**9
_TOGETHER = 1e-7
"""Share of their coordinates by which ends at one node may differ."""


def network_of(file: MapFile, *, objects: bool = True) -> Extraction:
    """Roads outside of junctions with their ids, the junctions as the file states them, and the
    objects that vehicles must not touch."""
    record = parsed_map(file)
    roads = {id: BuiltRoad.of(file, road) for id, road in record.roads.items()}
    outside = [
        road
        for id, road in roads.items()
        # A connecting road whose junction is missing is treated like any other road.
        if road.record.junction not in record.junctions
    ]
    if not outside:
        raise file.fault(file.root, "all its roads belong to junctions")
    numbers = numbered([road.record.id for road in outside])
    reader = TurnReader(file, roads, numbers)
    junctions = reader.junctions(record.junctions)
    nodes, at = _nodes(outside)
    edges = []
    for road in outside:
        number, id = numbers[road.record.id], road.record.id
        name = road.record.name or ("" if str(number) == id else id)
        edge = Edge.of(number, at[id, "start"], at[id, "end"], road.curve, road.section)
        edges.append(replace(edge, name=name, elevations=road.elevations()))
    controls = map_controls(record, numbers)
    network = RoadNetwork(nodes, tuple(edges), record.origin, junctions, controls)
    found = objects_of(file, roads) if objects else ()
    remarks = (*_remarks(record), *reader.remarks)
    return Extraction(network, found, remarks=remarks, warnings=tuple(reader.warnings))


def numbered(ids: Sequence[str]) -> Mapping[str, int]:
    """The ids themselves where all are whole numbers, else numbers from 0 on in their order."""
    if all(id.isascii() and id.isdigit() and int(id) < _LARGEST_ID for id in ids):
        found = {id: int(id) for id in ids}
        if len(set(found.values())) == len(ids):
            return found
    return {id: number for number, id in enumerate(ids)}


def _nodes(roads: Sequence[BuiltRoad]) -> tuple[tuple[Node, ...], dict[RoadEnd, int]]:
    """A node for each end of a road, one for both where roads that follow one another meet."""
    by_id = {road.record.id: road for road in roads}
    nodes: list[Node] = []
    at: dict[RoadEnd, int] = {}
    for road in roads:
        for end in ("start", "end"):
            key: RoadEnd = road.record.id, end
            point, link = road.point(key[1]), road.record.link(key[1])
            there = at.get((link.id, link.contact)) if link and link.id in by_id else None
            if there is not None and _same(nodes[there].position, point):
                at[key] = there
            else:
                at[key] = len(nodes)
                nodes.append(Node(len(nodes), point))
    return tuple(nodes), at


def _same(one: tuple[float, float], other: tuple[float, float]) -> bool:
    apart = float(np.hypot(one[0] - other[0], one[1] - other[1]))
    return apart <= _TOGETHER * max(1.0, *map(abs, one))


def _remarks(record: OpenDriveRecord) -> tuple[str, ...]:
    sides = {road.left_hand for road in record.roads.values() if not road.junction}
    if sides == {True} or any(road.left_hand_of for road in record.roads.values()):
        return ("the map has left-hand traffic: write `world { traffic: left }`",)
    return ()
