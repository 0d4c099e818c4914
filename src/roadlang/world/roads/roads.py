"""Roads: drawn, read or selected of a network, then perturbed, in many candidates."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...evaluate.kind_instance import scalar
from ...geometry import Curve, CurveFrame, Path, Road, WidthProfile
from ...geometry.arrays import Floats
from ...geometry.networks.path_sections import section_of_path
from ...geometry.networks.polylines import DEFAULT_WIDTH
from ...ir.batch import RoadBatch
from ...ir.scenario import FileSource, ScenarioNetwork, ScenarioRoad
from ...ir.values import PassCall, Value
from ...plugins.guard import wrong_result
from ...plugins.lane_options import SAME_WIDTH
from ..lanes.lane_building import built_lanes
from ..lanes.lane_plan import LanePlan, is_fixed, lane_plan
from ..lanes.lane_widths import LANE_WIDTH
from ..networks.networks import NetworkRoot, edge_batch, network_root
from ..perturbing.perturbation import displaced, perturbed
from ..perturbing.root_roads import undisplaced_road
from ..perturbing.stations import station_spacing
from ..perturbing.verified import verified
from ..sources.reading import read_file
from .joined_roads import PartOfRoad, joined_root
from .road_root import RoadRoot
from .selection import selected


def road_batch(name: str, candidates: CandidateBatch) -> RoadBatch:
    """A road in all candidates, after all its passes."""
    road = candidates.scenario.roads[name]

    def make() -> RoadBatch:
        origin = candidates.scenario.source_of(road)
        if isinstance(origin, ScenarioRoad):
            batch = road_batch(origin.name, candidates)
        else:
            batch = _unperturbed(road, candidates)
        batch = replace(batch, name=name, width=_width(road, batch, candidates))
        for call in road.passes:
            if call.verb == "perturb":
                batch = perturbed(batch, call, candidates)
        return batch

    return candidates.once(("road", name), make)


def road_root(name: str, candidates: CandidateBatch) -> RoadRoot:
    """What a road is before anything was perturbed."""
    scenario = candidates.scenario
    bottom = list(scenario.roads_below(scenario.roads[name]))[-1]
    drawn = scenario.is_varying(bottom.name)
    return candidates.root(("road root", bottom.name), drawn, partial(_root, bottom))


def _width(road: ScenarioRoad, before: RoadBatch, candidates: CandidateBatch) -> Floats:
    """As written; of lanes on a road that was not measured, what they add up to."""
    options = road.options
    if "width" in options:
        width = _written_width(road, options["width"], candidates)
        if options.keys() & {"left", "right"}:
            _require_sum(road, width, candidates)
        return width
    if options.keys() & {"left", "right"} and not _is_measured(road, candidates):
        return _extent(road, lane_plan(road, candidates.scenario), candidates)
    written = any("width" in link.options for link in candidates.scenario.roads_below(road))
    if "lanes" in options and not written and not _is_measured(road, candidates):
        count = np.atleast_2d(np.asarray(evaluate(options["lanes"], candidates), float))
        return np.asarray(LANE_WIDTH * np.maximum(np.rint(count), 1.0))
    return before.width


def _written_width(road: ScenarioRoad, written: Value, candidates: CandidateBatch) -> Floats:
    value = np.atleast_2d(np.asarray(evaluate(written, candidates), float))
    if not (value > 0).all() or not np.isfinite(value).all():
        raise DiagnosticError(
            diagnose(
                Code.NON_POSITIVE_WIDTH, road.span, name=road.name, width=f"{float(value.min()):g}m"
            )
        )
    return value


def _require_sum(road: ScenarioRoad, width: Floats, candidates: CandidateBatch) -> None:
    """Raises RL246 where the lanes of the same statement do not add up to its width."""
    extent = _extent(road, lane_plan(road, candidates.scenario), candidates)
    apart = np.abs(width - extent)
    if not (apart < SAME_WIDTH).all():
        row = int(apart.max(axis=1).argmax())
        lanes, written = (float(part[min(row, len(part) - 1), 0]) for part in (extent, width))
        raise DiagnosticError(
            diagnose(
                Code.LANES_DISAGREE_WITH_WIDTH,
                road.span,
                name=road.name,
                lanes=f"{lanes:.6g}m",
                width=f"{written:.6g}m",
            )
        )


def _is_measured(road: ScenarioRoad, candidates: CandidateBatch) -> bool:
    """Whether the width of a road comes from a picture or file, with nothing written over it."""
    links = list(candidates.scenario.roads_below(road))
    if any(link.options.keys() & {"width", "left", "right"} for link in links[1:]):
        return False
    root = road_root(road.name, candidates)
    return root.width is not None and not root.is_joined


def _extent(road: ScenarioRoad, plan: LanePlan, candidates: CandidateBatch) -> Floats:
    """(V, 1) meters from edge to edge of the drivable lanes as listed."""
    if is_fixed(plan, candidates.scenario):
        return built_lanes(plan, candidates).extent()
    singles = (candidates.take(np.array([row])) for row in range(candidates.count))
    return np.concatenate([built_lanes(plan, single).extent() for single in singles])


def _unperturbed(road: ScenarioRoad, candidates: CandidateBatch) -> RoadBatch:
    """A root road, or the way through a network that has been perturbed before."""
    root = road_root(road.name, candidates)
    stations = root.frame.stations
    width = (
        np.full((1, 1), DEFAULT_WIDTH) if root.width is None else root.width.at(stations)[None, :]
    )
    batch = undisplaced_road(road.name, root.id, root.frame, width, root.confidence)
    network = root.network
    if network is None or root.path is None or not _is_perturbed(network, candidates.scenario):
        return batch
    return displaced(batch, _along_path(root, network, candidates))


def _is_perturbed(network: ScenarioNetwork, scenario: IndexedScenario) -> bool:
    return any(call.verb == "perturb" for link in scenario.chain(network) for call in link.passes)


def _along_path(root: RoadRoot, network: ScenarioNetwork, candidates: CandidateBatch) -> Floats:
    """(V, S) displacements of the edges under a path, at the stations of the path."""
    assert root.path is not None
    traveled = root.frame.stations * (root.path.length / root.frame.curve.length)
    ends = np.cumsum([step.length for step in root.path.steps])
    displacement = np.zeros((1, len(traveled)))
    before = 0.0
    for index, step in enumerate(root.path.steps):
        last = index == len(root.path.steps) - 1
        on_step = (traveled >= before) & (traveled < ends[index] if not last else True)
        batch = edge_batch(network, step.edge, candidates)
        direction = 1.0 if step.stop >= step.start else -1.0
        at = step.start + direction * (traveled[on_step] - before)
        part = direction * _interpolated(batch, at)
        if part.shape[0] > displacement.shape[0]:
            displacement = np.repeat(displacement, part.shape[0], axis=0)
        displacement[:, on_step] = part
        before = float(ends[index])
    return displacement


def _interpolated(batch: RoadBatch, at: Floats) -> Floats:
    """(V, n) displacements of an edge at arc lengths between its stations."""
    stations, displacement = batch.stations, batch.displacement
    if batch.period is not None:
        stations = np.append(stations, batch.period)
        displacement = np.concatenate([displacement, displacement[:, :1]], axis=1)
    right = np.clip(np.searchsorted(stations, at), 1, len(stations) - 1)
    gap = stations[right] - stations[right - 1]
    share = np.clip((at - stations[right - 1]) / gap, 0.0, 1.0)
    return displacement[:, right - 1] * (1.0 - share) + displacement[:, right] * share


def _root(road: ScenarioRoad, candidates: CandidateBatch) -> RoadRoot:
    scenario = candidates.scenario
    if scenario.is_joined(road):
        return joined_root(road, _parts(road, candidates), candidates)
    if road.source is None:
        curve = _drawn(road, candidates)
        return RoadRoot(road.name, _frame(curve, road, scenario))
    if isinstance(road.source, FileSource):
        return _from_file(road, road.source, candidates)
    network = scenario.source_of(road)
    assert isinstance(network, ScenarioNetwork)
    root = network_root(network, candidates)
    path = selected(road, root, candidates)
    steps = path.steps
    if len(steps) == 1 and steps[0].start == 0.0 and steps[0].length >= path.length:
        edge = root.network.edge(steps[0].edge)
        if steps[0].stop >= edge.length:
            id = f"{root.name}/{edge.id}"
            frame, width = root.frame(edge.id), edge.width
            section = edge.cross_section
            return RoadRoot(id, frame, width, section, path, network, root.inputs, root.confidence)
    return _path_root(root, path, network, candidates)


def _parts(road: ScenarioRoad, candidates: CandidateBatch) -> list[PartOfRoad]:
    return [
        PartOfRoad(part, road_batch(part.name, candidates), road_root(part.name, candidates))
        for part in candidates.scenario.joined_roads(road)
    ]


def _path_root(
    root: NetworkRoot, path: Path, network: ScenarioNetwork, candidates: CandidateBatch
) -> RoadRoot:
    """The same way through the same network is one root, whichever road statement names it."""
    steps = "+".join(f"{step.edge}:{step.start:.6g}:{step.stop:.6g}" for step in path.steps)
    keeper = candidates if candidates.scenario.is_varying(network.name) else candidates.scenario

    def frame() -> CurveFrame:
        return _frame(path.curve, network, candidates.scenario)

    id = f"{root.name}/{steps}"
    shared = keeper.once(("way", id), frame)
    width = path.width
    section = section_of_path(path)
    return RoadRoot(id, shared, width, section, path, network, root.inputs, root.confidence)


def _frame(
    curve: Curve, source: ScenarioRoad | ScenarioNetwork, scenario: IndexedScenario
) -> CurveFrame:
    return CurveFrame.of(curve, station_spacing(source, scenario).stations(curve))


def _drawn(road: ScenarioRoad, candidates: CandidateBatch) -> Curve:
    calls = [call for call in road.passes if call.verb == "draw"]
    if not calls:
        raise DiagnosticError(diagnose(Code.MISSING_SOURCE, road.span, name=road.name))
    closed = _is_closed(road, candidates)
    built = build(calls[0], candidates, single=True)
    with built.guarded:
        curve = built.kind.draw(closed)
    if not isinstance(curve, Curve):
        fault = f"gave a {type(curve).__name__}, not a Curve"
        raise wrong_result(built.entry, calls[0].span, fault)
    return verified(calls[0], road.name, _checked(curve, road, calls[0]), candidates)


def _from_file(road: ScenarioRoad, source: FileSource, candidates: CandidateBatch) -> RoadRoot:
    content = read_file(source, "road", road.passes, candidates.scenario, road.span)
    found: Curve | Road = content.value
    curve = found.curve if isinstance(found, Road) else found
    width = found.width if isinstance(found, Road) else None
    section = found.section if isinstance(found, Road) else None
    lanes = found.lanes if isinstance(found, Road) else None
    closed = road.options.get("closed")
    if closed is not None and bool(scalar(evaluate(closed, candidates))) != curve.closed:
        curve = Curve.through(curve.points, not curve.closed)
        width = None if width is None else WidthProfile.even(width.widths, curve.length)
    reading = next(call for call in road.passes if call.verb == "read")
    curve = verified(reading, road.name, _checked(curve, road, reading), candidates)
    frame = _frame(curve, road, candidates.scenario)
    return RoadRoot(road.name, frame, width, section, inputs=content.inputs, lanes=lanes)


def _is_closed(road: ScenarioRoad, candidates: CandidateBatch) -> bool:
    option = road.options.get("closed")
    return option is not None and bool(scalar(evaluate(option, candidates)))


def _checked(curve: Any, road: ScenarioRoad, call: PassCall) -> Curve:
    span = call.span or road.span
    usable = isinstance(curve, Curve) and np.isfinite(curve.points).all() and 0 < curve.length < 1e7
    if not usable:
        raise DiagnosticError(diagnose(Code.INVALID_ROAD_GEOMETRY, span, name=road.name))
    checked: Curve = curve
    return checked
