"""`perturb with nudges`: a road that was moved by hand at some places."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Length, ListOf, OptionError, Perturber, Point, option

if TYPE_CHECKING:
    from roadlang.api import BatchRandom, RoadBatch
    from roadlang.geometry import Floats


def share_of_move(stations: Floats, place: Any, length: Any, period: float | None) -> Floats:
    """(1 - x^2)^3 for x in [-1, 1]: how much of the move of a place the road takes part in at its
    stations, 1 at the place. `length`: from end to end; `period`: once round a closed road."""
    import numpy as np

    away = stations - place
    if period is not None:
        away = np.mod(away + period / 2, period) - period / 2
    x = np.clip(2.0 * away / length, -1.0, 1.0)
    return np.asarray((1.0 - x * x) ** 3)


@dataclass(frozen=True)
class Nudges(Perturber):
    """Move places of the road together with the road around them; `watch` writes it after drags."""

    name: ClassVar[str] = "nudges"
    is_random: ClassVar[bool] = False
    at: ListOf[Length] = option(at_least=1, help="arc lengths of the places that are moved")
    by: ListOf[Point] = option(
        at_least=1, help="how far each is moved, east and north", example="[(2m, -1m)]"
    )
    length: Length = option(
        80.0, above=0, help="arc length of the stretch of road that moves with each place"
    )

    def __post_init__(self) -> None:
        """Raises RL480 where places and moves do not belong together."""
        if len(self.at) != len(self.by):
            raise OptionError("by", f"has {len(self.by)} moves, but `at` has {len(self.at)} places")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """The sum of by * (1 - x^2)^3 for x in [-1, 1] around each place."""
        import numpy as np

        total = np.zeros((1, len(roads.stations), 2))
        for place, move in zip(self.at, self.by, strict=True):
            share = np.atleast_2d(
                share_of_move(roads.stations, np.asarray(place), self.length, roads.period)
            )
            east, north = (np.atleast_2d(number) for number in move)
            total = total + np.stack([east * share, north * share], axis=-1)
        return total

    def shortest_feature(self, length: float, closed: bool) -> Floats | float:
        """What moves with one place."""
        return self.length
