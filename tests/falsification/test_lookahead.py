"""Rounds of searchers that use no results: every worker has one for itself."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import pytest

from roadlang.falsification import lookahead, search_loop
from roadlang.falsification.evaluator import Proposal
from roadlang.falsification.journal import NoJournal
from roadlang.falsification.outcome import Outcome
from roadlang.falsification.plan import Plan
from roadlang.falsification.search_loop import search_failures
from roadlang.plugins.discovery import load_registry
from roadlang.plugins.finding import entry_of
from roadlang.plugins.kinds import Axis

AXES = (Axis("a"), Axis("b"))
EXPECTS = ("slow",)


class Pool:
    """Workers that are there already; every part takes them some seconds on a clock."""

    will_fork = False

    def __init__(self, workers: int, seconds: float) -> None:
        self.workers, self.seconds = workers, seconds
        self.now = 0.0
        self.sizes: list[list[int]] = []
        self.state = SimpleNamespace(task=None)

    def map(self, work: Any, jobs: Any) -> Iterator[Any]:
        if jobs:
            self.sizes.append([len(job) for job in jobs])
            self.now += self.seconds
        for job in jobs:
            yield [outcome(proposal) for proposal in job]


def outcome(proposal: Proposal) -> Outcome:
    rho = proposal.point[0] - 0.05
    violated = EXPECTS if rho < 0 else ()
    return Outcome(
        proposal.index, proposal.point, proposal.is_random, None, {}, {"slow": rho}, violated,
        descriptor=tuple(100 * place for place in proposal.point),
    )  # fmt: skip


def searched(
    pool: Any, monkeypatch: pytest.MonkeyPatch, searcher: str = "halton", **changes: Any
) -> tuple[Any, list[list[int]]]:
    entry = entry_of(load_registry(), "falsify", searcher)
    kind: Any = entry.load()
    plan = Plan(kind(), entry, 7, **{"evaluations": 330, "batch": 50, **changes})
    monkeypatch.setattr(search_loop, "_screened", lambda points, pool: points[:, 0] * 0.0)
    monkeypatch.setattr(lookahead, "now", lambda: pool.now)
    return search_failures(plan, AXES, pool, EXPECTS, NoJournal()), pool.sizes


@pytest.mark.parametrize("searcher", ["random", "halton"])
@pytest.mark.parametrize("workers", [2, 3])
def test_every_worker_has_a_whole_round_and_the_result_is_that_of_one(
    searcher: str, workers: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    alone, _ = searched(Pool(1, 1.0), monkeypatch, searcher)
    found, sizes = searched(Pool(workers, 1.0), monkeypatch, searcher)
    assert found == alone
    assert alone.failures
    assert sizes[1] == [50] * workers  # after the first round, which is divided among them
    assert sum(map(sum, sizes)) == 330


@pytest.mark.parametrize(
    ("searcher", "seconds", "changes"),
    [
        ("cma", 0.1, {}),
        ("halton", 6.0, {}),
        ("halton", 4.0, {}),  # of half a round: a whole one would take 8 s
        ("halton", 0.1, {"failures": 100}),
    ],
)
def test_a_round_is_divided_where_its_results_are_waited_for_or_it_takes_long(
    searcher: str, seconds: float, changes: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    _, sizes = searched(Pool(2, seconds), monkeypatch, searcher, **changes)
    assert max(map(sum, sizes)) <= 50


def test_a_search_ends_where_its_points_do(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also in the middle of rounds that are evaluated together."""
    found, sizes = searched(Pool(4, 0.1), monkeypatch, "grid", batch=8, random=0.0)
    assert len(found.outcomes) == 25
    assert sizes == [[8], [8, 9]]
