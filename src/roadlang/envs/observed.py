"""What environments observe: vectors of numbers, and the readings of sensors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from gymnasium.spaces import Box, Dict, Space

from ..plugins.kinds import ReadingArray
from ..simulation.observing.observation_vector import ObservationVector

Observed = Any
"""(N, F) float32; where the agent has sensors, `{"state": ..., "sensors": {NAME: {ARRAY: ...}}}` of
arrays with a leading axis N."""
Arrays = Mapping[str, Mapping[str, ReadingArray]]
"""By the names of the sensors."""


def observation_space(vector: ObservationVector, sensors: Arrays) -> Space[Observed]:
    """The space of what one agent observes: a Box, or a Dict where it has sensors."""
    state = Box(vector.low, vector.high, vector.low.shape, np.float32)
    if not sensors:
        return state
    readings: dict[str, Space[Any]] = {
        name: Dict({part: _box(array) for part, array in arrays.items()})
        for name, arrays in sensors.items()
    }
    return Dict({"state": state, "sensors": Dict(readings)})


def _box(array: ReadingArray) -> Box:
    dtype = np.dtype(array.dtype)
    if dtype.kind in "iu":
        info = np.iinfo(dtype)
        return Box(max(array.low, info.min), min(array.high, info.max), array.shape, dtype.type)
    return Box(array.low, array.high, array.shape, dtype.type)


def row_of(observed: Observed, row: int) -> Observed:
    """What one of N agents observes."""
    if isinstance(observed, dict):
        return {name: row_of(part, row) for name, part in observed.items()}
    return np.asarray(observed[row])


def joined(observed: Sequence[Observed]) -> Observed:
    """What several batches of agents observe, one after the other."""
    if isinstance(observed[0], dict):
        return {name: joined([each[name] for each in observed]) for name in observed[0]}
    return np.concatenate(observed)
