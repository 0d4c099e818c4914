"""Cars on their way to a crossing: the same for every simulator."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from random import Random

YELLOW, ALL_RED = 3, 2
"""Seconds."""
CAR = 4.5
"""Meters."""
LEAST_GAP = 2.5
"""Meters between two in a lane at the start."""


@dataclass(frozen=True)
class Car:
    """A car that is `distance` meters from the stop line at the start."""

    distance: float
    turn: str
    """`left`, `straight` or `right`"""


@dataclass(frozen=True)
class Demand:
    """What comes to a crossing of four arms with signals."""

    flow: int
    """cars an hour on each arm"""
    lanes: int
    """of a road, both directions"""
    turns: float
    """share of cars that turn, half of them to the left"""
    green: int
    """seconds"""
    cycles: int = 3
    speed: float = 13.89
    """m/s, the limit"""
    seed: int = 1
    """of the times at which cars come, and of what is random about drivers"""

    @property
    def duration(self) -> float:
        """Seconds: of whole cycles."""
        return 2.0 * self.cycles * (self.green + YELLOW + ALL_RED)

    @property
    def longest(self) -> float:
        """Meters from which a car can come to the crossing in time."""
        return self.speed * self.duration + 50.0

    @cached_property
    def arms(self) -> tuple[tuple[Car, ...], ...]:
        """Of each of four arms, the nearest first: at random times, one behind another."""
        return tuple(tuple(self._cars(number)) for number in range(4))

    def _cars(self, number: int) -> list[Car]:
        draw = Random(f"arm {number} of {self}")
        apart = (CAR + LEAST_GAP) / (self.lanes / 2)
        found: list[Car] = []
        distance = 0.0
        while True:
            distance += max(apart, draw.expovariate(self.flow / 3600.0) * self.speed)
            if distance > self.speed * self.duration:
                return found
            turns = draw.random() < self.turns
            turn = draw.choice(("left", "right")) if turns else "straight"
            found.append(Car(distance, turn))
