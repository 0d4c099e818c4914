"""The network of the ways of an extract that vehicles use."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from roadlang.api import Diagnostic, DiagnosticError, Extraction
from roadlang.geometry import (
    CrossSection,
    Edge,
    GeometryError,
    Lane,
    Node,
    RoadNetwork,
    WidthProfile,
)
from roadlang.geometry.curves.filleting import filleted
from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang.geometry.lanes.lanes import Marking
from roadlang_formats.map_xml import MapFile, left_out_at

from .buildings import buildings_of
from .controls import map_controls
from .lane_arrows import lane_arrows, written_arrows
from .records import OsmExtract, OsmWay, check_is_streets, osm_extract
from .restrictions import no_turns
from .streets import Street, contracted
from .way_lanes import WayLanes, is_driven, level_of, one_way, way_lanes

Place = tuple[float, float]

_ROUNDING = 15.0
"""Meters: the radius by which the corners of ways are rounded where there is room."""
_SHORTEST = 0.5
"""Meters of a road."""
_FARTHEST = 100_000.0
"""Meters from the origin."""
_USERS = ("car", "bus", "bicycle")


@dataclass(frozen=True)
class OsmOptions:
    """`origin`: latitude and longitude of (0, 0), degrees; the middle of the ways without.
    `lane_width` in meters; `left_hand`: traffic keeps left."""

    origin: tuple[float, float] | None
    lane_width: float
    left_hand: bool
    service: bool
    buildings: bool


def network_of(file: MapFile, options: OsmOptions) -> Extraction:
    """Roads between the nodes that ways share. Raises RL479."""

    def fault(reason: str, help: str = "") -> DiagnosticError:
        return file.fault(file.root, reason, help)

    def left_out(way: OsmWay, reason: str) -> Diagnostic:
        return left_out_at(file.path, file.text, way.offset, f"a part of {way.title}", reason)

    check_is_streets(file)
    return network_of_ways(osm_extract(file), options, fault, left_out)


def network_of_ways(
    extract: OsmExtract,
    options: OsmOptions,
    fault: Callable[..., DiagnosticError],
    left_out: Callable[[OsmWay, str], Diagnostic],
) -> Extraction:
    """The same of nodes and ways; `fault` makes what is raised for the whole of them, `left_out`
    what is said of parts of ways."""
    streets = _streets(extract, options)
    if not streets:
        raise fault("it has no way for motor vehicles")
    used = {node for street in streets for node in street.nodes}
    origin = options.origin or _middle(extract, used)
    projection = LocalProjection(*origin)
    points = {
        id: projection.point(extract.nodes[id].latitude, extract.nodes[id].longitude) for id in used
    }
    farthest = max(points.values(), key=lambda point: math.hypot(*point))
    if math.hypot(*farthest) > _FARTHEST:
        reason = f"its ways extend up to {math.hypot(*farthest) / 1000:.0f} km from the origin"
        raise fault(reason, "set an `origin` nearby, or use a smaller extract")
    streets = contracted(streets, points, extract.nodes, _SHORTEST)
    network, built, refused = _built(streets, points, options)
    ways = {way.id: way for way in extract.ways}
    warnings = tuple(left_out(ways[street.ways[0]], reason) for street, reason in refused)
    controls = map_controls(
        {id: street.nodes for id, street in built.items()}, extract.nodes, points
    )
    ends = {id: (street.nodes[0], street.nodes[-1], *street.ways) for id, street in built.items()}
    banned = no_turns(extract.restrictions, ends)
    edges = tuple(replace(edge, no_turns=banned.get(edge.id, ())) for edge in network.edges)
    network = replace(network, edges=edges, origin=origin, controls=controls)
    objects = buildings_of(extract, projection) if options.buildings else ()
    return Extraction(network, objects, warnings=warnings)


def _middle(extract: OsmExtract, used: set[str]) -> tuple[float, float]:
    """The center of the bounding box of all nodes, to 1e-5 degrees; of a map on both sides of the
    antimeridian that of the box across it."""
    latitudes = [extract.nodes[id].latitude for id in used]
    longitudes = [extract.nodes[id].longitude for id in used]
    if max(longitudes) - min(longitudes) > 180.0:
        longitudes = [longitude % 360.0 for longitude in longitudes]
    middle = ((min(values) + max(values)) / 2.0 for values in (latitudes, longitudes))
    latitude, longitude = (round(value, 5) for value in middle)
    return latitude, longitude - 360.0 if longitude > 180.0 else longitude


def _streets(extract: OsmExtract, options: OsmOptions) -> list[Street]:
    """The ways for vehicles, split where others meet them, joined where one continues another."""
    ways = [
        Street(way.nodes, way.tags, (way.id, way.id), level_of(way.tags), written_arrows(way.tags))
        for way in extract.ways
        if is_driven(way.tags) and (options.service or way.tags["highway"] != "service")
    ]
    visits = Counter(node for way in ways for node in way.nodes)
    ends = Counter(node for way in ways for node in (way.nodes[:1] + way.nodes[-1:]))
    parts = [part for way in ways for part in _cut(way, visits, ends)]
    return _put_together(parts)


def _cut(way: Street, visits: Mapping[str, int], ends: Mapping[str, int]) -> Iterator[Street]:
    """The parts of a way between nodes that it shares with others, or passes twice."""
    nodes = [way.nodes[0]] if way.nodes else []
    first = True
    for place, node in enumerate(way.nodes[1:], 2):
        if node == nodes[-1]:
            continue
        nodes.append(node)
        if visits[node] > 1 or ends[node] > 0:
            # Markings are for the junctions at the ends of the whole way.
            at_start, at_end = way.arrows
            last = place == len(way.nodes)
            arrows = at_start if first else "", at_end if last else ""
            yield replace(way, nodes=tuple(nodes), arrows=arrows)
            nodes, first = [node], False


def _put_together(parts: Sequence[Street]) -> list[Street]:
    """Streets that meet no other at a node, and have the same lanes and name, as one."""
    at: dict[str, list[Street]] = {}
    for part in parts:
        for node in (part.nodes[0], part.nodes[-1]):
            at.setdefault(node, []).append(part)
    found = {id(part): part for part in parts}
    order = {id(part): place for place, part in enumerate(parts)}
    for node in sorted(at):
        met = at[node]
        if len(met) != 2 or met[0] is met[1] or not _goes_on(met[0], met[1]):
            continue
        joined = _joined(met[0], met[1], node)
        if joined is None:
            continue
        for part in met:
            del found[id(part)]
            for end in (part.nodes[0], part.nodes[-1]):
                at[end] = [joined if other is part else other for other in at[end]]
        found[id(joined)] = joined
        order[id(joined)] = min(order[id(part)] for part in met)
    return sorted(found.values(), key=lambda part: order[id(part)])


def _goes_on(one: Street, other: Street) -> bool:
    name = one.tags.get("name") == other.tags.get("name")
    kind = one.tags["highway"] == other.tags["highway"]
    return name and kind and way_lanes(one.tags) == way_lanes(other.tags)


def _joined(one: Street, other: Street, node: str) -> Street | None:
    """Both in the direction of one of them; None where they run against each other one way, or
    would close a ring."""
    if {one.nodes[0], one.nodes[-1]} == {other.nodes[0], other.nodes[-1]}:
        return None
    if one.nodes[0] == node and other.nodes[-1] == node:
        one, other = other, one
    if one.nodes[-1] == node and other.nodes[0] == node:
        return one.and_then(other)
    if one_way(one.tags) is not None or not way_lanes(one.tags).is_symmetric:
        return None
    if one.nodes[0] == node:
        return one.reversed.and_then(other)
    return one.and_then(other.reversed)


def _built(
    streets: Sequence[Street], points: Mapping[str, Place], options: OsmOptions
) -> tuple[RoadNetwork, dict[int, Street], list[tuple[Street, str]]]:
    """The edges, numbered from 1 in the order of the file, and by their numbers the streets; also
    the streets that cannot be built, and why."""
    built: dict[int, Street] = {}
    refused: list[tuple[Street, str]] = []
    numbers: dict[str, int] = {}
    edges: list[Edge] = []
    for street in _open(streets):
        line = [points[node] for node in street.nodes]
        try:
            curve = filleted(line, _ROUNDING)
        except GeometryError as error:
            refused.append((street, str(error)))
            continue
        if curve.length < _SHORTEST:
            refused.append((street, f"it is only {curve.length:.2g} m long"))
            continue
        ends = [
            numbers.setdefault(node, len(numbers) + 1)
            for node in (street.nodes[0], street.nodes[-1])
        ]
        lanes = cross_section(way_lanes(street.tags), options)
        edge = Edge.of(len(edges) + 1, ends[0], ends[1], curve, lanes)
        arrows = lane_arrows(street.arrows, lanes)
        name = street.tags.get("name", "")
        edges.append(replace(edge, name=name, level=street.level, lane_arrows=arrows))
        built[edge.id] = street
    nodes = tuple(Node(number, points[node]) for node, number in numbers.items())
    return RoadNetwork(nodes, tuple(edges)), built, refused


def _open(streets: Sequence[Street]) -> Iterator[Street]:
    """The streets, rings in two halves: an edge that is no circle needs two ends."""
    for street in streets:
        if street.nodes[0] == street.nodes[-1] and len(street.nodes) > 3:
            half = len(street.nodes) // 2
            yield replace(street, nodes=street.nodes[: half + 1])
            yield replace(street, nodes=street.nodes[half:])
        else:
            yield street


def cross_section(lanes: WayLanes, options: OsmOptions) -> CrossSection:
    """The lanes of a way, the middle of which is that of the way."""
    width = WidthProfile.constant(options.lane_width)
    sides = (lanes.backward, lanes.forward)
    if lanes.backward == 0 or lanes.forward == 0:
        sides = (0, lanes.forward + lanes.backward)
    found = []
    for id in (*range(sides[0], 0, -1), *range(-1, -sides[1] - 1, -1)):
        backward = id > 0 or lanes.forward == 0
        outermost = id in (sides[0], -sides[1])
        found.append(
            Lane(
                id,
                "drive",
                width,
                "backward" if backward else "forward",
                speed_limit=lanes.backward_limit if backward else lanes.forward_limit,
                marking="solid" if outermost else "broken",
                users=_USERS,
            )
        )
    total = sum(sides)
    middle: Marking = "solid" if sides[0] == 0 else "broken" if total < 4 else "double"
    section = CrossSection(tuple(found), middle)
    return section.mirrored() if options.left_hand else section
