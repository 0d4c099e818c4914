"""Networks: extracted from pictures or read from files, edge by edge in many candidates."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...evaluate.kind_instance import scalar
from ...geometry import CurveFrame, Edge, RoadNetwork, WidthProfile
from ...geometry.arrays import Floats
from ...geometry.junctions.one_way import one_way
from ...geometry.junctions.raised_roads import with_heights
from ...geometry.networks.joints import junction_window
from ...ir.batch import RoadBatch
from ...ir.picture import Extraction, FoundObject
from ...ir.scenario import FileSource, Input, ScenarioImage, ScenarioNetwork
from ...ir.values import PassCall
from ...plugins.guard import plugin_guard
from ...plugins.results import check_extraction
from ..lanes.cross_sections import LaneBatch
from ..lanes.lane_building import built_lanes
from ..lanes.lane_plan import lane_plan
from ..lanes.lane_widths import as_wide_as_lanes
from ..perturbing.beside_arms import room_beside
from ..perturbing.perturbation import perturbed
from ..perturbing.root_roads import undisplaced_road
from ..perturbing.stations import StationSpacing, station_spacing
from ..perturbing.verified import verified
from ..sources.clipped_networks import clipped_network
from ..sources.corrected_networks import corrected_extraction
from ..sources.moved_networks import moved_network
from ..sources.pictures import LoadedPicture, load_picture
from ..sources.reading import read_file
from ..sources.roadless_sources import advice_without_roads
from ..sources.seen_pictures import seen_before
from ..sources.upright_masks import with_upright_mask
from .junctions import NetworkPlans, directed, network_plans
from .width_changes import with_width_changes


@dataclass(frozen=True, eq=False)
class NetworkRoot:
    """A network before any `perturb`. `mask` are the road pixels, where the extractor has them,
    `inputs` the files that it was made from,
    `warnings` what is to be said of them."""

    name: str
    network: RoadNetwork
    spacing: StationSpacing
    objects: tuple[FoundObject, ...] = ()
    confidence: float = 1.0
    remarks: tuple[str, ...] = ()
    mask: NDArray[np.bool_] | None = None
    scale: float | None = None
    inputs: tuple[Input, ...] = ()
    warnings: tuple[Diagnostic, ...] = ()
    junctions: NetworkPlans = field(default_factory=NetworkPlans)
    _frames: dict[int, CurveFrame] = field(default_factory=dict)
    _rooms: dict[int, Floats | None] = field(default_factory=dict)

    def frame(self, edge: int) -> CurveFrame:
        """The frame of an edge at its stations, of which one is at each trim, and some where the
        widths of its lanes change; always the same object."""
        if edge not in self._frames:
            curve, section = self.network.edge(edge).curve, self.network.edge(edge).cross_section
            stations = self.spacing.stations(curve)
            if section is not None:
                stations = with_width_changes(stations, section)
            stations = self.junctions.stations(edge, stations, curve.length)
            self._frames[edge] = CurveFrame.of(curve, stations)
        return self._frames[edge]

    def room(self, edge: int, stations: Floats) -> Floats | None:
        """(S,) meters that an edge may be moved beside others: see `room_beside`."""
        if edge not in self._rooms:
            plans, found = self.junctions.plans.values(), self.network.edge(edge)
            self._rooms[edge] = room_beside(self.network, plans, found, stations)
        return self._rooms[edge]

    @cached_property
    def edges(self) -> tuple[Edge, ...]:
        """The edges of the network."""
        return self.network.edges


def network_root(network: ScenarioNetwork, candidates: CandidateBatch) -> NetworkRoot:
    """The network at the bottom of a chain of networks."""
    scenario = candidates.scenario
    bottom: Any = list(_networks(network, scenario))[-1]
    drawn = scenario.is_varying(bottom.name)
    return candidates.root(("network root", bottom.name), drawn, partial(_root, bottom))


def edge_batch(network: ScenarioNetwork, edge: int, candidates: CandidateBatch) -> RoadBatch:
    """One road of a network in all candidates, perturbed by all passes."""

    def make() -> RoadBatch:
        origin = candidates.scenario.source_of(network)
        if isinstance(origin, ScenarioNetwork):
            batch = edge_batch(origin, edge, candidates)
        else:
            batch = _root_edge(network, edge, candidates)
        named = replace(batch, name=f"{network.name}/{edge}")
        return _perturbed_edge(named, network, edge, candidates)

    return candidates.once(("edge", network.name, edge), make)


def lanes_of_edge(network: ScenarioNetwork, edge: int, candidates: CandidateBatch) -> LaneBatch:
    """The lanes of one road of a network, of candidates that have the same ones.

    Those of a roundabout run one way.
    """
    root = network_root(network, candidates)
    plan = lane_plan(network, candidates.scenario)
    found = root.network.edge(edge)
    lanes = built_lanes(plan, candidates, found.cross_section)
    lanes = replace(lanes, pattern=directed(lanes.pattern, found))
    ring = root.junctions.plans[network.name].ring
    if edge in ring:
        lanes = replace(lanes, pattern=one_way(lanes.pattern, ring[edge]))
    return lanes


def _root_edge(network: ScenarioNetwork, edge: int, candidates: CandidateBatch) -> RoadBatch:
    root = network_root(network, candidates)
    frame = root.frame(edge)
    found = root.network.edge(edge)
    width: WidthProfile = found.width
    name = f"{root.name}/{edge}"
    return undisplaced_road(name, name, frame, width.at(frame.stations)[None, :], found.confidence)


def _perturbed_edge(
    batch: RoadBatch, network: ScenarioNetwork, edge: int, candidates: CandidateBatch
) -> RoadBatch:
    calls = [call for call in network.passes if call.verb == "perturb"]
    if not calls:
        return batch
    root = network_root(network, candidates)
    found = root.network.edge(edge)
    trims = root.junctions.frozen(edge, batch.stations, found.length)
    window = junction_window(root.network, found, batch.stations, trims=trims)
    room = root.room(edge, batch.stations)
    share = None if room is None else room / len(calls)
    for call in calls:
        if edge in chosen_edges(call, root.network, candidates):
            batch = perturbed(batch, call, candidates, edge, window, share)
    return batch


def chosen_edges(
    call: PassCall, network: RoadNetwork, candidates: CandidateBatch
) -> frozenset[int]:
    """The ids of the edges that a pass is about: all, or those of its `roads`. Raises RL411."""
    option = call.common.get("roads")
    every = frozenset(edge.id for edge in network.edges)
    if option is None:
        return every
    ids = scalar(evaluate(option, candidates))
    chosen = frozenset(round(id) for id in (ids if isinstance(ids, tuple) else (ids,)))
    if chosen - every:
        raise _no_such_road(min(chosen - every), network, call.span)
    return chosen


def _no_such_road(id: int, network: RoadNetwork, span: Span | None) -> DiagnosticError:
    known = ", ".join(str(edge.id) for edge in network.edges[:20])
    return DiagnosticError(
        diagnose(Code.UNKNOWN_ROAD_ID, span, id=id, help=f"its roads are {known}")
    )


def _networks(network: ScenarioNetwork, scenario: IndexedScenario) -> Any:
    return (link for link in scenario.chain(network) if isinstance(link, ScenarioNetwork))


def _root(network: ScenarioNetwork, candidates: CandidateBatch) -> NetworkRoot:
    source = network.source
    if isinstance(source, FileSource):
        found = _from_file(network, source, candidates)
    else:
        found = _extracted(network, candidates)
    if not found.network.edges:
        raise _empty(network, (*found.remarks, advice_without_roads(network, candidates)))
    found = _within(network, found, candidates)
    moved = moved_network(network, found.network, candidates)
    if moved is not found.network:  # the pixels are where they were
        found = replace(found, network=moved, mask=None)
    found = replace(found, network=with_heights(found.network))
    plans = network_plans(network, found.network, candidates)
    return replace(found, junctions=plans)


def _empty(network: ScenarioNetwork, help: tuple[str, ...]) -> DiagnosticError:
    return DiagnosticError(diagnose(Code.EMPTY_NETWORK, network.span, name=network.name, help=help))


def _within(
    network: ScenarioNetwork, found: NetworkRoot, candidates: CandidateBatch
) -> NetworkRoot:
    """What its option `within` keeps of a network. Raises RL412 where that is nothing."""
    every = Extraction(found.network, found.objects, mask=found.mask)
    kept = clipped_network(network, every, found.scale, candidates)
    if kept is every:
        return found
    if not kept.network.edges:
        west, south, east, north = (f"{meters:.0f}m" for meters in every.network.bounds)
        extent = f"its roads lie between ({west}, {south}) and ({east}, {north})"
        raise _empty(network, (extent,))
    return replace(found, network=kept.network, objects=kept.objects, mask=kept.mask)


def _from_file(
    network: ScenarioNetwork, source: FileSource, candidates: CandidateBatch
) -> NetworkRoot:
    scenario = candidates.scenario
    content = read_file(source, "network", network.passes, scenario, network.span)
    value: Extraction | RoadNetwork = content.value
    call = next(call for call in network.passes if call.verb == "read")
    found = Extraction(value) if isinstance(value, RoadNetwork) else value
    found = verified(call, network.name, found, candidates)
    spacing = station_spacing(network, scenario)
    return _root_of(network.name, found, spacing, None, content.inputs)


def _root_of(
    name: str,
    found: Extraction,
    spacing: StationSpacing,
    scale: float | None,
    inputs: tuple[Input, ...],
) -> NetworkRoot:
    return NetworkRoot(
        name,
        found.network,
        spacing,
        found.objects,
        found.confidence,
        found.remarks,
        found.mask,
        scale,
        inputs,
        found.warnings,
    )


def found_in_picture(
    network: ScenarioNetwork, candidates: CandidateBatch
) -> tuple[Extraction, LoadedPicture]:
    """What is extracted from the picture of a network, before anything is changed by hand."""
    image = candidates.scenario.source_of(network)
    assert isinstance(image, ScenarioImage)
    call = next(call for call in network.passes if call.verb == "extract")
    loaded = load_picture(image.name, candidates)
    built = build(call, candidates, single=True)
    span = call.span or network.span

    def extract() -> Extraction:
        with plugin_guard(built.entry, span):
            found: Extraction = built.kind.extract(loaded.picture)
        check_extraction(found, built.entry, span)
        return found

    is_pure = built.kind.is_pure
    found = seen_before(built.kind, loaded.picture, extract) if is_pure else extract()
    return verified(call, network.name, found, candidates), loaded


def _extracted(network: ScenarioNetwork, candidates: CandidateBatch) -> NetworkRoot:
    found, loaded = found_in_picture(network, candidates)
    if not found.has_widths:
        found = replace(found, network=as_wide_as_lanes(network, found.network, candidates))
    found = corrected_extraction(network, found, loaded.picture, candidates)
    placed = replace(found.network, origin=loaded.origin)
    found = replace(found, network=placed, warnings=(*loaded.warnings, *found.warnings))
    found = with_upright_mask(found, loaded.picture)
    spacing = station_spacing(network, candidates.scenario)
    return _root_of(network.name, found, spacing, loaded.picture.scale, loaded.inputs)
