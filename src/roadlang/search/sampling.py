"""Scenes of a scenario: candidates are drawn and judged until each scene has one that passes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import Scenario
from ..ir.scene import Scene
from ..ir.values import PassCall
from ..judging.acceptance import Judge
from ..judging.bounds import is_impossible
from ..plugins.registry import Registry
from .rejection_report import RejectionStats, Row, as_text, rows_of

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class SamplingResult:
    """`scenes` in order of their index; `missing` are those given up after too many attempts.

    `impossible`: no draw can satisfy some requirement; otherwise a missing scene was unlucky.
    """

    scenes: tuple[Scene, ...]
    wanted: int
    candidates: int
    table: tuple[Row, ...]
    missing: tuple[int, ...] = ()
    impossible: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    diversity: float | None = None
    """mean distance of each accepted draw to the nearest other, in the unit cube of the draws"""

    @property
    def accepted(self) -> int:
        """Number of accepted scenes."""
        return len(self.scenes)

    @property
    def table_text(self) -> str:
        """The table of requirements as text."""
        return as_text(self.table, self.candidates)


def sample_scenes(
    source: Scenario,
    registry: Registry,
    n: int | None = None,
    seed: int = 0,
    jobs: int = 1,
    progress: Progress | None = None,
    overrides: dict[str, str] | None = None,
) -> SamplingResult:
    """The first `n` scenes (all of a grid, one of anything else, where `n` is None).

    Neither `n` nor `jobs` changes a scene. Raises DiagnosticError for what is wrong with the
    inputs or a plugin; that nothing was accepted is no error, but told by the result.
    """
    from .searching import search
    from .workers import WorkerPool

    scenario = IndexedScenario(source, registry)
    judge = Judge(scenario)
    impossible = _impossible(judge, seed)
    if impossible:
        return _nothing(judge, impossible, n or 1)
    with WorkerPool(scenario, seed, jobs, overrides or {}) as pool:
        found = search(judge, seed, n, pool, progress)
    names = frozenset(found.impossible)
    return SamplingResult(
        scenes=tuple(found.scenes),
        wanted=found.wanted,
        candidates=found.stats.candidates,
        table=rows_of(found.stats, judge.requirements, names),
        missing=tuple(found.missing),
        impossible=tuple(judge.requirements[index].text for index in sorted(names)),
        remarks=remarks_of(scenario),
        diversity=found.diversity,
    )


def remarks_of(scenario: IndexedScenario) -> tuple[str, ...]:
    """What extractors had to say of the pictures."""
    roots: list[Any] = [value for key, value in scenario.kept("network root")]
    return tuple(dict.fromkeys(remark for root in roots for remark in root.remarks))


def sampler_call(scenario: IndexedScenario) -> PassCall:
    """The `sample with` of the file, or `random`."""
    return scenario.source.sample or PassCall("sample", "standard.random", (), "sample")


def _impossible(judge: Judge, seed: int) -> frozenset[int]:
    """Requirements that bounds refute, or that nothing random has a say in and that fail."""
    from ..evaluate.candidates import CandidateBatch

    refuted = {
        index
        for index, requirement in enumerate(judge.requirements)
        if is_impossible(requirement, judge.scenario)
    }
    if refuted:
        return frozenset(refuted)
    first = CandidateBatch(judge.scenario, seed, np.zeros(1, np.int64), np.zeros(1, np.int64))
    fixed = [index for index, r in enumerate(judge.requirements) if not r.draws]
    if not fixed:
        return frozenset()
    judged = judge.only(fixed).judge(first)
    return frozenset(fixed[index] for index in set(judged.rejected_by.tolist()) if index >= 0)


def _nothing(judge: Judge, impossible: frozenset[int], wanted: int) -> SamplingResult:
    rows = rows_of(RejectionStats.empty(len(judge.requirements)), judge.requirements, impossible)
    known = {row.name for row in rows}
    for index in sorted(impossible):
        requirement = judge.requirements[index]
        if requirement.name not in known:
            rows += (
                Row(requirement.name, requirement.text, requirement.line, 1, 1, 1.0, None,
                    requirement.implied, True),
            )  # fmt: skip
    texts = tuple(judge.requirements[index].text for index in sorted(impossible))
    return SamplingResult((), wanted, 0, rows, (0,), texts)
