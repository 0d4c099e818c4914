"""Arc lengths as the numbers of scenes."""

from __future__ import annotations

from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Floats
from ..ir.read_only import Floats as FloatNumbers


def station_numbers(stations: Floats, scenario: IndexedScenario) -> tuple[float, ...]:
    """(S,) as numbers: the same object for all that is at the same places."""
    key = ("station numbers", stations.tobytes())
    return scenario.once(key, lambda: FloatNumbers(stations.tolist()))
