"""Networks of which only what lies in a region is kept: roads are cut where they leave it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count
from typing import TypeAlias

import numpy as np

from ..arrays import Booleans, Floats
from .edge_parts import EdgePart
from .junction_model import End, LaneEnd
from .map_junctions import MapControl, MapJunction, MapTurn
from .network import Edge, Node, RoadNetwork

Contains: TypeAlias = Callable[[Floats], Booleans]
Arm: TypeAlias = tuple[int, End]
Kept: TypeAlias = Mapping[Arm, tuple[int, EdgePart]]
"""By the ends of roads: the id of the part that has it now, and the part."""

_STEP = 0.5
"""Meters between the points at which a road is looked at."""
_MOST_STEPS = 100_000
_HALVINGS = 12
"""Of a step: a border is found to a tenth of a millimeter."""


def clipped(network: RoadNetwork, contains: Contains) -> RoadNetwork:
    """What of a network lies where `contains` says so of points (n, 2).

    The longest part of a road keeps its id, other parts get new ones; roads end at new nodes where
    they are cut. Parts that are shorter than they are wide are left out. Junctions keep the turns
    between what is left of their arms. Raises GeometryError for roads that cannot be cut.
    """
    new_ids = count(max((edge.id for edge in network.edges), default=0) + 1)
    parts: list[tuple[int, EdgePart]] = []
    for edge in network.edges:
        found = _parts(edge, contains)
        longest = max(found, key=lambda part: part.length, default=None)
        parts += [(edge.id if part is longest else next(new_ids), part) for part in found]
    if len(parts) == len(network.edges) and all(part.is_whole for _, part in parts):
        return network
    kept = {(part.edge.id, end): (id, part) for id, part in parts for end in part.ends}
    nodes = {node.id: node for node in network.nodes}
    edges = tuple(_edge(id, part, nodes, kept) for id, part in parts)
    used = {node for edge in edges for node in (edge.start, edge.end)}
    junctions = network.junctions
    return RoadNetwork(
        tuple(node for node in nodes.values() if node.id in used),
        edges,
        network.origin,
        None if junctions is None else tuple(_junctions(junctions, kept)),
        tuple(_controls(network.controls, kept)),
    )


def _parts(edge: Edge, contains: Contains) -> list[EdgePart]:
    """The stretches of an edge that lie inside, in order; of a ring, round its seam."""
    steps = min(int(np.ceil(edge.length / _STEP)) + 1, _MOST_STEPS)
    s = np.linspace(0.0, edge.length, steps + 1)
    inside = np.asarray(contains(edge.curve.at(s)), dtype=bool)
    if inside.all():
        return [EdgePart(edge, 0.0, edge.length)]
    changes = np.flatnonzero(inside[1:] != inside[:-1])
    borders = _borders(edge, contains, s[changes], s[changes + 1], inside[changes])
    places = [*([0.0] if inside[0] else []), *borders, *([edge.length] if inside[-1] else [])]
    found = list(zip(places[::2], places[1::2], strict=True))
    if edge.curve.closed and inside[0]:
        start, _ = found.pop()
        found = [(start, edge.length + found[0][1]), *found[1:]]
    parts = [EdgePart(edge, start, stop) for start, stop in found]
    return [part for part in parts if part.length > _width(part)]


def _borders(
    edge: Edge, contains: Contains, low: Floats, high: Floats, inside: Booleans
) -> list[float]:
    """Where the edge passes the border, between `low` and `high` each, by bisection."""
    for _ in range(_HALVINGS if len(low) else 0):
        middle = (low + high) / 2.0
        same = np.asarray(contains(edge.curve.at(middle)), dtype=bool) == inside
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return [float(place) for place in (low + high) / 2.0]


def _width(part: EdgePart) -> float:
    return float(part.edge.width.at((part.start + part.stop) / 2.0 % part.edge.length))


def _edge(id: int, part: EdgePart, nodes: dict[int, Node], kept: Kept) -> Edge:
    """A part as an edge of the new network; adds the nodes where it was cut."""
    made = part.cut()
    ends: dict[End, int] = {"start": part.edge.start, "end": part.edge.end}
    for end in ends:
        if end not in part.ends:
            x, y = made.curve.at(np.array([0.0 if end == "start" else made.length]))[0]
            ends[end] = max(nodes) + 1
            nodes[ends[end]] = Node(ends[end], (float(x), float(y)))
    no_turns = tuple(
        (end, kept[other, other_end][0], other_end)
        for end, other, other_end in part.edge.no_turns
        if end in part.ends and (other, other_end) in kept
    )
    lanes = part.edge.lane_arrows
    return replace(
        made,
        id=id,
        start=ends["start"],
        end=ends["end"],
        no_turns=no_turns,
        lane_arrows=tuple(arrow for arrow in lanes if arrow[0] in part.ends),
    )


def _junctions(junctions: Sequence[MapJunction], kept: Kept) -> Iterator[MapJunction]:
    for junction in junctions:
        arms = tuple((kept[arm][0], arm[1]) for arm in junction.arms if arm in kept)
        turns = tuple(
            MapTurn(source, target, turn.curve)
            for turn in junction.turns
            if (source := _lane_end(turn.source, kept)) and (target := _lane_end(turn.target, kept))
        )
        if turns:
            yield replace(junction, arms=arms, turns=turns)


def _lane_end(end: LaneEnd, kept: Kept) -> LaneEnd | None:
    """The end of a lane in the new network; None where it is no longer there."""
    if (end.edge, end.end) not in kept:
        return None
    id, part = kept[end.edge, end.end]
    lane: int | None = end.lane
    if part.edge.cross_section is not None and not part.is_whole:
        lane = part.lane_ids.get(end.lane)
    return None if lane is None else LaneEnd(id, end.end, lane)


def _controls(controls: Sequence[MapControl], kept: Kept) -> Iterator[MapControl]:
    for control in controls:
        arms = tuple((kept[arm][0], arm[1]) for arm in control.arms if arm in kept)
        if arms:
            yield replace(control, arms=arms)
