"""What sensors that are computed get to measure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..geometry.arrays import Floats
    from .batch import BatchRandom
    from .control import ObservationBatch

CastRays = Callable[["ArrayLike", "ArrayLike", "ArrayLike", "ArrayLike"], "Floats"]


@dataclass(frozen=True, slots=True)
class SensedBatch:
    """N agents at the moment of a measurement, exactly as they are. Columns are (N,)."""

    seen: ObservationBatch
    """the agents; nothing in it is noisy or late"""
    interval: Floats
    """seconds since the measurement before, 0 at the first"""
    random: BatchRandom
    """random numbers for each agent, others in each measurement: a function of the seed, the scene,
    the agent, the sensor and the number of the measurement"""
    cast_rays: CastRays
    """`cast_rays(at, angles, elevations, range)`: (N, R) meters along rays to the first agent or
    object, or the ground; infinite beyond `range`, (N,) or a number. `at`: (3,) or (N, 3) meters
    ahead of the center, to the left of it, and above the ground. `angles`: (R,) or (N, R) to the
    left of the heading; `elevations` likewise, upward"""
