"""Signals and robustness along the roads of one candidate, as a scene holds them."""

from __future__ import annotations

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..ir.scenario import NamedSignal
from ..ir.scene import Profile, SceneSignal
from ..ir.values import Condition
from ..stl import Always, Formula
from ..world.signals import axes_of
from .requirements import axis_signals
from .verdicts import road_name


def scene_signals(candidates: CandidateBatch) -> tuple[SceneSignal, ...]:
    """Every `let` that names a signal over roads, with its values at the stations."""
    return tuple(_signal(signal, candidates) for signal in candidates.scenario.source.signals)


def robustness_profiles(condition: Condition, candidates: CandidateBatch) -> tuple[Profile, ...]:
    """The robustness along each road of what an outermost `always` governs; of another formula,
    its own robustness from each station on. Empty for a formula that is not over roads."""
    if condition.domain != "road":
        return ()
    formula = condition.formula
    return _profiles(
        condition, formula.operand if isinstance(formula, Always) else formula, candidates
    )


def _signal(signal: NamedSignal, candidates: CandidateBatch) -> SceneSignal:
    condition = signal.condition
    profiles = _profiles(condition, condition.formula, candidates)
    return SceneSignal(signal.name, condition.text, signal.dimension.unit, profiles)


def _profiles(
    condition: Condition, formula: Formula, candidates: CandidateBatch
) -> tuple[Profile, ...]:
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
