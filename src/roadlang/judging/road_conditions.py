"""Formulas over roads and numbers, for a batch of candidates."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate
from ..geometry.arrays import Booleans, Floats
from ..ir.batch import RoadBatch
from ..ir.values import Condition, Entity, PassCall
from ..stl.evaluate.measured_robustness import measured_rho, satisfied_by
from ..world.placement.copies import is_absent, most_copies
from ..world.roads.closed_road_faults import closed_road_fault
from ..world.signals import EvaluatedRoad, axes_of, signal


@dataclass(frozen=True)
class ConditionTrace:
    """What a formula is evaluated on: along one road, for one copy of the groups that it names.

    `road`: its name, `network/edge` of a network; `positions` (S,) meters; `values` of the
    variables; `wrap`: the length of a closed road; `absent` (V,): the candidates that do not have
    this copy, where some may not; `on_connection`: whether it is through a junction.
    """

    road: str
    positions: Floats
    values: dict[str, Any]
    wrap: float | None
    absent: Booleans | None
    on_connection: bool = False


def condition_rho(condition: Condition, candidates: CandidateBatch) -> Floats:
    """(V,) robustness of a formula over roads or numbers; of a network, on its worst road."""
    worst = np.full(1, np.inf)
    for trace in condition_traces(condition, candidates):
        rho = np.atleast_1d(
            measured_rho(
                condition.formula, trace.positions, trace.values, condition.evaluation, trace.wrap
            )
        )
        worst = np.minimum(
            worst, rho if trace.absent is None else np.where(trace.absent, np.inf, rho)
        )
    return np.broadcast_to(worst, (candidates.count,))


def condition_truth(condition: Condition, candidates: CandidateBatch) -> Booleans:
    """(V,) Boolean satisfaction of a formula; of a network, on all of its roads."""
    holds = np.ones(1, dtype=bool)
    for trace in condition_traces(condition, candidates):
        truth = np.atleast_1d(
            satisfied_by(
                condition.formula, trace.positions, trace.values, condition.evaluation, trace.wrap
            )
        )
        holds = holds & (truth if trace.absent is None else truth | trace.absent)
    return np.broadcast_to(holds, (candidates.count,))


def condition_traces(condition: Condition, candidates: CandidateBatch) -> Iterator[ConditionTrace]:
    """Each copy of the groups that a formula names, on each road of the networks that it names."""
    for copy in range(1, _copies(condition, candidates) + 1):
        yield from traces_of_copy(condition, copy, candidates)


def traces_of_copy(
    condition: Condition, copy: int, candidates: CandidateBatch
) -> Iterator[ConditionTrace]:
    """Each road of the networks that a formula names, for one copy (from 1) of its groups; nothing
    where no candidate has that copy, for which nothing is drawn then."""
    absent = is_absent(condition, copy, candidates)
    if absent is not None and absent.all():
        return
    for axis in (
        axes_of(condition, candidates) if condition.domain == "road" else (EvaluatedRoad(),)
    ):
        positions, values, wrap = _values(condition, axis, copy, candidates)
        fault = None if wrap is None else closed_road_fault(condition)
        if fault is not None:
            raise DiagnosticError(fault)
        name, on_connection = _road_name(condition, axis), axis.connection is not None
        yield ConditionTrace(name, positions, values, wrap, absent, on_connection)


def _road_name(condition: Condition, axis: EvaluatedRoad) -> str:
    """The first road that a signal of the formula names, or the part of a network."""
    for binding in condition.signals:
        for value in binding.call.options.values():
            if isinstance(value, Entity) and value.role == "road":
                return value.name
            if isinstance(value, Entity) and value.role == "network":
                return axis.name(value.name)
    return ""


def _values(
    condition: Condition, axis: EvaluatedRoad, copy: int, candidates: CandidateBatch
) -> tuple[Floats, dict[str, Any], float | None]:
    """Positions (S,), the values of all variables, and the length of a closed road."""
    values: dict[str, Any] = {}
    positions, wrap = np.zeros(1), None
    longest = 0
    for binding in condition.signals:
        values[binding.variable] = array = signal(binding.call, axis, candidates)
        road = _first_road(binding.call, axis, candidates)
        if road is not None and longest < len(road.stations) == array.shape[1]:
            positions, wrap, longest = road.stations, road.period, len(road.stations)
    for number in condition.numbers:
        value = evaluate(number.value, candidates, copy)
        values[number.variable] = value if isinstance(value, np.ndarray) else float(value)
    _check_shapes(condition, positions, values)
    return positions, values, wrap


def _first_road(
    call: PassCall, axis: EvaluatedRoad, candidates: CandidateBatch
) -> RoadBatch | None:
    """The first road that a signal names; None of a whole network, which has no axis."""
    for entity in candidates.scenario.dependencies.entities(call):
        if entity.role in ("road", "network"):
            road = axis.resolve(entity, candidates)
            return road if isinstance(road, RoadBatch) else None
    return None


def _check_shapes(condition: Condition, positions: Floats, values: dict[str, Any]) -> None:
    lengths = {v.shape[1] for v in values.values() if isinstance(v, np.ndarray) and v.ndim == 2}
    if len(lengths - {1, len(positions)}) > 0:
        spans = [binding.call.span for binding in condition.signals]
        raise DiagnosticError(
            diagnose(Code.ROADS_NOT_COMPARABLE, next(iter(spans), None), formula=condition.text)
        )


def _copies(condition: Condition, candidates: CandidateBatch) -> int:
    """How many copies the largest group has whose `start` the formula uses; 1 without any."""
    scenario = candidates.scenario
    actors = (
        scenario.actors[entity.name]
        for entity in scenario.dependencies.entities(condition)
        if _is_actor(entity) and not entity.copy
    )
    return max((most_copies(actor, candidates) for actor in actors), default=1)


def _is_actor(entity: Entity) -> bool:
    return entity.role in ("agent", "object")
