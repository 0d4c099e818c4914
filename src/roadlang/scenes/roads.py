"""The roads and networks of scenes."""

from __future__ import annotations

import base64
from dataclasses import replace
from functools import partial

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.option_bounds import check_number, common_option
from ..geometry import Edge
from ..ir.batch import RoadBatch
from ..ir.contained_values import values_in
from ..ir.scenario import LANE_OPTIONS, ScenarioNetwork, ScenarioRoad
from ..ir.scene import SceneNetwork, SceneNode, SceneRoad
from ..ir.scene_road import SpeedZone
from ..ir.values import ConstantValue
from ..world.lanes.lane_plan import lane_plan, traffic_side
from ..world.networks.junction_control import controls_of, right_of_way_rules
from ..world.networks.networks import NetworkRoot, edge_batch, lanes_of_edge, network_root
from ..world.placement.road_strips import has_descendants, has_perturbed_descendants
from ..world.roads.road_lanes import lane_parts, lanes_of
from ..world.roads.roads import road_batch, road_root
from ..world.roads.selected_roads import parts_of_network, steps_in_network
from .junctions import scene_junctions
from .road_rows import road_rows
from .road_surfaces import covered, covered_edges
from .scene_rows import SceneRows


def scene_roads(rows: SceneRows) -> list[tuple[SceneRoad, ...]]:
    """Declared roads and the edges of all networks (`town/3`)."""
    scenario = rows.scenario
    columns = [covered(_declared(road, rows), road, rows) for road in scenario.roads.values()]
    for network in scenario.networks.values():
        edges = network_root(network, rows.candidates).edges
        ids = [edge.id for edge in edges]
        columns += covered_edges([_edge(network, e, rows) for e in edges], ids, network, rows)
    return list(zip(*columns, strict=True)) if columns else rows.same(())


def scene_networks(rows: SceneRows) -> list[tuple[SceneNetwork, ...]]:
    """Nodes, the names of the roads, and the mask for tiles."""
    columns = []
    for network in rows.scenario.networks.values():
        make = partial(_network, network)
        if _is_equal_network(network, rows) and not rows.differ(
            *controls_of(network, rows.scenario)
        ):
            key = ("scene network", network.name)
            columns.append(rows.same(rows.scenario.once(key, partial(make, rows.alone(0)))))
        else:
            columns.append(rows.each(make))
    return list(zip(*columns, strict=True)) if columns else rows.same(())


def _declared(road: ScenarioRoad, rows: SceneRows) -> list[SceneRoad]:
    if _is_equal(road, rows):
        key = ("scene road", road.name)
        return rows.same(rows.scenario.once(key, lambda: _made(road, rows.alone(0))[0]))
    differ = len(lane_parts(road.name, rows.candidates)) > 1
    if differ or steps_in_network(road, rows.candidates) is not None:
        return rows.each(lambda candidate: _made(road, candidate)[0])
    made = _made(road, rows.candidates)
    return made if len(made) == rows.count else made * rows.count


def _is_equal(road: ScenarioRoad, rows: SceneRows) -> bool:
    """Whether a road is the same in all scenes."""
    scenario = rows.scenario
    values = [value for link in scenario.ancestry(road) for value in values_in(link)]
    return not scenario.is_random(road) and not rows.differ(*values, traffic_side(scenario))


def _made(road: ScenarioRoad, candidates: CandidateBatch) -> list[SceneRoad]:
    """A declared road of each candidate that has the same lanes; one where all are equal."""
    scenario = candidates.scenario
    batch, lanes = road_batch(road.name, candidates), lanes_of(road.name, candidates)
    along = parts_of_network(road, candidates)
    derived = not has_descendants(road, scenario)
    found = road_rows(
        batch,
        lanes,
        _speed_limits(road, candidates),
        scenario,
        name=road.name,
        root=_root_name(road, candidates),
        derived=derived and not (along and _is_network_built(road, candidates)),
        along=along,
    )
    if not road_root(road.name, candidates).limits:
        return found
    return [replace(made, speed_zones=_speed_zones(made, road, candidates)) for made in found]


def _is_network_built(road: ScenarioRoad, candidates: CandidateBatch) -> bool:
    network = road_root(road.name, candidates).network
    return network is not None and not has_perturbed_descendants(network, candidates.scenario)


def _edge(network: ScenarioNetwork, edge: Edge, rows: SceneRows) -> list[SceneRoad]:
    if _is_equal_network(network, rows):
        key = ("scene road", network.name, edge.id)
        return rows.same(
            rows.scenario.once(key, lambda: _made_edge(network, edge, rows.alone(0))[0])
        )
    scenario, plan = rows.scenario, lane_plan(network, rows.scenario)
    if rows.differ(*(getattr(plan, name) for name in LANE_OPTIONS), traffic_side(scenario)):
        return rows.each(lambda candidate: _made_edge(network, edge, candidate)[0])
    made = _made_edge(network, edge, rows.candidates)
    return made if len(made) == rows.count else made * rows.count


def _is_equal_network(network: ScenarioNetwork, rows: SceneRows) -> bool:
    """Whether all roads of a network are the same in all scenes."""
    scenario = rows.scenario
    if scenario.is_varying(network.name):
        return False
    links = [link for link in scenario.chain(network) if isinstance(link, ScenarioNetwork)]
    passes = [call for link in links for call in link.passes if call.verb == "perturb"]
    options = [value for link in links for value in link.options.values()]
    return not passes and not scenario.dependencies.differ(*options, traffic_side(scenario))


def _made_edge(network: ScenarioNetwork, edge: Edge, candidates: CandidateBatch) -> list[SceneRoad]:
    """An edge of each candidate that has the same lanes; one where all are equal."""
    scenario, root = candidates.scenario, network_root(network, candidates)
    batch = edge_batch(network, edge.id, candidates)
    found = road_rows(
        batch,
        lanes_of_edge(network, edge.id, candidates),
        _speed_limits(network, candidates),
        scenario,
        name=f"{network.name}/{edge.id}",
        root=f"{_bottom(network, scenario)}/{edge.id}",
        derived=not has_perturbed_descendants(network, scenario),
        network=network.name,
        edge=edge.id,
        street=edge.name,
        elevation=_elevation(edge, batch),
    )
    trims = root.junctions.plans[network.name].trims[edge.id]
    return [replace(road, trim=_trim(road, edge.length, trims)) for road in found]


def _elevation(edge: Edge, batch: RoadBatch) -> tuple[float, ...]:
    """Meters at the stations of an edge; empty where its map says nothing of heights."""
    if edge.elevations is None:
        return ()
    places = np.linspace(0.0, edge.length, len(edge.elevations))
    return tuple(np.interp(batch.stations, places, edge.elevations).tolist())


def _speed_limits(
    source: ScenarioRoad | ScenarioNetwork, candidates: CandidateBatch
) -> list[float | None]:
    """Of each candidate, or one for all."""
    value = lane_plan(source, candidates.scenario).speed_limit
    if value is None:
        return [None]
    found = np.asarray(evaluate(value, candidates), float)
    if not isinstance(value, ConstantValue):
        span = source.option_spans.get("speed_limit", source.span)
        check_number(common_option("lane", "speed_limit"), found, source.name, span)
    return found.reshape(-1).tolist()


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
