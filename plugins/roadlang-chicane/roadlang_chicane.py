"""Chicanes and lateral acceleration: a roadlang plugin in one file."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from roadlang.api import (
    BatchRandom,
    Length,
    Perturber,
    RoadBatch,
    RoadOrNetwork,
    Signal,
    Speed,
    hookimpl,
    option,
)


@dataclass(frozen=True)
class Chicane(Perturber):
    """Swerve to one side and back past the center line to the other."""

    name: ClassVar[str] = "chicane"
    is_random: ClassVar[bool] = False
    offset: Length = option(help="greatest displacement, first to the left")
    at: Length = option(minimum=0, help="arc length at which the chicane begins")
    length: Length = option(60.0, above=0, help="length of the chicane")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> NDArray[np.float64]:
        """(variants, stations) meters, positive to the left."""
        share = np.clip((roads.stations - self.at) / self.length, 0, 1)
        swerve = np.sin(2 * np.pi * share) * np.sin(np.pi * share)
        return np.atleast_2d(self.offset * swerve / (4 / 27**0.5))  # divided by its maximum

    def displacement_bound(self) -> float:
        """Meters."""
        return abs(self.offset)

    def shortest_feature(self, length: float, closed: bool) -> float:
        """Meters: one swerve to one side and back."""
        return self.length / 2


@dataclass(frozen=True)
class LateralAcceleration(Signal):
    """Lateral acceleration of a car that drives along the road at a constant speed."""

    name: ClassVar[str] = "lateral_acceleration"
    unit: ClassVar[str] = "m/s^2"
    road: RoadOrNetwork = option(help="the road")
    speed: Speed = option(minimum=0, help="speed of the car")

    def values(self) -> NDArray[np.float64]:
        """(variants, stations) meters per second squared."""
        return np.asarray(self.speed**2 * np.abs(self.road.curvature))


@hookimpl
def roadlang_kinds() -> list[type]:
    """The kinds of this plugin."""
    return [Chicane, LateralAcceleration]
