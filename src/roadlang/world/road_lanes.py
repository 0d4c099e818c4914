"""The lanes of declared roads, for many candidates or for one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import ConstantValue
from .cross_sections import LaneBatch
from .lane_plan import LanePlan, is_fixed, lane_plan
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
        plan, fixed = scenario.once(("lane plan", name), lambda: _plan(name, scenario))
        every = np.arange(candidates.count)
        parts = ((every, plan),) if fixed else _by_plan(plan, candidates)
        return tuple((rows, _lanes(plan, name, candidates, rows)) for rows, plan in parts)

    return candidates.once(("lanes", name), make, inherited=False)


def _plan(name: str, scenario: IndexedScenario) -> tuple[LanePlan, bool]:
    """What is written about the lanes of a road, and whether they are the same everywhere."""
    plan = lane_plan(scenario.roads[name], scenario)
    return plan, is_fixed(plan, scenario)


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
