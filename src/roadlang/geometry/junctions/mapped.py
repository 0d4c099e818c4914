"""Plans of junctions that a map states: its turns along its lines, and no others."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..arrays import Floats, wrapped_angle
from ..curves.curve import Curve
from ..lanes.cross_section import CrossSection
from ..networks.junction_model import Junction, JunctionPlan
from ..networks.map_junctions import MapJunction, MapTurn
from ..networks.network import RoadNetwork
from .arc_splines import Pieces, arc_spline
from .arms import ArmKey, ArmLine, Face
from .building import junction_of
from .connecting import Connected
from .connection_curves import ConnectionEnds, Fits, fitted
from .lane_pairs import ArmLanes, LanePair, turn_of
from .overlaps import passing_above
from .places import JunctionSite
from .trims import Trimmed, counter_clockwise

_SPACING = 0.5
_TOLERANCE = 0.002
"""Meters by which the arcs of a turn may be off the line of the map."""
_JOINT_TRIM, _JOINT_SHARE = 1.0, 0.1
"""Meters, and share of a road, that are left for turns that have no line."""


def plan_of_map(network: RoadNetwork, sections: Mapping[int, CrossSection]) -> JunctionPlan:
    """The plan of a network whose map defines the junctions. The only problems
    of maps are roads that pass above others."""
    arms: dict[ArmKey, ArmLine] = {}
    trims: dict[ArmKey, float] = {}
    stated = [junction for junction in network.junctions or () if junction.turns]
    for junction in stated:
        drawn = any(turn.curve is None for turn in junction.turns)
        for id, end in junction.arms:
            edge = network.edge(id)
            arms[id, end] = ArmLine.of(edge, end, sections[id])
            trims[id, end] = min(_JOINT_TRIM, _JOINT_SHARE * edge.length) if drawn else 0.0
    junctions = tuple(_junction(junction, arms, trims) for junction in stated)
    by_edge = {
        edge.id: (trims.get((edge.id, "start"), 0.0), trims.get((edge.id, "end"), 0.0))
        for edge in network.edges
    }
    built = tuple(found for found in junctions if found.connections)
    return JunctionPlan(built, by_edge, passing_above(network, sections, by_edge))


def _junction(
    junction: MapJunction, arms: Mapping[ArmKey, ArmLine], trims: Mapping[ArmKey, float]
) -> Junction:
    order = counter_clockwise([arms[key] for key in junction.arms], trims)
    faces = tuple(arm.face(trims[arm.key]) for arm in order)
    lanes = tuple(
        ArmLanes.of(arm.lanes(trims[arm.key]), face.heading)
        for arm, face in zip(order, faces, strict=True)
    )
    places = {arm.key: place for place, arm in enumerate(order)}
    pairs, turns = _pairs(junction.turns, places, lanes)
    fits = _fits(pairs, turns, faces, lanes)
    none = np.zeros((len(pairs), len(order)), dtype=bool)
    found = Connected(order, faces, lanes, pairs, fits, none)
    nodes = tuple(dict.fromkeys(arm.node for arm in order))
    site = JunctionSite(nodes, Trimmed(order, trims, ()), ())
    built = junction_of(site, found, trims, arms, {}).junction
    return replace(built, id=junction.id, kind="joint" if junction.joint else "junction")


def _pairs(
    turns: Sequence[MapTurn], places: Mapping[ArmKey, int], lanes: Sequence[ArmLanes]
) -> tuple[tuple[LanePair, ...], list[MapTurn]]:
    """The turns between lanes for motor vehicles that run that way, each once."""
    found: dict[tuple[int, int, int, int], tuple[LanePair, MapTurn]] = {}
    for turn in turns:
        source, target = turn.source, turn.target
        ends = places[source.edge, source.end], places[target.edge, target.end]
        inbound = [lane.id for lane in lanes[ends[0]].inbound]
        outbound = [lane.id for lane in lanes[ends[1]].outbound]
        if source.lane not in inbound or target.lane not in outbound:
            continue
        place = inbound.index(source.lane), outbound.index(target.lane)
        change = lanes[ends[1]].heading - lanes[ends[0]].heading - math.pi
        angle = round(wrapped_angle(change), 12)
        pair = LanePair(ends[0], place[0], ends[1], place[1], angle, turn_of(angle))
        found.setdefault((*ends, *place), (pair, turn))
    ordered = [found[key] for key in sorted(found)]
    return tuple(pair for pair, _ in ordered), [turn for _, turn in ordered]


def _fits(
    pairs: Sequence[LanePair],
    turns: Sequence[MapTurn],
    faces: Sequence[Face],
    lanes: Sequence[ArmLanes],
) -> Fits:
    """The curves of all turns, as arcs."""
    poses = np.array([_poses(pair, faces, lanes) for pair in pairs]).reshape(-1, 6)
    ends = ConnectionEnds(
        poses[:, 0:2], poses[:, 2], poses[:, 3:5], poses[:, 5], np.full(len(poses), math.inf)
    )
    drawn = fitted(ends, np.zeros((0, 3)))
    pieces = [
        drawn.pieces(row) if turn.curve is None else _arcs(turn.curve, poses[row])
        for row, turn in enumerate(turns)
    ]
    most = max((len(found) for found in pieces), default=1)
    table = np.zeros((2, len(pieces), most))
    for row, found in enumerate(pieces):
        table[:, row, : len(found)] = np.array(found).reshape(-1, 2).T
    drivable = np.array([bool(found) for found in pieces], dtype=bool)
    return Fits(ends.start, ends.heading, table[0], table[1], drivable)


def _poses(
    pair: LanePair, faces: Sequence[Face], lanes: Sequence[ArmLanes]
) -> tuple[float, float, float, float, float, float]:
    """Where a turn starts and where it stops: x, y and heading of both."""
    source, target = faces[pair.source], faces[pair.target]
    start = source.beside(lanes[pair.source].inbound[pair.source_lane].offset)
    stop = target.beside(lanes[pair.target].outbound[pair.target_lane].offset)
    return (*start, source.heading + math.pi, *stop, target.heading)


def _arcs(curve: Curve, ends: Floats) -> Pieces:
    """A line of a map as arcs, its ends moved to those of the lanes: maps leave gaps."""
    s = curve.stations(spacing=_SPACING)
    t = s / curve.length
    points, tangent = curve.at(s), curve.tangent(s)
    first, last = ends[0:2] - points[0], ends[3:5] - points[-1]
    share = t**3 * (10.0 - 15.0 * t + 6.0 * t * t)
    points = points + first + (last - first) * share[:, None]
    slope = 30.0 * (t * (1.0 - t)) ** 2 / curve.length
    tangent = tangent + (last - first) * slope[:, None]
    headings = np.arctan2(tangent[:, 1], tangent[:, 0])
    headings[[0, -1]] = ends[[2, 5]]
    return arc_spline(points, headings, _TOLERANCE)
