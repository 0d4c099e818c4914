"""The search for failures, round after round, until a stop rule ends it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, islice

import numpy as np

from ..drive.simulators import scenes_at_once
from ..geometry.arrays import Floats
from ..plugins.kinds import Axis
from ..search.worker_pool import WorkerPool
from .distinct import DistinctFailures
from .evaluator import Evaluator, Proposal, Task
from .grading import Grading
from .islands import Islands
from .journal import Journal
from .lookahead import Lookahead
from .outcome import Outcome
from .plan import Plan

Progress = Callable[[int, int], None]
Expired = Callable[[], bool]
FEWEST_AT_ONCE = 8
"""Candidates for a worker, at least: a simulator drives many at a time in little more time."""


@dataclass(frozen=True)
class SearchResult:
    """`outcomes` in the order of their numbers; `failures`: the distinct ones, worst first."""

    outcomes: tuple[Outcome, ...]
    failures: tuple[Outcome, ...]


def search_failures(
    plan: Plan,
    axes: Sequence[Axis],
    pool: WorkerPool[Evaluator],
    expects: Sequence[str],
    journal: Journal,
    progress: Progress | None = None,
    expired: Expired = lambda: False,
) -> SearchResult:
    """Search by the plan. `expired` tells whether the time is over."""
    islands = Islands(plan, axes, lambda points: _screened(points, pool))
    grading, lookahead = Grading(expects), Lookahead(plan, pool)
    outcomes: list[Outcome] = []
    distinct = DistinctFailures()
    values: dict[int, float] = {}
    is_over = False
    while not is_over and len(outcomes) < plan.evaluations and not expired():
        rounds = _asked(islands, lookahead.begin(), len(outcomes), plan.evaluations)
        evaluated = _evaluated(list(chain(*rounds)), pool, journal)
        for proposals in rounds:
            found = list(islice(evaluated, len(proposals)))
            graded = grading.values(found)
            islands.tell(found, graded)
            values |= {outcome.index: float(v) for outcome, v in zip(found, graded, strict=True)}
            is_over = is_over or _add(found, outcomes, distinct, plan.failures)
        lookahead.end(sum(map(len, rounds)))
        is_over = is_over or not all(rounds)
        if progress is not None and rounds[0]:
            progress(len(outcomes), plan.evaluations)
    ranked = sorted(distinct.found, key=lambda outcome: (values[outcome.index], outcome.index))
    return SearchResult(tuple(outcomes), tuple(ranked))


def _asked(islands: Islands, most: int, first: int, end: int) -> list[list[Proposal]]:
    """The next rounds, at most so many, numbered from `first` to before `end`; an empty one where
    the searches have come to their ends."""
    rounds: list[list[Proposal]] = []
    while len(rounds) < most and first < end:
        rounds.append(islands.ask(first, end - first))
        if not rounds[-1]:
            break
        first += len(rounds[-1])
    return rounds


def _add(
    found: Sequence[Outcome],
    outcomes: list[Outcome],
    distinct: DistinctFailures,
    enough: int | None,
) -> bool:
    """Add outcomes up to the one with which there are enough distinct failures."""
    for outcome in found:
        outcomes.append(outcome)
        if outcome.is_failure:
            distinct.add(outcome)
            if enough is not None and len(distinct.found) >= enough:
                return True
    return False


def _screened(points: Floats, pool: WorkerPool[Evaluator]) -> Floats:
    """Points judged by the requirements alone, where evaluations are done."""
    workers = 1 if pool.will_fork else pool.workers
    parts = [points[part] for part in equal_parts(len(points), workers)]
    return np.concatenate([*pool.map(Evaluator.screen, parts), np.empty(0)])


def _evaluated(
    proposals: Sequence[Proposal], pool: WorkerPool[Evaluator], journal: Journal
) -> Iterator[Outcome]:
    """The outcome of each, of the journal where it was evaluated before."""
    known = {proposal.index: journal.known(proposal) for proposal in proposals}
    new = [proposal for proposal in proposals if known[proposal.index] is None]
    found: dict[int, Outcome] = {}
    for outcomes in _handed_out(new, pool):
        journal.append(outcomes)
        found |= {outcome.index: outcome for outcome in outcomes}
    for proposal in proposals:
        yield known[proposal.index] or found[proposal.index]


def _handed_out(
    proposals: Sequence[Proposal], pool: WorkerPool[Evaluator]
) -> Iterator[list[Outcome]]:
    """The outcomes of parts of the proposals. Before processes are forked a few are evaluated here,
    so that what drives them is loaded once for all; not by a simulator that drives only a few in
    one call, as those do that take long or are programs of their own."""
    is_worth_it = pool.will_fork and _scenes_at_once(pool.state.task) > FEWEST_AT_ONCE
    few = FEWEST_AT_ONCE if is_worth_it else 0
    for some, workers in ((proposals[:few], 1), (proposals[few:], pool.workers)):
        parts = [some[part] for part in equal_parts(len(some), workers)]
        yield from pool.map(Evaluator.evaluate, parts)


def _scenes_at_once(task: Task) -> int:
    """How many scenes the simulator of a search drives in one call."""
    stated = task.scenario.simulate
    return scenes_at_once(task.registry, task.engine or (None if stated is None else stated.kind))


def equal_parts(candidates: int, workers: int) -> list[slice]:
    """Equal parts, one for each worker where that is worth it."""
    if not candidates:
        return []
    count = max(1, min(workers, candidates // FEWEST_AT_ONCE))
    ends = [candidates * part // count for part in range(count + 1)]
    return [slice(ends[part], ends[part + 1]) for part in range(count)]
