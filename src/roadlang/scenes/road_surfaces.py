"""What the roads of scenes are made of or covered by."""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..diagnostics import DiagnosticError, Span
from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import scalar
from ..ir.scenario import ScenarioNetwork, ScenarioRoad
from ..ir.scene_road import SceneRoad
from ..ir.scene_surface import SurfaceName, SurfacePatch
from ..ir.values import Value
from ..world.perturbing.interval_faults import interval_off_road
from ..world.roads.roads import road_root
from ..world.surface_faults import PATCHES, patch_span, unknown_patch_lane, unknown_patch_road
from .scene_rows import SceneRows

SURFACE_OPTIONS = ("surface", PATCHES)
Statement = ScenarioRoad | ScenarioNetwork


@dataclass(frozen=True)
class _Patch:
    """A stretch by arc lengths of the root road; without `lane` and `side` of all lanes."""

    surface: SurfaceName
    start: float
    end: float
    lane: int | None = None
    side: str | None = None
    road: int | None = None
    span: Span | None = None


@dataclass(frozen=True)
class _Cover:
    """What is said of one road or network in one candidate."""

    surface: SurfaceName | None
    patches: tuple[_Patch, ...]


def covered_edges(
    edges: Sequence[Sequence[SceneRoad]],
    ids: Sequence[int],
    network: ScenarioNetwork,
    rows: SceneRows,
) -> list[list[SceneRoad]]:
    """The roads of a network, each of every scene; `ids` are their numbers.

    A patch that names a lane, but no road, is on the roads that have this lane. Raises RL411, RL414
    and RL613, also for a lane that no road has.
    """
    lanes = frozenset(lane.id for roads in edges for road in roads for lane in road.lane_list)
    return [covered(roads, network, rows, ids, lanes) for roads in edges]


def covered(
    roads: Sequence[SceneRoad],
    source: Statement,
    rows: SceneRows,
    ids: Sequence[int] = (),
    elsewhere: Set[int] = frozenset(),
) -> list[SceneRoad]:
    """A road of each scene with what its statement, or what it is made from, says of its surface.

    `ids`: of the roads of a network, `elsewhere`: of the lanes of all of them. Raises RL411 for a
    patch on another road, RL414 for one that is not on its road, RL613 for one on a lane that this
    does not have.
    """
    said = list(_said(source, rows.scenario))
    if not said:
        return list(roads)
    if not rows.differ(*said):
        cover = _checked(_cover(source, rows.alone(0)), ids)
        made = {id(road): _with(road, cover, elsewhere) for road in roads}
        return [made[id(road)] for road in roads]
    covers = rows.each(lambda candidate: _checked(_cover(source, candidate), ids))
    return [_with(road, cover, elsewhere) for road, cover in zip(roads, covers, strict=True)]


def _checked(cover: _Cover, ids: Sequence[int]) -> _Cover:
    for patch in cover.patches:
        fault = None if patch.road is None else unknown_patch_road(patch.span, patch.road, ids)
        if fault is not None:
            raise DiagnosticError(fault)
    return cover


def _said(source: Statement, scenario: IndexedScenario) -> list[Value]:
    """All that is written of the surface of a road, and of those that it is joined of."""
    chain = _chain(source, scenario)
    found = [
        link.options[name] for link in chain for name in SURFACE_OPTIONS if name in link.options
    ]
    for link in chain:
        for part in scenario.joined_roads(link) if isinstance(link, ScenarioRoad) else ():
            found += _said(part, scenario)
    return found


def _chain(source: Statement, scenario: IndexedScenario) -> list[Statement]:
    return [
        link for link in scenario.chain(source) if isinstance(link, ScenarioRoad | ScenarioNetwork)
    ]


def _cover(source: Statement, candidates: CandidateBatch) -> _Cover:
    chain = _chain(source, candidates.scenario)
    written = next((link.options["surface"] for link in chain if "surface" in link.options), None)
    # A patch of a network counts along one of its roads, which is not what is selected from it.
    alike = [link for link in chain if type(link) is type(source)]
    listed = next((link for link in alike if PATCHES in link.options), None)
    surface = None if written is None else scalar(evaluate(written, candidates))
    below: tuple[_Patch, ...] = ()
    if written is None and alike and isinstance(alike[-1], ScenarioRoad):
        below = _of_parts(alike[-1], candidates)
    own: list[_Patch] = []
    if listed is not None:
        items = enumerate(evaluate(listed.options[PATCHES], candidates))
        own = [_patch(item, patch_span(listed, place)) for place, item in items]
    return _Cover(surface, (*below, *own))


def _patch(written: Any, span: Span | None) -> _Patch:
    said = {name: scalar(value) for name, value in dict(written).items()}
    start, end = said.get("over", (0.0, np.inf))
    lane, road = (None if said.get(name) is None else int(said[name]) for name in ("lane", "road"))
    return _Patch(said["surface"], float(start), float(end), lane, said.get("side"), road, span)


def _of_parts(road: ScenarioRoad, candidates: CandidateBatch) -> tuple[_Patch, ...]:
    """Those that a joined road has of its parts."""
    parts = candidates.scenario.joined_roads(road)
    if not parts:
        return ()
    starts = road_root(road.name, candidates).starts
    found: list[_Patch] = []
    for part, start, end in zip(parts, starts, (*starts[1:], np.inf), strict=True):
        cover = _cover(part, candidates)
        if cover.surface is not None:
            found.append(_Patch(cover.surface, start, end))
        found += [
            replace(patch, start=start + patch.start, end=min(start + patch.end, end))
            for patch in cover.patches
        ]
    return tuple(found)


def _with(road: SceneRoad, cover: _Cover, elsewhere: Set[int]) -> SceneRoad:
    ids = {lane.id for lane in road.lane_list}
    patches = [
        _placed(patch, road)
        for patch in cover.patches
        if patch.road in (None, road.edge)
        and not (patch.road is None and patch.lane in elsewhere - ids)
    ]
    found = tuple(patch for patch in patches if patch is not None)
    return replace(road, surface=cover.surface, surface_patches=found)


def _placed(patch: _Patch, road: SceneRoad) -> SurfacePatch | None:
    """Where it is on a road; None where none of its lanes is on its side."""
    last = road.length if road.closed else road.stations[-1]
    root = road.reference_stations
    root = (*root, 2.0 * root[-1] - root[-2]) if road.closed else root
    stations = (*road.stations, last) if road.closed else road.stations
    if not patch.start < patch.end or (patch.start >= root[-1] and road.network is None):
        raise DiagnosticError(
            interval_off_road(patch.span, road.name, patch.start, patch.end, root[-1])
        )
    ids = tuple(lane.id for lane in road.lane_list)
    lost = (
        None if patch.lane is None else unknown_patch_lane(patch.span, road.name, patch.lane, ids)
    )
    if lost is not None:
        raise DiagnosticError(lost)
    start, end = np.interp((patch.start, min(patch.end, 1e9)), root, stations).tolist()
    lanes = tuple(
        id
        for id in ids
        if patch.lane in (None, id) and patch.side in (None, "left" if id > 0 else "right")
    )
    if not lanes:  # which would be all
        return None
    return SurfacePatch(patch.surface, start, end, () if lanes == ids else lanes)
