"""Scenes of a scenario: candidates are drawn and judged until each scene has one that passes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import nullcontext, suppress
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ..diagnostics import Diagnostic, DiagnosticError, Span
from ..evaluate.candidates import CandidateBatch
from ..evaluate.draw_record import DrawRecord
from ..ir.scenario import Scenario
from ..ir.scene import Scene
from ..ir.values import PassCall
from ..judging.acceptance import Acceptance
from ..judging.early_verdicts import reasons
from ..judging.impossible import FIRST, impossible_requirements
from ..judging.requirement import Requirement
from ..plugins.registry import Registry
from ..search.accepted import Concretize
from ..search.effort import crowded_attempts
from ..search.rejection_report import RejectionRow, RejectionStats, as_text, rows_of
from ..search.scene_search import SceneSearch
from ..search.searching import search
from ..search.streams import first_of_stream
from ..search.worker_pool import ALONE, Workers
from ..world.index import index_scenario
from .emitted import Emission, emitted
from .instantiate import ConcreteScene, concrete_scenes, fixed_remarks

SceneObserver = Callable[[int, PassCall, Any], None]
"""Called with the number of a scene, a pass and what it made; see `PassObserver`."""


@dataclass(frozen=True)
class SamplingResult:
    """`scenes` in order of their index; `missing` are those given up after too many attempts.

    `impossible`: no draw can satisfy some requirement; otherwise a missing scene was unlucky.
    """

    scenes: tuple[Scene, ...]
    wanted: int
    candidates: int
    table: tuple[RejectionRow, ...]
    missing: tuple[int, ...] = ()
    impossible: tuple[str, ...] = ()
    impossible_at: Span | None = None
    """where the first of these is written"""
    remarks: tuple[str, ...] = ()
    causes: tuple[str, ...] = ()
    """what is in the way where there is no scene, as far as that is known"""
    warnings: tuple[Diagnostic, ...] = ()
    """what could not be built as drawn"""
    diversity: float | None = None
    """mean distance of each accepted draw to the nearest other, in the unit cube of the draws"""
    expected_diversity: float | None = None
    """the same of as many even draws in a cube of the volume that the requirements leave"""

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
    overrides: dict[str, str] | None = None,
    observer: SceneObserver | None = None,
    workers: Workers = ALONE,
    emission: Emission | None = None,
) -> SamplingResult:
    """The first `n` scenes (all of a grid, one of anything else, where `n` is None).

    With an `emission` their files are taken one after the other, and outlines of them are kept.
    Neither `n` nor the workers change a scene. `observer` sees what each pass makes of each scene,
    and keeps the search in this process. Raises DiagnosticError for what is wrong with the inputs
    or a plugin; that nothing was accepted is no error: the result shows it.
    """
    scenario = index_scenario(source, registry)
    concretize: Concretize[ConcreteScene] = partial(concrete_scenes, overrides=overrides or {})
    if observer is not None:
        concretize = partial(_observed, concretize, observer)
        workers = Workers(progress=workers.progress)
    make: Concretize[Any] = concretize
    if emission is not None:
        make = partial(emitted, concretize, emission.backends, emission.stage)
    task: SceneSearch[Any] = SceneSearch(scenario, seed, make)
    if impossible := impossible_requirements(task.acceptance, seed):
        return _nothing(task, impossible, n or 1)
    found = search(task, n, workers, *(() if emission is None else emission.handling))
    concrete = [sample.result for sample in found.samples]
    _see_scenes(found.stats, task.acceptance, [item.scene for item in concrete])
    table = rows_of(found.stats, task.acceptance.requirements, frozenset())
    remarks = (*fixed_remarks(scenario), *(remark for item in concrete for remark in item.remarks))
    return SamplingResult(
        scenes=tuple(item.scene for item in concrete),
        wanted=found.wanted,
        candidates=found.stats.candidates,
        table=table,
        causes=() if concrete else _causes(task, _rejecting(table)),
        missing=tuple(found.missing),
        remarks=tuple(dict.fromkeys(remarks)),
        warnings=tuple(dict.fromkeys(warning for item in concrete for warning in item.warnings)),
        diversity=found.diversity,
        expected_diversity=found.expected_diversity,
    )


def _see_scenes(stats: RejectionStats, acceptance: Acceptance, scenes: Sequence[Scene]) -> None:
    """Bounds may have accepted a scene before its robustness was computed: now it is known."""
    indices = {found.name: i for i, found in enumerate(acceptance.requirements)}
    for scene in scenes:
        for verdict in scene.requirements:
            if verdict.name in indices and verdict.robustness is not None:
                stats.see(indices[verdict.name], verdict.robustness)


def _observed(
    concretize: Concretize[ConcreteScene],
    observer: SceneObserver,
    candidates: CandidateBatch,
    numbers: Sequence[int],
) -> list[ConcreteScene]:
    """Scenes made one by one from nothing that was computed before, so that every pass runs once
    for each."""
    found = []
    for row, number in enumerate(numbers):
        scenario = index_scenario(candidates.scenario.source, candidates.scenario.registry)
        scenario.observer = partial(observer, number)
        one = candidates.take(np.array([row]))
        identity = (candidates.seed, one.scenes, one.attempts, one.coordinates)
        single = CandidateBatch(scenario, *identity, DrawRecord())
        found += concretize(single, [number])
        record = single.record
        assert record is not None
        assert candidates.record is not None
        candidates.record.add_alone({row: record}, candidates.count)
    return found


def _nothing(task: SceneSearch[Any], impossible: frozenset[int], wanted: int) -> SamplingResult:
    acceptance = task.acceptance
    nothing_tried = RejectionStats.empty(len(acceptance.requirements))
    rows = rows_of(nothing_tried, acceptance.requirements, impossible)
    known = {row.name for row in rows}
    for index in sorted(impossible):
        requirement = acceptance.requirements[index]
        if requirement.name not in known:
            rows += (
                RejectionRow(requirement.name, requirement.text, requirement.line, 1, 1, 1.0, None,
                    requirement.implied, True),
            )  # fmt: skip
    texts = tuple(acceptance.requirements[index].text for index in sorted(impossible))
    causes = _causes(task, texts)
    shown = tuple(_shown(acceptance.requirements[index]) for index in sorted(impossible))
    place = acceptance.requirements[min(impossible)].span
    return SamplingResult((), wanted, 0, rows, (0,), shown, place, causes=causes)


def _shown(requirement: Requirement) -> str:
    """Its formula; of a monitor, whose options tell less, its name as well; words as they are."""
    text = requirement.text
    if isinstance(requirement.test, PassCall):
        return f"`{requirement.name}` ({text})"
    return text if requirement.test is None else f"`{text}`"


def _rejecting(table: Sequence[RejectionRow]) -> list[str]:
    """The texts of what rejects most, and of all that reject every candidate that reaches them."""
    every = [row.text for row in table[1:] if row.tried and row.rejected == row.tried]
    return [*(row.text for row in table[:1]), *every]


def _causes(task: SceneSearch[Any], texts: Sequence[str]) -> tuple[str, ...]:
    """What is in the way of the requirements of these texts, in words, where that is known, and of
    those that go without saying and that none of the first candidates satisfies."""
    few = _first_candidates(task)
    found: list[str | None] = []
    for requirement in task.acceptance.requirements:
        is_named = requirement.text in texts
        if is_named:
            found += reasons(requirement, few)
        if requirement.blame is None:
            continue
        with nullcontext() if is_named else suppress(DiagnosticError):
            violating = _violating(requirement, few, is_named)
            if violating is not None:
                found.append(requirement.blame(violating))
    return tuple(text for text in found if text is not None)


def _violating(
    requirement: Requirement, few: CandidateBatch, is_named: bool
) -> CandidateBatch | None:
    """A candidate that violates a requirement; of one that is not named, only where all do. The
    others are judged only where the first does not tell: to place a crowd takes seconds."""
    first = few.take(np.arange(1))
    is_violated = bool(requirement.rho(first)[0] < 0.0)
    if is_violated == is_named or few.count == 1:
        return first if is_violated else None
    others = few.take(np.arange(1, few.count))
    violating = np.flatnonzero(requirement.rho(others) < 0.0)
    if is_named:
        return others.take(violating[:1]) if len(violating) else None
    return first if len(violating) == others.count else None


def _first_candidates(task: SceneSearch[Any]) -> CandidateBatch:
    """Some candidates as the sampler proposes them: what it chooses is not drawn again."""
    acceptance, seed = task.acceptance, task.seed
    count = min(FIRST, crowded_attempts(acceptance.scenario))
    count = 1 if acceptance.has_varying_stations else count
    if task.sampler.kind.sequential:
        return first_of_stream(acceptance, task.sampler, seed, count)
    return CandidateBatch(acceptance.scenario, seed, np.zeros(count, np.int64), np.arange(count))
