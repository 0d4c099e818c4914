"""What is recorded of all agents at one time, and columns of many such samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from .derived_columns import KEPT, DerivedColumns

RECORDED = (
    "x", "y", "heading", "speed", "steering", "station", "cross_track_error", "progress",
    "contacts", "route_progress", "red_light", "collision", "present", "along",
    "offset", "elevation",
)  # fmt: skip
"""Those of `COLUMNS` that change, but for the rate of another."""
PLACES = {name: place for place, name in enumerate(RECORDED)}
"""Where each of them is in an array of all."""
_KEPT_PLACES = {name: place for place, name in enumerate(KEPT)}


@dataclass(frozen=True)
class RecordedSample:
    """Of N agents at one time."""

    rows: Floats
    """(Q, N) the quantities `RECORDED`; (K, N) those that are `KEPT`, where others follow"""
    derived: DerivedColumns | None = None
    """what the others follow from"""

    def row(self, name: str) -> Floats:
        """(N,) one of the quantities in `rows`."""
        place = (PLACES if self.derived is None else _KEPT_PLACES)[name]
        found: Floats = self.rows[place]
        return found


def column_of(samples: Sequence[RecordedSample], name: str, agents: Any = slice(None)) -> Floats:
    """(T, R) one of the quantities `RECORDED`, of some agents at the times of samples."""
    if name in _KEPT_PLACES:
        return np.stack([sample.row(name)[agents] for sample in samples])
    parts = []
    for _, group in groupby(samples, key=lambda sample: id(sample.derived)):
        alike = list(group)
        derived = alike[0].derived
        if derived is None:
            parts.append(np.stack([sample.row(name)[agents] for sample in alike]))
        else:
            kept = partial(column_of, alike, agents=agents)
            parts.append(derived.take(agents).column(name, kept))
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def taken(samples: Sequence[RecordedSample], agents: Integers) -> list[RecordedSample]:
    """The samples of some agents."""
    derived = {id(one.derived): one.derived for one in samples if one.derived is not None}
    of_agents = {key: one.take(agents) for key, one in derived.items()}
    return [RecordedSample(one.rows[:, agents], of_agents.get(id(one.derived))) for one in samples]
