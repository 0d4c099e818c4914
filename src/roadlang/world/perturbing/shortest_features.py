"""The shortest wave or bump of a `perturb` pass: how closely its road must be sampled."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry.arrays import Floats, flat
from ...ir.values import PassCall
from ...plugins.guard import plugin_guard, wrong_result
from ...plugins.kinds import implements
from ...plugins.registry import KindEntry
from ...plugins.stated_bounds import OptionRange, corners


def states_feature(call: PassCall, scenario: IndexedScenario) -> bool:
    """Whether the kind of a pass says how short its waves and bumps are."""
    return implements(scenario.kind(call)[1], "shortest_feature")


def shortest_feature(
    call: PassCall, scenario: IndexedScenario, length: float, closed: bool
) -> float | None:
    """Meters along a road of `length` meters, whatever is drawn; None where that is not known.

    That of the kind and that of the interval (`over`, `taper`). Raises RL474 for what is not a
    length.
    """
    parts = [_of_kind(call, scenario, length, closed), _of_interval(call, scenario, length, closed)]
    if None in parts:
        return None
    return min(part for part in parts if part is not None)


def features_of_candidates(
    call: PassCall, candidates: CandidateBatch, element: int, length: float, closed: bool
) -> Floats:
    """(V,) or (1,) meters: the same for candidates whose draws are known."""
    built = build(call, candidates, element)
    with built.guarded:
        stated = built.kind.shortest_feature(length, closed)
    lengths = _checked(stated, built.entry, call)
    if len(lengths) not in (1, candidates.count):
        fault = f"gave {len(lengths)} shortest features for {candidates.count} candidates"
        raise wrong_result(built.entry, call.span, fault)
    parts = [lengths]
    options = call.common
    if "over" in options:
        low, high = (flat(end) for end in evaluate(options["over"], candidates, element))
        taper = np.zeros(1)
        if "taper" in options:
            taper = flat(evaluate(options["taper"], candidates, element))
        parts.append(_feature_of_window(_size(low, high, length, closed), taper))
    return np.asarray(np.minimum.reduce(np.broadcast_arrays(*parts)))


def _of_kind(
    call: PassCall, scenario: IndexedScenario, length: float, closed: bool
) -> float | None:
    entry, kind = scenario.kind(call)
    if not implements(kind, "shortest_feature"):
        return math.inf
    combinations = corners(kind, scenario.value_bounds.options(call))
    if combinations is None:
        return None
    found = [math.inf]
    for fields in combinations:
        with plugin_guard(entry, call.span):
            instance: Any = kind(**fields)
            stated = instance.shortest_feature(length, closed)
        found.append(float(_checked(stated, entry, call).min()))
    return _known(min(found))


def _of_interval(
    call: PassCall, scenario: IndexedScenario, length: float, closed: bool
) -> float | None:
    options = call.common
    if "over" not in options:
        return math.inf
    ends = scenario.value_bounds.option(options["over"])
    taper = scenario.value_bounds.option(options["taper"]) if "taper" in options else None
    if not (isinstance(ends, tuple) and len(ends) == 2 and all(map(_is_range, ends))):
        return None
    low, high = ends
    if low.low != low.high or high.low != high.high:
        # Ends that are drawn may depend on each other: their distance is not that of their ranges.
        return None
    size = _size(np.asarray(low.low), np.asarray(high.low), length, closed)
    shortest_taper = 0.0 if taper is None else taper.low
    return _known(float(_feature_of_window(size, np.asarray(shortest_taper))))


def _size(low: Floats, high: Floats, length: float, closed: bool) -> Floats:
    """Meters of an interval, round the start of a closed road where it ends before it begins; where
    it has none, RL414 says so."""
    size = np.where(high < low, high + length - low, high - low) if closed else high - low
    return np.where(size > 0.0, size, math.inf)


def _feature_of_window(size: Floats, taper: Floats) -> Floats:
    """A taper is half a wave; without one the window has edges, which no stations show."""
    taper = np.minimum(taper, size / 2.0)
    return np.minimum(size, np.where(taper > 0.0, 2.0 * taper, math.inf))


def _checked(stated: Any, entry: KindEntry, call: PassCall) -> Floats:
    with plugin_guard(entry, call.span):
        lengths = np.asarray(stated, dtype=np.float64).reshape(-1)
    if lengths.size == 0 or np.isnan(lengths).any():
        raise wrong_result(
            entry, call.span, f"gave a shortest feature that is not a length: {stated}"
        )
    return lengths


def _known(feature: float) -> float | None:
    """What may be zero or negative is no length: it is looked at for each candidate."""
    return feature if feature > 0.0 else None


def _is_range(value: Any) -> bool:
    return isinstance(value, OptionRange) and math.isfinite(value.low) and math.isfinite(value.high)
