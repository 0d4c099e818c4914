"""The roads and networks of one candidate, as a scene holds them."""

from __future__ import annotations

import base64
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import scalar
from ..geometry import Edge, WidthProfile
from ..ir.batch import RoadBatch
from ..ir.contained_values import values_in
from ..ir.scenario import ScenarioNetwork, ScenarioRoad
from ..ir.scene import SceneNetwork, SceneNode, SceneRoad
from ..ir.scene_road import SpeedZone
from ..ir.scene_section import lane_members
from ..world.cross_sections import LaneBatch
from ..world.junction_control import right_of_way_rules
from ..world.lane_plan import lane_plan, traffic_side
from ..world.networks import NetworkRoot, edge_batch, lanes_of_edge, network_root
from ..world.road_lanes import lanes_of
from ..world.road_strips import has_descendants, has_perturbed_descendants
from ..world.roads import road_batch, road_root
from ..world.selected_roads import parts_of_network
from .junctions import scene_junctions


def scene_roads(candidates: CandidateBatch) -> tuple[SceneRoad, ...]:
    """Declared roads and the edges of all networks (`town/3`)."""
    scenario = candidates.scenario
    roads = [_declared(road, candidates) for road in scenario.roads.values()]
    for network in scenario.networks.values():
        derived = not has_perturbed_descendants(network, scenario)
        bottom = _bottom(network, scenario)
        root = network_root(network, candidates)
        for edge in root.edges:
            batch = edge_batch(network, edge.id, candidates)
            name, origin = f"{network.name}/{edge.id}", f"{bottom}/{edge.id}"
            lanes = lanes_of_edge(network, edge.id, candidates)
            limit = _speed_limit(network, candidates)
            road = scene_road(name, origin, batch, lanes, limit, derived)
            trim = _trim(road, edge.length, root.junctions.plans[network.name].trims[edge.id])
            road = replace(road, network=network.name, edge=edge.id, trim=trim, street=edge.name)
            roads.append(replace(road, elevation=_elevation(edge, batch)))
    return tuple(roads)


def _elevation(edge: Edge, batch: RoadBatch) -> tuple[float, ...]:
    """Meters at the stations of an edge; empty where its map says nothing of heights."""
    if edge.elevations is None:
        return ()
    places = np.linspace(0.0, edge.length, len(edge.elevations))
    return _floats(np.interp(batch.stations, places, edge.elevations))


def scene_networks(candidates: CandidateBatch) -> tuple[SceneNetwork, ...]:
    """Nodes, the names of the roads, and the mask for tiles."""
    return tuple(_network(network, candidates) for network in candidates.scenario.networks.values())


def scene_road(
    name: str,
    root: str,
    batch: RoadBatch,
    lanes: LaneBatch,
    speed_limit: float | None,
    derived: bool,
) -> SceneRoad:
    """The first variant of a batch. Raises RL475 where it is no road any more."""
    points, count = batch.points[0], len(batch.stations)
    steps = np.hypot(*np.diff(points, axis=0).T)
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    heading, curvature = batch.heading[0], batch.curvature[0]
    width = np.broadcast_to(batch.width, (1, count))[0]
    numbers = (arc, points, heading, curvature, width)
    if not all(np.isfinite(array).all() for array in numbers) or not (steps > 0).all():
        raise DiagnosticError(diagnose(Code.DEGENERATE_ROAD, None, name=name))
    length = float(batch.length[0, 0])
    profile = WidthProfile(arc, width, length if batch.closed else None)
    section = lanes.cross_section(profile, batch.stations)
    return SceneRoad(
        name=name,
        stations=_floats(arc),
        reference_stations=_floats(batch.stations),
        x=_floats(points[:, 0]),
        y=_floats(points[:, 1]),
        heading=_floats(heading),
        curvature=_floats(curvature),
        width=_floats(width),
        lanes=section.lane_count,
        closed=batch.closed,
        length=length,
        root=root,
        derived=derived,
        speed_limit=speed_limit,
        **lane_members(section, arc),
    )


def share_equal_roads(candidates: CandidateBatch) -> None:
    """Make the roads once of which nothing is drawn; every candidate that is taken has them."""
    for road in candidates.scenario.roads.values():
        if candidates.count > 1 and _is_equal(road, candidates):
            shared = _declared(road, candidates.take(np.zeros(1, dtype=np.intp)))
            candidates.once(("scene road", road.name), partial(_same, shared))


def _same(road: SceneRoad) -> SceneRoad:
    return road


def _is_equal(road: ScenarioRoad, candidates: CandidateBatch) -> bool:
    scenario = candidates.scenario
    if road_batch(road.name, candidates).variants > 1:
        return False
    values = [value for link in scenario.ancestry(road) for value in values_in(link)]
    return not scenario.dependencies.draws(*values, traffic_side(scenario))


def _declared(road: ScenarioRoad, candidates: CandidateBatch) -> SceneRoad:
    scenario = candidates.scenario

    def make() -> SceneRoad:
        batch = road_batch(road.name, candidates)
        root = _root_name(road, candidates)
        lanes, limit = lanes_of(road.name, candidates), _speed_limit(road, candidates)
        along = parts_of_network(road, candidates)
        derived = not has_descendants(road, scenario) and not (along and is_network_built())
        found = scene_road(road.name, root, batch, lanes, limit, derived)
        return replace(found, along=along, speed_zones=_speed_zones(found, road, candidates))

    def is_network_built() -> bool:
        network = road_root(road.name, candidates).network
        return network is not None and not has_perturbed_descendants(network, scenario)

    return candidates.once(("scene road", road.name), make)


def _speed_limit(
    source: ScenarioRoad | ScenarioNetwork, candidates: CandidateBatch
) -> float | None:
    value = lane_plan(source, candidates.scenario).speed_limit
    return None if value is None else float(scalar(evaluate(value, candidates)))


def _speed_zones(
    emitted: SceneRoad, road: ScenarioRoad, candidates: CandidateBatch
) -> tuple[SpeedZone, ...]:
    """Those of the roads that a road is joined of; none where it has a limit of its own."""
    if emitted.speed_limit is not None:
        return ()
    changes = road_root(road.name, candidates).limits
    starts = np.interp(
        [change.start for change in changes], emitted.reference_stations, emitted.stations
    )
    return tuple(
        SpeedZone(start, change.speed_limit)
        for start, change in zip(starts.tolist(), changes, strict=True)
    )


def _root_name(road: ScenarioRoad, candidates: CandidateBatch) -> str:
    """The road of the scene that this one was perturbed from."""
    scenario = candidates.scenario
    bottom = [link for link in scenario.chain(road) if isinstance(link, ScenarioRoad)][-1]
    root = road_root(road.name, candidates)
    network_is_perturbed = root.network is not None and any(
        call.verb == "perturb" for link in scenario.chain(root.network) for call in link.passes
    )
    if not network_is_perturbed:
        return bottom.name
    return root.id if root.path is not None and ":" not in root.id else road.name


def _trim(road: SceneRoad, root_length: float, trims: tuple[float, float]) -> tuple[float, float]:
    """The trims of the root road, as the stations of this one have them."""
    places = np.array([trims[0], root_length - trims[1]])
    start, end = np.interp(places, road.reference_stations, road.stations)
    length = road.length if road.closed else road.stations[-1]
    return float(start), float(length - end) if trims[1] else 0.0


def _bottom(network: ScenarioNetwork, scenario: IndexedScenario) -> str:
    return [link for link in scenario.chain(network) if isinstance(link, ScenarioNetwork)][-1].name


def _network(network: ScenarioNetwork, candidates: CandidateBatch) -> SceneNetwork:
    root = network_root(network, candidates)
    names = {edge.id: f"{network.name}/{edge.id}" for edge in root.edges}
    nodes = []
    for node in root.network.nodes:
        edges = root.network.edges_at(node.id)
        x, y = node.position
        if edges:
            edge = edges[0]
            batch = edge_batch(network, edge.id, candidates)
            at_start = edge.start == node.id or batch.closed
            x, y = map(float, batch.points[0, 0 if at_start else -1])
        edge_names = tuple(dict.fromkeys(names[edge.id] for edge in edges))
        nodes.append(SceneNode(node.id, x, y, edge_names))
    return SceneNetwork(
        network.name,
        tuple(nodes),
        tuple(names.values()),
        float(root.confidence),
        _mask(root),
        root.scale if root.mask is not None else None,
        origin=root.network.origin,
        junctions=scene_junctions(
            network.name,
            root.junctions.plans[network.name],
            right_of_way_rules(network, candidates),
        ),
    )


def _mask(root: NetworkRoot) -> str | None:
    if root.mask is None:
        return None
    import cv2

    fine, content = cv2.imencode(".png", np.asarray(root.mask, np.uint8) * 255)
    return base64.b64encode(content.tobytes()).decode() if fine else None


def _floats(values: NDArray[np.float64]) -> tuple[float, ...]:
    return tuple(values.tolist())
