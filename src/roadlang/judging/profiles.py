"""Signals and robustness along the roads of candidates, as scenes hold them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..geometry.arrays import Booleans, Floats
from ..ir.read_only import Floats as FloatNumbers
from ..ir.scenario import NamedSignal
from ..ir.scene import Profile, RoadPlace, SceneSignal, Verdict
from ..ir.values import Condition
from ..stl import Always, Eventually, Formula
from ..stl.evaluate.measured_robustness import measured_robustness
from ..world.station_numbers import station_numbers
from .road_conditions import traces_of_copy


def scene_signals(candidates: CandidateBatch) -> list[tuple[SceneSignal, ...]]:
    """Every `let` that names a signal over roads, with its values at the stations."""
    columns = [_signals(signal, candidates) for signal in candidates.scenario.source.signals]
    return list(zip(*columns, strict=True)) if columns else [()] * candidates.count


def with_profiles(
    condition: Condition, verdicts: list[Verdict], candidates: CandidateBatch
) -> list[Verdict]:
    """Verdicts of `always p` and `eventually p` over roads, with the robustness of `p` along each
    road, and where that of the formula is attained: the least of `always p`, the greatest of
    `eventually p`."""
    formula = condition.formula
    if condition.domain != "road" or not isinstance(formula, Always | Eventually):
        return verdicts
    traces = list(_traces(condition, formula.operand, candidates))
    places = _tightest(formula, traces, candidates.count)
    return [
        Verdict(found.name, found.text, found.domain, found.robustness, found.satisfied,
            found.violated, found.formula, profiles, place)
        for found, profiles, place in zip(
            verdicts, _profiles(traces, candidates), places, strict=True
        )
    ]  # fmt: skip


def _signals(signal: NamedSignal, candidates: CandidateBatch) -> list[SceneSignal]:
    condition = signal.condition
    traces = _traces(condition, condition.formula, candidates, with_connections=False)
    unit = signal.dimension.unit
    return [
        SceneSignal(signal.name, condition.text, unit, profiles)
        for profiles in _profiles(list(traces), candidates)
    ]


@dataclass(frozen=True)
class _Along:
    """What is plotted over the stations (S,) of a road: `values` (V, S), which are none where they
    are infinite, and in candidates that are `absent` (V,)."""

    road: str
    stations: Floats
    values: Floats
    absent: Booleans | None


def _traces(
    condition: Condition,
    formula: Formula,
    candidates: CandidateBatch,
    *,
    with_connections: bool = True,
) -> Iterator[_Along]:
    for trace in traces_of_copy(condition, 1, candidates):
        if trace.on_connection and not with_connections:
            continue
        along = measured_robustness(
            formula, trace.positions, trace.values, condition.evaluation, trace.wrap
        )
        shape = candidates.count, len(trace.positions)
        values = np.broadcast_to(np.atleast_2d(along), shape)
        yield _Along(trace.road, trace.positions, values, trace.absent)


def _profiles(traces: Sequence[_Along], candidates: CandidateBatch) -> list[tuple[Profile, ...]]:
    columns = [_of_road(trace, candidates) for trace in traces]
    return (
        [
            tuple(profile for profile in row if profile is not None)
            for row in zip(*columns, strict=True)
        ]
        if columns
        else [()] * candidates.count
    )


def _of_road(trace: _Along, candidates: CandidateBatch) -> list[Profile | None]:
    # Windows beyond the end of a road hold no sample: their robustness is infinite.
    inside = np.isfinite(trace.values)
    whole: list[bool] = np.all(inside, axis=1).tolist()
    stations = station_numbers(trace.stations, candidates.scenario)
    found: list[Profile | None] = []
    for row, values in enumerate(trace.values):
        if trace.absent is not None and trace.absent[row]:  # a group without any copy
            found.append(None)
        elif whole[row]:
            found.append(Profile(trace.road, stations, FloatNumbers(values.tolist())))
        else:
            shown = station_numbers(trace.stations[inside[row]], candidates.scenario)
            found.append(Profile(trace.road, shown, FloatNumbers(values[inside[row]].tolist())))
    return found


def _tightest(
    formula: Always | Eventually, traces: Sequence[_Along], count: int
) -> list[RoadPlace | None]:
    """Of each candidate, where its robustness is attained, among the samples that count."""
    low, high = 0.0, math.inf
    if formula.interval is not None:
        low, high = formula.interval.lo, formula.interval.hi
    sign = 1.0 if isinstance(formula, Always) else -1.0
    best = np.full(count, np.inf)
    found: list[RoadPlace | None] = [None] * count
    for trace in traces:
        inside = np.isfinite(trace.values)
        first = trace.stations[inside.argmax(axis=1)][:, None]
        counted = inside & (low <= trace.stations - first) & (trace.stations - first <= high)
        if trace.absent is not None:
            counted &= ~trace.absent[:, None]
        values = np.where(counted, sign * trace.values, np.inf)
        at = values.argmin(axis=1)
        least = values[np.arange(count), at]
        for row in np.flatnonzero(counted.any(axis=1) & (least < best)).tolist():
            found[row] = RoadPlace(trace.road, float(trace.stations[at[row]]))
        best = np.minimum(best, least)
    return found
