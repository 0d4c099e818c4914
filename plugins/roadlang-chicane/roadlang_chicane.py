"""Chicanes and lateral acceleration: a roadlang plugin of one file."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from roadlang.api import Length, Perturber, RoadOrNetwork, Signal, Speed, hookimpl, option


@dataclass(frozen=True)
class Chicane(Perturber):
    """Swerve to one side and back over the other."""

    name: ClassVar[str] = "chicane"
    offset: Length = option(help="greatest displacement, first to the left")
    at: Length = option(minimum=0, help="arc length where the chicane begins")
    length: Length = option(60.0, above=0, help="arc length that it takes")

    def displacements(self, roads, random):
        """(variants, stations) meters, left positive."""
        share = np.clip((roads.stations - self.at) / self.length, 0, 1)
        swerve = np.sin(2 * np.pi * share) * np.sin(np.pi * share)
        return self.offset * swerve / (4 / 27**0.5)  # the swerve's own maximum


@dataclass(frozen=True)
class LateralAcceleration(Signal):
    """Sideways acceleration of a car that takes the road at a constant speed."""

    name: ClassVar[str] = "lateral_acceleration"
    unit: ClassVar[str] = "m/s^2"
    road: RoadOrNetwork = option(help="the road")
    speed: Speed = option(minimum=0, help="of the car")

    def values(self):
        """(variants, stations) meters per second squared."""
        return self.speed**2 * np.abs(self.road.curvature)


@hookimpl
def roadlang_kinds():
    """What this plugin brings."""
    return [Chicane, LateralAcceleration]
