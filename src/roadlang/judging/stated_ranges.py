"""Holds kinds to the ranges that they state: requirements are decided by them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..ir.values import Condition, Measure, PassCall
from ..plugins.guard import wrong_result
from ..stl.evaluate.interval_arithmetic import UNKNOWN
from .road_conditions import condition_traces
from .variable_bounds import CandidateBounds


def check_stated_ranges(condition: Condition, candidates: CandidateBatch) -> None:
    """Raises RL474 where a signal or number of a road is beyond the range that its kind states."""
    bounds = CandidateBounds(candidates)
    ranges = {variable: (call, bounds.signal(call)) for variable, call in _calls(condition)}
    stated = {variable: item for variable, item in ranges.items() if item[1] is not UNKNOWN}
    if not stated:
        return
    for trace in condition_traces(condition, candidates):
        for variable, (call, (low, high)) in stated.items():
            values = np.atleast_2d(trace.values[variable])
            beyond = (values < np.reshape(low, (-1, 1))) | (values > np.reshape(high, (-1, 1)))
            if beyond.any():
                row = int(np.flatnonzero(beyond.any(axis=1))[0])
                value = values[row % len(values)][beyond[row]][0]
                least, greatest = (np.ravel(end)[row % np.size(end)] for end in (low, high))
                fault = f"gave {value:g}, which is beyond its range, {least:g} to {greatest:g}"
                raise wrong_result(candidates.scenario.kind(call)[0], call.span, fault)


def _calls(condition: Condition) -> Iterator[tuple[str, PassCall]]:
    for binding in condition.signals:
        yield binding.variable, binding.call
    for number in condition.numbers:
        if isinstance(number.value, Measure):
            yield number.variable, number.value.call
