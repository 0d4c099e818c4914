"""What a folder of results holds, whichever command wrote it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from ..falsification.statistics import Coverage, FailureRate
from ..ir.results_record import ResultsRecord
from ..ir.scene import Scene, Verdict
from ..ir.trace import Trace


@dataclass(frozen=True)
class ShownDrive:
    """A drive that the page shows in full. `name` is that of its files, `failures/0001`."""

    name: str
    label: str
    row: int
    """the `number` of its row"""
    scene: Scene
    trace: Trace
    """with the objects of the scene"""
    verdicts: tuple[Verdict, ...]
    has_failed: bool
    """whether an expectation is violated"""
    expects: tuple[str, ...] = ()
    """what the search was for that drove it, the most important first; empty where none did"""
    shrunk: Mapping[str, Any] | None = None
    """the simplest scene that still fails, where `roadlang shrink` made it"""
    explanation: Mapping[str, Any] | None = None
    """what `roadlang explain` found"""


@dataclass(frozen=True)
class ResultRow:
    """A scene that was driven. `values`: its row in the tables, `robustness` by expectation."""

    number: int
    has_failed: bool
    values: Mapping[str, Any]
    robustness: Mapping[str, float | None]
    draws: tuple[str, ...] = ()
    """the columns of `values` that are params and draws"""


@dataclass(frozen=True)
class Results:
    """All that a page is made of. SI units and radians."""

    record: ResultsRecord
    expects: tuple[str, ...]
    rows: Sequence[ResultRow]
    """in the order in which they were driven"""
    drives: Sequence[ShownDrive]
    """the failing ones first, the worst before the others"""
    coverage: Mapping[str, Coverage]
    rate: FailureRate | None = None
    """among scenes drawn at random; None where they were not"""
    evaluations: int | None = None
    """of a search: all candidates, also those that were not driven"""
    distinct: int | None = None
    """of a search: failures that differ from one another"""
    best: Mapping[str, Sequence[tuple[int, float]]] = field(default_factory=dict)
    """of each expectation: when its robustness came lower than before"""
    more_failing: int = 0
    """failing drives that are not shown, as there are too many"""

    @property
    def failing(self) -> int:
        """How many drives violate an expectation."""
        return sum(row.has_failed for row in self.rows)
