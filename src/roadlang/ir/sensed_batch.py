"""What sensors that are computed get to measure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ..geometry.arrays import Booleans, Floats
    from .batch import BatchRandom
    from .observation import ObservationBatch

CastRays = Callable[["ArrayLike", "ArrayLike", "ArrayLike", "ArrayLike"], "Floats"]


@dataclass(frozen=True, slots=True)
class SolidThings:
    """The other agents and the objects of N scenes, as upright boxes on the ground: columns
    (N, K), meters and radians in the world. Agents come before objects."""

    there: Booleans
    """False where there is none"""
    category: NDArray[np.object_]
    """`car`, `tree`, ...; `""` where there is none"""
    x: Floats
    """of the center"""
    y: Floats
    heading: Floats
    length: Floats
    width: Floats
    height: Floats


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
    things: Callable[[], SolidThings]
    """`things()`: what else is in the scenes of the agents"""
