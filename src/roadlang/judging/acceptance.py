"""Judges batches of candidates: which satisfy every requirement, and what rejected the others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import Condition
from .bounds import settled_rows
from .requirements import Requirement, requirements_of
from .verdicts import holds_at_zero

Floats = NDArray[np.float64]
ACCEPTED = -1


@dataclass(frozen=True)
class Judged:
    """`rejected_by` (V,): the index of the requirement, or `ACCEPTED`. `rho` (R, V): the robustness
    of each requirement, NaN where it was not needed."""

    rejected_by: NDArray[np.int64]
    rho: Floats

    @property
    def accepted(self) -> NDArray[np.bool_]:
        """Which candidates satisfy every requirement, (V,)."""
        return np.asarray(self.rejected_by == ACCEPTED)


class Judge:
    """All requirements of a scenario, in the order in which they are tried."""

    def __init__(
        self, scenario: IndexedScenario, requirements: Sequence[Requirement] | None = None
    ) -> None:
        self.scenario = scenario
        self.requirements = requirements_of(scenario) if requirements is None else requirements

    def only(self, indices: Sequence[int]) -> Judge:
        """A judge of some of the requirements."""
        return Judge(self.scenario, [self.requirements[index] for index in indices])

    @cached_property
    def one_by_one(self) -> bool:
        """Whether some requirement looks at roads that differ in their stations."""
        return any(self._is_varying(requirement) for requirement in self.requirements)

    def judge(self, candidates: CandidateBatch) -> Judged:
        """Each requirement is tried on the survivors of those before it."""
        count = candidates.count
        judged = Judged(np.full(count, ACCEPTED), np.full((len(self.requirements), count), np.nan))
        together = [i for i, r in enumerate(self.requirements) if not self._is_varying(r)]
        alone = [i for i, r in enumerate(self.requirements) if self._is_varying(r)]
        rows = self._sift(candidates, np.arange(count), together, judged)
        if alone:
            for row in rows:
                one = np.array([row])
                self._sift(candidates.take(one), one, alone, judged)
        return judged

    def measure(self, candidates: CandidateBatch) -> Floats:
        """(R, V) the robustness of every requirement, of rejected candidates too."""
        everything = range(len(self.requirements))
        rho = np.empty((len(self.requirements), candidates.count))
        parts = (
            [candidates.take(np.array([row])) for row in range(candidates.count)]
            if self.one_by_one
            else [candidates]
        )
        start = 0
        for part in parts:
            for index in everything:
                rho[index, start : start + part.count] = self.requirements[index].rho(part)
            start += part.count
        return rho

    def _sift(
        self,
        candidates: CandidateBatch,
        rows: NDArray[np.intp],
        chosen: Sequence[int],
        judged: Judged,
    ) -> NDArray[np.intp]:
        """The rows that survive; `candidates` are the candidates at `rows`."""
        for index in chosen:
            if not len(rows):
                break
            requirement = self.requirements[index]
            certain = settled_rows(requirement, candidates)
            if certain.all():
                continue
            doubtful = (
                candidates if not certain.any() else candidates.take(np.flatnonzero(~certain))
            )
            rho = np.full(len(rows), np.nan)
            rho[~certain] = requirement.rho(doubtful)
            judged.rho[index, rows] = rho
            passes = certain | (rho > 0.0) | self._holds_at_zero(requirement, candidates, rho)
            judged.rejected_by[rows[~passes]] = index
            if not passes.all():
                rows = rows[passes]
                candidates = candidates.take(np.flatnonzero(passes))
        return rows

    def _holds_at_zero(
        self, requirement: Requirement, candidates: CandidateBatch, rho: Floats
    ) -> NDArray[np.bool_]:
        zero = np.asarray(rho == 0.0)
        if not zero.any() or not isinstance(requirement.test, Condition):
            return zero
        for row in np.flatnonzero(zero):
            zero[row] = holds_at_zero(requirement.test, candidates.take(np.array([row])))
        return zero

    def _is_varying(self, requirement: Requirement) -> bool:
        scenario = self.scenario
        geometric = (n for n in requirement.names if n in scenario.roads or n in scenario.networks)
        return any(scenario.is_varying(name) for name in geometric)
