"""The search for failures for Python users: what was found, and its files.

A facade: a scenario is falsified, and a failure is a scene that can be driven again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..diagnostics import Code, Diagnostic, DiagnosticError, arguments, diagnose
from ..falsification.axes import axes_of
from ..falsification.deadline import deadline
from ..falsification.evaluator import Evaluator, Proposal, Task
from ..falsification.grading import Grading
from ..falsification.journal import Journal, NoJournal
from ..falsification.outcome import Outcome
from ..falsification.outcome_rows import places_of, row_of
from ..falsification.plan import Plan
from ..falsification.search_key import search_key
from ..falsification.search_loop import SearchResult, search_failures
from ..falsification.settings import plan_of
from ..falsification.shrinking import Influence, influences, shrunk
from ..falsification.statistics import Coverage, FailureRate, best_so_far, coverage, failure_rate
from ..judging.impossible import impossible_requirements
from ..search.rejection_report import RejectionRow, rows_of_outcomes
from ..search.worker_pool import WorkerPool, Workers
from ..simulation.vehicles import compiled
from ..world.index import index_scenario
from .result_folders import journal_of_search
from .scene import Scene
from .tables import columns_of, frame_of

if TYPE_CHECKING:
    import pandas

    from .drives import Drive, DriveSet
    from .loading import LoadedScenario

SAFE_DRIVES = 12
"""Scenes in which nothing is violated that are written beside the failures, to compare."""
_RANGE = (
    "write a range, such as `speed: 8m/s..20m/s`, where a value may vary",
    "`roadlang run` drives the only scene there is",
)


@dataclass(frozen=True)
class Drives:
    """Where scenes are driven: a simulator by its name, with options in SI units."""

    engine: str | None = None
    options: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        arguments.text_or_none("engine", self.engine)


class Failure:
    """A scene that violates an expectation. `rank` counts from 1, the worst first."""

    def __init__(self, rank: int, outcome: Outcome, search: Falsification) -> None:
        self.rank = rank
        self.outcome = outcome
        self._search = search

    def __repr__(self) -> str:
        return f"<failure {self.rank}: {', '.join(self.outcome.violated)} in {self.scene!r}>"

    @property
    def axes(self) -> tuple[str, ...]:
        """The random values that its coordinates are of."""
        return self._search.evaluator.task.axes

    @property
    def simplest(self) -> tuple[float, ...]:
        """Where in [0, 1) the simplest values of its axes are."""
        return self._search.evaluator.simplest

    @property
    def robustness(self) -> Mapping[str, float | None]:
        """Of each expectation of the search."""
        return self.outcome.expectations

    @cached_property
    def scene(self) -> Scene:
        """The scene, with all that figures show. Its number is that of the evaluation."""
        return self._search.scene(self.outcome)

    def shrink(self) -> Failure:
        """The same failure with as many draws as possible at their simplest values (0 or what is
        nearest to it, the first of a `choice`, the median of other distributions), and the others
        nearer to theirs."""
        return Failure(self.rank, shrunk(self.outcome, self._search.evaluator), self._search)

    def explain(self) -> Mapping[tuple[str, ...], float | None]:
        """Which draws matter: the robustness of the violated expectation with each at its median,
        and with pairs of those that matter most, the greatest first; None where it is not finite or
        a requirement is then violated."""
        return {found.draws: found.robustness for found in self.influences}

    @cached_property
    def influences(self) -> tuple[Influence, ...]:
        """What `explain` gives, and whether the expectation then holds."""
        evaluator = self._search.evaluator
        return influences(self.outcome, evaluator, evaluator.task.axes)

    @property
    def drive(self) -> Drive:
        """The scene, driven once more; all failures are driven together."""
        search, place = self._search, self.rank - 1
        alike = search.failures[place : place + 1]  # none where it was read from a file alone
        if alike and alike[0].outcome is self.outcome:  # it is not shrunk
            return search.failure_drives[place]
        return search._driven([self.scene])[0]


class Falsification:
    """What a search came to. `outcomes` are all evaluated candidates in their order."""

    def __init__(
        self,
        loaded: LoadedScenario,
        plan: Plan,
        evaluator: Evaluator,
        result: SearchResult,
        remarks: tuple[Diagnostic, ...] = (),
    ) -> None:
        self.loaded = loaded
        self.plan = plan
        self.evaluator = evaluator
        self.outcomes = result.outcomes
        self._remarks = remarks
        self.failures = tuple(
            Failure(rank, outcome, self) for rank, outcome in enumerate(result.failures, 1)
        )

    def __repr__(self) -> str:
        return f"<{len(self.failures)} distinct failures in {len(self.outcomes):,} evaluations>"

    @property
    def expects(self) -> tuple[str, ...]:
        """The expectations of the search, the most important first."""
        return self.evaluator.task.expects

    @property
    def drives(self) -> Drives:
        """Where the scenes were driven."""
        return Drives(self.evaluator.task.engine, self.evaluator.task.options)

    @cached_property
    def failure_drives(self) -> DriveSet:
        """The failures, driven once more."""
        return self._driven_again[0]

    @cached_property
    def safe_drives(self) -> DriveSet:
        """Some scenes in which nothing is violated, driven once more: from the one that came
        nearest to failing to the one that was farthest from it."""
        return self._driven_again[1]

    @cached_property
    def _driven_again(self) -> tuple[DriveSet, DriveSet]:
        """The failures and those scenes: together they take little more time than either."""
        from .drives import DriveSet

        failing = [failure.outcome for failure in self.failures]
        drives = self._driven(self._scenes([*failing, *self._safe()]))
        return DriveSet(iter(drives[: len(failing)])), DriveSet(iter(drives[len(failing) :]))

    def _safe(self) -> list[Outcome]:
        safe = [outcome for outcome in self.driven if not outcome.is_failure]
        values = Grading(self.expects).values(safe).tolist()
        nearest = sorted(range(len(safe)), key=values.__getitem__)
        count = min(SAFE_DRIVES, len(safe))
        places = [step * (len(safe) - 1) // max(count - 1, 1) for step in range(count)]
        return [safe[nearest[place]] for place in places]

    @cached_property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Warnings of lines of the journal (RL724), and of windows that hold no sample of the roads
        (RL308, RL313) or of a drive: a safe one if there is one, since others may end early."""
        looked_at = sorted(self.driven, key=lambda outcome: outcome.is_failure)[:1]
        if not looked_at:
            return self._remarks
        (outcome,) = looked_at
        told = {Code.WINDOW_BETWEEN_SAMPLES}
        told |= set() if outcome.is_failure else {Code.WINDOWS_BEYOND_END}
        of_roads = self.evaluator.window_warnings(Proposal(outcome.index, outcome.point))
        drives = self.safe_drives if len(self.safe_drives) else self._driven([self.scene(outcome)])
        found = (
            *self._remarks,
            *of_roads,
            *(each for each in drives.diagnostics if each.code in told),
        )
        return tuple(dict.fromkeys(found))

    def scene(self, outcome: Outcome) -> Scene:
        """The scene of a candidate; its number is that of the evaluation."""
        return self._scenes([outcome])[0]

    def _scenes(self, outcomes: Sequence[Outcome]) -> list[Scene]:
        proposals = [Proposal(outcome.index, outcome.point) for outcome in outcomes]
        records = self.evaluator.full_scenes(proposals)
        return [Scene(record, self.loaded) for record in records]

    def _driven(self, scenes: Sequence[Scene]) -> DriveSet:
        from .drives import drive

        loaded, drives = self.loaded, self.drives
        options, expects = drives.options, self.expects
        return drive(scenes, loaded.registry, drives.engine, options, loaded.places, expects)

    @property
    def driven(self) -> tuple[Outcome, ...]:
        """The candidates that satisfy the requirements."""
        return tuple(outcome for outcome in self.outcomes if outcome.is_valid)

    @property
    def rejections(self) -> tuple[RejectionRow, ...]:
        """How many candidates violate each requirement, those that most violate first."""
        requirements = self.evaluator.acceptance.requirements
        return rows_of_outcomes(requirements, [found.requirements for found in self.outcomes])

    @property
    def rate(self) -> FailureRate:
        """The share of failures among scenes drawn at random, with its confidence interval."""
        return failure_rate(self.outcomes)

    @property
    def coverage(self) -> Mapping[str, Coverage]:
        """What the drives had of curvature, speed and gap."""
        return coverage(self.outcomes)

    @property
    def best(self) -> Mapping[str, Sequence[tuple[int, float]]]:
        """Of each expectation, the evaluations at which its robustness came lower than before."""
        return {name: best_so_far(self.outcomes, name) for name in self.expects}

    def rows(self, outcomes: Sequence[Outcome] | None = None) -> list[dict[str, Any]]:
        """A row for each driven candidate: evaluation, params, draws, coordinates of what a pass
        draws for itself, robustness, and the moment that decides a violated expectation."""
        axes = self.evaluator.task.axes
        places = places_of(self.outcomes)
        chosen = self.driven if outcomes is None else outcomes
        return [row_of(found, axes, places) for found in chosen]

    def to_dict(self) -> dict[str, list[Any]]:
        """`rows` as columns for `pandas.DataFrame`."""
        return columns_of(self.rows())

    def to_frame(self) -> pandas.DataFrame:
        """`rows` as a data frame with the evaluations as index. Raises `ImportError` without
        pandas."""
        return frame_of(self.to_dict(), "evaluation")

    def write(self, folder: str | Path, figures: int | None = None) -> None:
        """Write failures, tables, summary; see the guide. `figures`: how many failures, from the
        worst on, are drawn; all by default. Raises `DiagnosticError` RL460."""
        from .falsification_files import write_falsification

        write_falsification(self, arguments.path("folder", folder), figures)


def falsified(
    loaded: LoadedScenario,
    seed: int,
    searcher: str | None,
    settings: Mapping[str, Any],
    drives: Drives,
    workers: Workers,
    folder: Path | None = None,
    resume: bool = False,
) -> Falsification:
    """Search; `LoadedScenario.falsify` tells what is raised. The journal is in `folder`."""
    scenario = index_scenario(loaded.scenario, loaded.registry)
    plan, expects = plan_of(scenario, seed, searcher, settings)
    axes = axes_of(scenario, seed)
    if not axes:
        raise DiagnosticError(diagnose(Code.NOTHING_TO_SEARCH, help=_RANGE))
    task = Task(
        loaded.scenario, loaded.registry, seed, tuple(axis.name for axis in axes), expects,
        drives.engine, dict(drives.options), loaded.params, plan.after_violation,
    )  # fmt: skip
    evaluator = Evaluator(task)
    if impossible_requirements(evaluator.acceptance, seed):
        from .scene_set import refuse_impossible  # with what a search does not import

        refuse_impossible(loaded, seed)
    journal: Journal = NoJournal()
    if folder is not None:
        journal = journal_of_search(folder, search_key(task, plan), resume)
    compiled.expect(plan.evaluations / plan.batch)
    with journal.removed_if_nothing_is_finished(), WorkerPool(evaluator, workers) as pool:
        expired = deadline(plan.seconds)
        result = search_failures(plan, axes, pool, expects, journal, workers.progress, expired)
    return Falsification(loaded, plan, evaluator, result, journal.diagnostics)
