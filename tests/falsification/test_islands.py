"""Which candidates the searches of a plan give, and what each of them is told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.falsification.evaluator import Proposal
from roadlang.falsification.islands import Islands, _seed
from roadlang.falsification.outcome import Outcome
from roadlang.falsification.plan import Plan
from roadlang.geometry.arrays import Floats
from roadlang.plugins.kinds import Axis, Search, Searcher
from roadlang.testing import registry_with

AXES = (Axis("a"), Axis("b"))


class Rising(Search):
    """Gives points in rising order, as many as it has left."""

    def __init__(self, seed: int, left: int, size: int | None) -> None:
        self.seed, self.left, self.size = seed, left, size
        self.given = 0
        self.told: list[tuple[list[float], list[float], list[list[float]]]] = []

    def batch_size(self, most: int) -> int:
        return self.size or most

    def ask(self, count: int) -> Floats:
        count = min(count, self.left - self.given)
        numbers = np.arange(self.given, self.given + count) / 1000.0
        self.given += count
        return np.stack([numbers, np.full(count, 0.5)], axis=1)

    def tell(self, points: Floats, values: Floats, descriptors: Floats) -> None:
        self.told.append((points[:, 0].tolist(), values.tolist(), descriptors.tolist()))


@dataclass(frozen=True)
class Rise(Searcher):
    """Several of those."""

    name: ClassVar[str] = "rise"
    left: int = 1000
    size: int | None = None
    started: list[Rising] = field(default_factory=list)

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        assert axes == AXES
        self.started.append(Rising(seed, self.left, self.size))
        return self.started[-1]


@dataclass(frozen=True)
class Plain(Searcher):
    """Stands for the entry of the kind."""

    name: ClassVar[str] = "plain"

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        raise NotImplementedError


ENTRY = registry_with(Plain).find("falsify", "tested.plain")


def islands(searcher: Searcher, **changes: Any) -> Islands:
    plan = Plan(searcher, ENTRY, 7, 100, **{"batch": 6, "random": 0.0, **changes})
    return Islands(plan, AXES, lambda points: points[:, 0])


def numbers(proposals: Sequence[Proposal]) -> list[tuple[int, float | None]]:
    """Number and place along the first axis; None of those that are drawn at random."""
    return [(p.index, None if p.is_random else p.point[0]) for p in proposals]


def test_searches_without_a_first_point_are_a_fault_of_the_searcher() -> None:
    found = islands(Rise(left=0), islands=2)
    with pytest.raises(DiagnosticError, match="gave no points to begin with") as caught:
        found.ask(0, 12)
    assert caught.value.diagnostics[0].code == "RL474"
    assert found.ask(12, 12) == []  # later it is the end of the search


def test_every_search_gives_a_batch_and_the_last_one_what_is_left() -> None:
    searcher = Rise(size=3)
    found = islands(searcher, islands=2)
    assert numbers(found.ask(10, 5)) == [
        (10, 0.0), (11, 0.001), (12, 0.002), (13, 0.0), (14, 0.001),
    ]  # fmt: skip
    assert [search.seed for search in searcher.started] == [_seed(7, 0), _seed(7, 1)]
    assert len({_seed(7, island) for island in range(-1, 5)} | {_seed(8, 0)}) == 7


def test_the_random_share_is_drawn_by_the_number_of_the_candidate() -> None:
    first = islands(Rise(), random=0.25).ask(0, 100)
    assert numbers(first) == [(0, 0.0), (1, 0.001), (2, 0.002), (3, None), (4, 0.003), (5, 0.004)]
    again = islands(Rise(size=2), random=0.25, islands=2).ask(2, 4)
    assert again[1] == first[3]
    assert all(0.0 <= value < 1.0 for value in first[3].point)
    other = islands(Rise(), random=1.0).ask(0, 6)
    assert len({p.point for p in other}) == 6
    assert numbers(other) == [(index, None) for index in range(6)]


@pytest.mark.parametrize(
    ("left", "random", "given"),
    [
        (2, 0.0, [(0, 0.0), (1, 0.001)]),
        (4, 0.25, [(0, 0.0), (1, 0.001), (2, 0.002), (3, None), (4, 0.003)]),
        (3, 0.25, [(0, 0.0), (1, 0.001), (2, 0.002)]),  # no random one after the last
    ],
)
def test_a_search_that_has_ended_takes_no_more_random_candidates_with_it(
    left: int, random: float, given: list[tuple[int, float | None]]
) -> None:
    found = islands(Rise(left=left), random=random)
    assert numbers(found.ask(0, 100)) == given
    assert numbers(found.ask(len(given), 100)) == []


def test_each_search_is_told_of_its_own_points() -> None:
    """With descriptors of one length: of those that are shorter NaN."""
    searcher = Rise(size=2)
    found = islands(searcher, islands=2, random=0.25)
    asked = found.ask(2, 4)
    assert numbers(asked) == [(2, 0.0), (3, None), (4, 0.0), (5, 0.001)]
    outcomes = [
        Outcome(p.index, p.point, p.is_random, None, descriptor=(1.0, 2.0)[: 2 - p.index % 2])
        for p in asked
    ]
    found.tell(outcomes, np.array([0.1, 0.2, 0.3, 0.4]))
    (first,), (second,) = (search.told for search in searcher.started)
    assert first == ([0.0], [0.1], [[1.0, 2.0]])
    assert second[:2] == ([0.0, 0.001], [0.3, 0.4])
    np.testing.assert_array_equal(second[2], [[1.0, 2.0], [1.0, np.nan]])


@pytest.mark.parametrize(("points", "fault"), [
    (np.zeros((3, 1)), r"shape \(3, 1\), not"),
    (np.zeros((7, 2)), r"shape \(7, 2\), not"),
    (np.zeros(2), r"shape \(2,\), not"),
    (np.full((1, 2), 1.0), "coordinate 1, which is not within"),
    (np.full((1, 2), -0.1), "coordinate -0.1, which is not within"),
    (np.full((1, 2), np.nan), "coordinate nan, which is not within"),
])  # fmt: skip
def test_points_that_are_none_are_a_fault(points: Floats, fault: str) -> None:
    found = islands(Rise())
    with pytest.raises(DiagnosticError, match=rf"RL474(.|\n)*{fault}"):
        found._checked(points, 6)
