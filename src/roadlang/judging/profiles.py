"""Signals and robustness along the roads of one candidate, as a scene holds them."""

from __future__ import annotations

import math

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..ir.scenario import NamedSignal
from ..ir.scene import Profile, RoadPlace, SceneSignal
from ..ir.values import Condition
from ..stl import Always, Eventually, Formula
from ..stl.evaluate.measured_robustness import measured_robustness
from .road_conditions import traces_of_copy


def scene_signals(candidates: CandidateBatch) -> tuple[SceneSignal, ...]:
    """Every `let` that names a signal over roads, with its values at the stations."""
    return tuple(_signal(signal, candidates) for signal in candidates.scenario.source.signals)


def robustness_profiles(condition: Condition, candidates: CandidateBatch) -> tuple[Profile, ...]:
    """The robustness of `p` along each road, of `always p` and `eventually p` over roads."""
    formula = condition.formula
    if condition.domain != "road" or not isinstance(formula, Always | Eventually):
        return ()
    return _profiles(condition, formula.operand, candidates)


def tightest(condition: Condition, profiles: tuple[Profile, ...]) -> RoadPlace | None:
    """Where the robustness is attained: the least of `always p`, the greatest of `eventually p`."""
    formula = condition.formula
    if not isinstance(formula, Always | Eventually):
        return None
    low, high = 0.0, math.inf
    if formula.interval is not None:
        low, high = formula.interval.lo, formula.interval.hi
    sign = 1.0 if isinstance(formula, Always) else -1.0
    places = [
        (sign * value, profile.road, station)
        for profile in profiles
        for station, value in zip(profile.stations, profile.values, strict=True)
        if low <= station - profile.stations[0] <= high
    ]
    if not places:
        return None
    _, road, station = min(places, key=lambda place: place[0])
    return RoadPlace(road, station)


def _signal(signal: NamedSignal, candidates: CandidateBatch) -> SceneSignal:
    condition = signal.condition
    profiles = _profiles(condition, condition.formula, candidates, with_connections=False)
    return SceneSignal(signal.name, condition.text, signal.dimension.unit, profiles)


def _profiles(
    condition: Condition,
    formula: Formula,
    candidates: CandidateBatch,
    *,
    with_connections: bool = True,
) -> tuple[Profile, ...]:
    found = []
    for trace in traces_of_copy(condition, 1, candidates):
        if trace.on_connection and not with_connections:
            continue
        if trace.absent is not None and trace.absent[0]:  # a group without any copy
            continue
        along = measured_robustness(
            formula, trace.positions, trace.values, condition.evaluation, trace.wrap
        )
        along = np.broadcast_to(np.atleast_2d(along)[0], trace.positions.shape)
        # Windows beyond the end of a road hold no sample: their robustness is infinite.
        inside = np.isfinite(along)
        stations, values = trace.positions[inside].tolist(), along[inside].tolist()
        found.append(Profile(trace.road, tuple(stations), tuple(values)))
    return tuple(found)
