"""Roads joined end to end (`then:`): a root made of the roads of a single candidate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import evaluate
from ...evaluate.kind_instance import scalar
from ...geometry import (
    CrossSection,
    Curve,
    CurveFrame,
    RoadToJoin,
    WidthProfile,
    joined_curve,
    joined_section,
    parts_with_cut_tapers,
    seams,
)
from ...ir.batch import RoadBatch
from ...ir.scenario import ScenarioRoad
from ..lanes.lane_plan import lane_plan
from ..perturbing.root_roads import is_undisplaced
from ..perturbing.stations import station_spacing
from .road_root import LimitChange, RoadRoot
from .root_lanes import lanes_on_root

DEFAULT_TAPER = 30.0
"""Meters."""


@dataclass(frozen=True, eq=False)
class PartOfRoad:
    """One of the roads that are joined, after all its passes, and the root that it goes back to."""

    road: ScenarioRoad
    batch: RoadBatch
    root: RoadRoot


def joined_root(
    road: ScenarioRoad, parts: Sequence[PartOfRoad], candidates: CandidateBatch
) -> RoadRoot:
    """The root of a road that is joined of others. Raises RL432 for a loop among them."""
    for part in parts:
        if part.batch.closed:
            raise DiagnosticError(
                diagnose(Code.CLOSED_ROAD_JOINED, road.span, name=part.road.name, road=road.name)
            )
    roads = [RoadToJoin(_curve(part), _section(part, candidates)) for part in parts]
    curve = joined_curve([part.curve for part in roads])
    taper = _taper(road, candidates)
    section = joined_section(roads, taper)
    starts = seams([part.curve for part in roads])
    limits = [_limit(part, candidates) for part in parts]
    return RoadRoot(
        road.name,
        CurveFrame.of(curve, station_spacing(road, candidates.scenario).stations(curve)),
        section.drivable_profile(),
        section,
        inputs=tuple(dict.fromkeys(file for part in parts for file in part.root.inputs)),
        confidence=min(part.root.confidence for part in parts),
        limits=_changes(starts, limits),
        is_joined=True,
        starts=tuple(starts),
        warnings=_cut_tapers(road, parts, roads, taper) if "taper" in road.options else (),
    )


def _curve(part: PartOfRoad) -> Curve:
    if is_undisplaced(part.batch):
        return part.root.frame.curve
    return Curve.hermite(part.batch.points[0], part.batch.heading[0])


def _section(part: PartOfRoad, candidates: CandidateBatch) -> CrossSection:
    """The lanes of a part by its arc length; their limits are those of the lanes themselves."""
    plan = replace(lane_plan(part.road, candidates.scenario), speed_limit=None)
    lanes = lanes_on_root(plan, part.root, candidates)
    arc = part.batch.stations
    if not is_undisplaced(part.batch):
        steps = np.hypot(*np.diff(part.batch.points[0], axis=0).T)
        arc = np.concatenate([[0.0], np.cumsum(steps)])
    width = np.broadcast_to(part.batch.width, (1, len(arc)))[0]
    return lanes.cross_section(WidthProfile(arc, width), part.batch.stations)


def _taper(road: ScenarioRoad, candidates: CandidateBatch) -> float:
    written = road.options.get("taper")
    return DEFAULT_TAPER if written is None else float(scalar(evaluate(written, candidates)))


def _cut_tapers(
    road: ScenarioRoad, parts: Sequence[PartOfRoad], roads: Sequence[RoadToJoin], taper: float
) -> tuple[Diagnostic, ...]:
    """RL443 for each part in which lanes taper over less than the file says."""
    span = road.option_spans.get("taper", road.span)
    found = []
    for index in parts_with_cut_tapers(roads, taper):
        half = f"{roads[index].curve.length / 2.0:.6g}m"
        help_ = f"write `taper: {half}`, or make `{parts[index].road.name}` {2.0 * taper:.6g}m long"
        found.append(
            diagnose(
                Code.CUT_TAPER,
                span,
                road=road.name,
                part=parts[index].road.name,
                taper=half,
                help=help_,
            )
        )
    return tuple(found)


def _limit(part: PartOfRoad, candidates: CandidateBatch) -> tuple[LimitChange, ...]:
    """The speed limits along a part, by its own arc length."""
    written = lane_plan(part.road, candidates.scenario).speed_limit
    if written is not None:
        return (LimitChange(0.0, float(scalar(evaluate(written, candidates)))),)
    return part.root.limits or (LimitChange(0.0, None),)


def _changes(
    starts: Sequence[float], limits: Sequence[tuple[LimitChange, ...]]
) -> tuple[LimitChange, ...]:
    """Where the limit changes along the joined road; none where nobody says one."""
    found: list[LimitChange] = []
    for start, part in zip(starts, limits, strict=True):
        for change in part:
            if not found or found[-1].speed_limit != change.speed_limit:
                found.append(LimitChange(start + change.start, change.speed_limit))
    return () if all(change.speed_limit is None for change in found) else tuple(found)
