"""The lanes of declared roads, for many candidates or for one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ...evaluate.candidates import CandidateBatch, fixed_candidate
from ...evaluate.evaluation import evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...ir.scenario import LANE_OPTIONS
from ...ir.values import ConstantValue
from ..lanes.cross_sections import LaneBatch
from ..lanes.lane_plan import LanePlan, is_fixed, lane_plan, traffic_side
from .roads import road_root
from .root_lanes import lanes_on_root

Rows = NDArray[np.intp]


def lanes_of(name: str, candidates: CandidateBatch) -> LaneBatch:
    """The lanes of a road of a single candidate."""
    ((_, lanes),) = lane_parts(name, candidates)
    return lanes


def lane_parts(name: str, candidates: CandidateBatch) -> tuple[tuple[Rows, LaneBatch], ...]:
    """Candidates that have the same lanes, apart from widths, and these lanes.

    Each candidate is in one part; all are in one part where the lanes themselves are not drawn.
    """

    def make() -> tuple[tuple[Rows, LaneBatch], ...]:
        scenario = candidates.scenario
        plan, fixed, drawn = scenario.once(("lane plan", name), lambda: _plan(name, scenario))
        every = np.arange(candidates.count)
        if not drawn:
            return ((every, _lanes_of_all(plan, name, scenario)),)
        parts = ((every, plan),) if fixed else _by_plan(plan, candidates)
        return tuple((rows, _lanes(plan, name, candidates, rows)) for rows, plan in parts)

    return candidates.once(("lanes", name), make, inherited=False)


def _plan(name: str, scenario: IndexedScenario) -> tuple[LanePlan, bool, bool]:
    """What is written about the lanes of a road, whether they are the same everywhere apart from
    widths and limits, and whether anything of them is drawn."""
    plan = lane_plan(scenario.roads[name], scenario)
    written = [getattr(plan, option) for option in LANE_OPTIONS]
    drawn = scenario.dependencies.differ(*written, traffic_side(scenario))
    return plan, is_fixed(plan, scenario), drawn or scenario.is_varying(name)


def _lanes_of_all(plan: LanePlan, name: str, scenario: IndexedScenario) -> LaneBatch:
    only, first = fixed_candidate(scenario), np.zeros(1, dtype=np.intp)
    return scenario.once(("lanes of all", name), lambda: _lanes(plan, name, only, first))


def _by_plan(plan: LanePlan, candidates: CandidateBatch) -> Iterator[tuple[Rows, LanePlan]]:
    """Parts of the candidates, of lanes that are drawn."""
    every = np.arange(candidates.count)
    if plan.lanes is not None and is_fixed(replace(plan, lanes=None), candidates.scenario):
        numbers = np.asarray(evaluate(plan.lanes, candidates), float).reshape(-1)
        counts = np.broadcast_to(np.maximum(1, np.rint(numbers)), (candidates.count,))
        for count in np.unique(counts).tolist():
            yield np.flatnonzero(counts == count), replace(plan, lanes=ConstantValue(count))
    else:
        for row in every:
            yield np.array([row]), plan


def _lanes(plan: LanePlan, name: str, candidates: CandidateBatch, rows: Rows) -> LaneBatch:
    part = candidates if len(rows) == candidates.count else candidates.take(rows)
    return lanes_on_root(plan, road_root(name, part), part)
