"""What a search for failures does: its searcher, its stop rules, how it is divided."""

from __future__ import annotations

from dataclasses import dataclass

from ..diagnostics import Span
from ..plugins.kinds import Searcher
from ..plugins.registry import KindEntry


@dataclass(frozen=True)
class Plan:
    """The search ends with whichever of `evaluations`, distinct `failures` and `seconds` comes
    first. What is evaluated depends on all of this, and on nothing else."""

    searcher: Searcher
    entry: KindEntry
    seed: int
    evaluations: int
    failures: int | None = None
    seconds: float | None = None
    batch: int = 500
    islands: int = 1
    random: float = 0.05
    """share of the candidates that are drawn at random"""
    after_violation: float = 2.0
    """seconds that a drive goes on after all that is expected of it is violated"""
    span: Span | None = None
    """where the searcher is written"""

    def __post_init__(self) -> None:
        if not self.searcher.is_adaptive:
            object.__setattr__(self, "islands", 1)
        if self.searcher.is_random:
            object.__setattr__(self, "random", 0.0)

    def is_random(self, index: int) -> bool:
        """Whether evaluation `index` belongs to the share that is drawn at random."""
        return int((index + 1) * self.random) > int(index * self.random)
