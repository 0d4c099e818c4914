"""One requirement: its robustness for a batch of candidates, and which of them satisfy it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from ..diagnostics import Span
from ..evaluate.candidates import CandidateBatch
from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.values import Condition, PassCall
from ..stl.evaluate.satisfaction import Rows, is_satisfied, zero_satisfies


@dataclass(frozen=True)
class Requirement:
    """Something that every scene satisfies: a `require`, or what is implied without one.

    `rho` gives robustness (V,); `truth` Boolean satisfaction (V,), None where a robustness of 0
    satisfies. `names`: the roads, networks and images that it depends on, `is_random`: whether a
    draw has a say in it, `cost`: an estimate of its work for one station. One that
    is `last` is judged of candidates that satisfy all others, and of no more than are wanted.
    `tries`: of one that there is room for an agent or object, at which try each copy was placed,
    (V, N). `blame`: what is in the way in the first candidate, which does not satisfy it, in words.
    """

    name: str
    text: str
    rho: Callable[[CandidateBatch], Floats]
    cost: float
    names: frozenset[str]
    is_random: bool
    truth: Callable[[CandidateBatch], Booleans] | None = None
    implied: bool = False
    test: Condition | PassCall | None = None
    span: Span | None = None
    last: bool = False
    tries: Callable[[CandidateBatch], Integers] | None = None
    blame: Callable[[CandidateBatch], str | None] | None = None

    @cached_property
    def line(self) -> int | None:
        """Line of the statement, from 1; None for one that no line states."""
        return self.span.line if self.span is not None else None

    def is_satisfied(self, candidates: CandidateBatch, rho: Floats) -> Booleans:
        """(V,) whether candidates of robustness `rho` (V,) satisfy the requirement."""
        truth = self.truth
        if truth is None:
            return is_satisfied(rho, zero_satisfies)

        def of_rows(rows: Rows) -> Booleans:
            return truth(candidates.take(rows))

        return is_satisfied(rho, of_rows)
