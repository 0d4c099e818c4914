"""Kinds that search for scenes that violate an expectation, in ask-and-tell form."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from ...geometry.arrays import Floats

ROAD_PLACES = 64
"""Equal parts of a road at whose ends descriptors have its curvature: their first numbers."""


@dataclass(frozen=True)
class Axis:
    """One random number of the scenario: a coordinate of the unit cube that is searched.

    `ends` is None for a continuous value; for a countable one it is the upper end of the part of
    [0, 1] that gives each value, ascending to 1.
    """

    name: str
    """where in the scenario it is drawn: `bent/perturb 1/amplitude`"""
    ends: tuple[float, ...] | None = None
    is_ordered: bool = True
    """for countable values: whether neighbors are more alike than others"""
    simplest: float = 0.5
    """coordinate of the simplest value"""

    def middles(self) -> tuple[float, ...]:
        """A coordinate for each value of a countable axis; none for a continuous one."""
        ends = (0.0, *(self.ends or ()))
        pairs = pairwise(ends)
        return tuple((low + high) / 2 for low, high in pairs if high > low)

    def levels(self, steps: int) -> tuple[float, ...]:
        """The coordinates that a grid visits: each value once, or the middles of `steps` parts."""
        if self.ends is not None:
            return self.middles()
        return tuple((step + 0.5) / steps for step in range(steps))


class Search:
    """A search in progress: `ask` gives points to evaluate, `tell` takes their results."""

    def screen_with(self, screen: Callable[[Floats], Floats]) -> None:
        """Take a function that judges points by the requirements, called once, before the first
        `ask`.

        `screen` takes points (n, axes) and gives (n,) values: 0 where all requirements hold; where
        one is violated, the value from 1 on that `tell` would have. What is screened is not driven
        and not counted as an evaluation. By default a search makes no use of it.
        """

    def batch_size(self, most: int) -> int:
        """How many points the next `ask` should be for, from 1 to `most`, by default as many.

        Large batches are evaluated faster, but a search learns more often from small ones.
        """
        return most

    def ask(self, count: int) -> Floats:
        """The next points, (count, axes) numbers in [0, 1).

        Fewer than `count` only at the end of the search, which is then over.
        """
        raise NotImplementedError

    def tell(self, points: Floats, values: Floats, descriptors: Floats) -> None:
        """Take the results of the points that `ask` gave last.

        `values` (count,): below 0 an expectation is violated, the lower the worse; from 0 to 1 all
        hold, with the less robustness the lower; from 1 a requirement is violated and the scene was
        not driven. `descriptors` (count, k) say what a drive was like: two failures whose
        descriptors are further apart than 1 count as distinct; NaN for what was not driven.
        Their first `ROAD_PLACES` numbers are the curvature, at places that are equally far apart,
        of the road of the agent that the expectations are about, to a factor.
        """


class Searcher(Kind):
    """`falsify with`: how scenes that violate an `expect` are searched for."""

    verb: ClassVar[str] = "falsify"
    required_methods: ClassVar[tuple[str, ...]] = ("start",)
    is_adaptive: ClassVar[bool] = True
    """whether it uses results; only adaptive searchers run as several searches in parallel, because
    others would all ask for the same points"""
    is_random: ClassVar[bool] = False
    """whether its points are independent random draws, from which the failure rate is estimated"""

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        """A new search in the unit cube of `axes`; the same axes and seed, the same search."""
        raise NotImplementedError
