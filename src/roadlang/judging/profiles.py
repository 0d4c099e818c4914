"""Signals and robustness along the roads of one candidate, as a scene holds them."""

from __future__ import annotations

import math

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..ir.scenario import NamedSignal
from ..ir.scene import Profile, RoadPlace, SceneSignal
from ..ir.values import Condition
from ..stl import Always, Eventually, Formula
from ..world.placement import is_absent
from ..world.signals import axes_of
from .requirements import axis_signals
from .verdicts import road_name


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
    profiles = _profiles(condition, condition.formula, candidates)
    return SceneSignal(signal.name, condition.text, signal.dimension.unit, profiles)


def _profiles(
    condition: Condition, formula: Formula, candidates: CandidateBatch
) -> tuple[Profile, ...]:
    absent = is_absent(condition, 1, candidates)
    if absent is not None and absent[0]:  # a group without any copy
        return ()
    found = []
    for axis in axes_of(condition, candidates):
        positions, values, wrap = axis_signals(condition, axis, 1, candidates)
        along = np.atleast_2d(formula.robustness(positions, values, wrap=wrap))[0]
        along = np.broadcast_to(along, positions.shape)
        # Windows beyond the end of a road hold no sample: their robustness is infinite.
        inside = np.isfinite(along)
        name = road_name(condition, axis, candidates)
        found.append(
            Profile(name, tuple(positions[inside].tolist()), tuple(along[inside].tolist()))
        )
    return tuple(found)
