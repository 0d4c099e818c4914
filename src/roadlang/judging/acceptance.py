"""Which candidates satisfy every requirement, and what rejected the others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.values import Condition
from .early_verdicts import is_impossible, is_impossible_somewhere, settled_rows
from .requirement import Requirement
from .requirements import requirements_of
from .stated_ranges import check_stated_ranges

ACCEPTED = -1


@dataclass(frozen=True)
class AcceptanceResult:
    """`rejected_by` (V,): the index of the requirement, or `ACCEPTED`. `rho` (R, V): the robustness
    of each requirement, NaN where it was not needed. `settled` (R, V): bounds alone have shown that
    it holds. `tries`: by agent or object and row, (N,) at which try each copy was placed, of the
    candidates that it was placed in."""

    rejected_by: NDArray[np.int64]
    rho: Floats
    settled: Booleans
    tries: dict[str, dict[int, Integers]] = field(default_factory=dict)

    @property
    def accepted(self) -> Booleans:
        """Which candidates satisfy every requirement, (V,)."""
        return np.asarray(self.rejected_by == ACCEPTED)

    def tries_of(self, row: int) -> dict[str, Integers]:
        """(N,) by agent or object at which try each copy was placed in the candidate at `row`."""
        return {name: rows[row] for name, rows in self.tries.items() if row in rows}


@dataclass(frozen=True)
class Measurements:
    """`rho` (R, V): the robustness of every requirement; `satisfied` (R, V)."""

    rho: Floats
    satisfied: Booleans

    def take(self, rows: Integers) -> Measurements:
        """Those of some candidates."""
        return Measurements(self.rho[:, rows], self.satisfied[:, rows])


class Acceptance:
    """All requirements of a scenario, in the order in which they are tried."""

    def __init__(
        self, scenario: IndexedScenario, requirements: Sequence[Requirement] | None = None
    ) -> None:
        self.scenario = scenario
        self.requirements = requirements_of(scenario) if requirements is None else requirements

    def only(self, indices: Sequence[int]) -> Acceptance:
        """Some of the requirements."""
        return Acceptance(self.scenario, [self.requirements[index] for index in indices])

    @cached_property
    def has_varying_stations(self) -> bool:
        """Whether some requirement looks at roads that differ in their stations between candidates,
        which are then evaluated singly."""
        return any(self._is_varying(requirement) for requirement in self.requirements)

    def judge(
        self,
        candidates: CandidateBatch,
        scenes: NDArray[np.int64] | None = None,
        most: NDArray[np.int64] | None = None,
    ) -> AcceptanceResult:
        """Each requirement is tried on the survivors of those before it.

        With `scenes` (V,) the last requirements are tried on the survivors of each scene in order,
        only until one passes or as many as `most` (V,) of its scene have failed: those after it
        count as accepted.
        """
        count = candidates.count
        rho = np.full((len(self.requirements), count), np.nan)
        result = AcceptanceResult(np.full(count, ACCEPTED), rho, np.zeros(rho.shape, dtype=bool))
        indices = range(len(self.requirements))
        singly = [i for i in indices if self._is_varying(self.requirements[i])]
        together = [i for i in indices if i not in singly]
        last = [i for i in together if self.requirements[i].last and not singly]
        early = [i for i in together if i not in last]
        rows = self._sift(candidates, np.arange(count), early, result)
        if singly:
            for row in rows.tolist():
                self._sift(candidates.single(row), np.array([row]), singly, result)
        elif last and scenes is None:
            self._sift(candidates.take(rows), rows, last, result)
        elif last and scenes is not None:
            if most is not None:
                rows = rows[_rank_in_group(scenes[rows]) < most[rows]]
            self._sift_wanted(candidates, rows, scenes[rows], last, result)
        return result

    def rejected_last(self, result: AcceptanceResult) -> Booleans:
        """(V,) candidates that only one of the last requirements rejected."""
        last = np.array([requirement.last for requirement in self.requirements] + [False])
        return last[result.rejected_by]

    def _sift_wanted(
        self,
        candidates: CandidateBatch,
        rows: NDArray[np.intp],
        scenes: NDArray[np.int64],
        chosen: Sequence[int],
        result: AcceptanceResult,
    ) -> None:
        """Try the first survivor of each scene, then the second of those that it failed in."""
        while len(rows):
            _, first = np.unique(scenes, return_index=True)
            first = np.sort(first)
            passed = self._sift(candidates.take(rows[first]), rows[first], chosen, result)
            done = np.isin(scenes, scenes[np.isin(rows, passed)])
            done[first] = True
            rows, scenes = rows[~done], scenes[~done]

    def measure(self, candidates: CandidateBatch, *, last: bool = False) -> Measurements:
        """Every requirement, of rejected candidates too. The last ones count as satisfied: with
        `last` they are judged, of candidates that satisfy all others, which count so then."""
        shape = (len(self.requirements), candidates.count)
        rho, satisfied = np.zeros(shape), np.ones(shape, dtype=bool)
        start = 0
        for part in self.comparable(candidates):
            rows = slice(start, start + part.count)
            for index, requirement in enumerate(self.requirements):
                if requirement.last is last:
                    rho[index, rows] = found = requirement.rho(part)
                    satisfied[index, rows] = requirement.is_satisfied(part, found)
            start = rows.stop
        return Measurements(rho, satisfied)

    def impossible(self, candidates: CandidateBatch) -> frozenset[int]:
        """The requirements that no candidate can satisfy, as far as bounds tell.

        Raises RL474 where the values of `candidates` show that a bound, stated by a kind, is wrong.
        """
        scenario, requirements = self.scenario, self.requirements
        refuted = [i for i, found in enumerate(requirements) if is_impossible(found, scenario)]
        for part in self.comparable(candidates) if refuted else ():
            for index in refuted:
                requirements[index].rho(part)  # holds draws and displacements to their bounds
                test = requirements[index].test
                assert isinstance(test, Condition)
                check_stated_ranges(test, part)
        if refuted:
            return frozenset(refuted)
        few = self.comparable(candidates)[0]
        found = (is_impossible_somewhere(each, few) for each in requirements)
        return frozenset(index for index, refutes in enumerate(found) if refutes)

    def comparable(self, candidates: CandidateBatch) -> list[CandidateBatch]:
        """The candidates together, or one by one where they differ in their stations."""
        if not self.has_varying_stations:
            return [candidates]
        return [candidates.single(row) for row in range(candidates.count)]

    def _sift(
        self,
        candidates: CandidateBatch,
        rows: NDArray[np.intp],
        chosen: Sequence[int],
        result: AcceptanceResult,
    ) -> NDArray[np.intp]:
        """The rows that survive; `candidates` are the candidates at `rows`."""
        for index in chosen:
            if not len(rows):
                break
            requirement = self.requirements[index]
            passes = settled_rows(requirement, candidates)
            result.settled[index, rows] = passes
            if passes.all():
                continue
            open_rows = np.flatnonzero(~passes)
            unsettled = candidates if not passes.any() else candidates.take(open_rows)
            rho = requirement.rho(unsettled)
            result.rho[index, rows[open_rows]] = rho
            if requirement.tries is not None:
                found = zip(rows[open_rows].tolist(), requirement.tries(unsettled), strict=True)
                result.tries.setdefault(requirement.name, {}).update(found)
            passes = passes.copy()
            passes[open_rows] = requirement.is_satisfied(unsettled, rho)
            result.rejected_by[rows[~passes]] = index
            if not passes.all():
                rows = rows[passes]
                candidates = candidates.take(np.flatnonzero(passes))
        return rows

    def _is_varying(self, requirement: Requirement) -> bool:
        scenario = self.scenario
        geometric = (n for n in requirement.names if n in scenario.roads or n in scenario.networks)
        return any(scenario.is_varying(name) for name in geometric)


def _rank_in_group(groups: NDArray[np.int64]) -> NDArray[np.intp]:
    """(V,) how many before it are of the same group."""
    order = np.argsort(groups, kind="stable")
    _, first, sizes = np.unique(groups[order], return_index=True, return_counts=True)
    rank = np.empty(len(groups), np.intp)
    rank[order] = np.arange(len(groups)) - np.repeat(first, sizes)
    return rank
