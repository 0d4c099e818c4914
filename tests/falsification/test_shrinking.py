"""The simplest draws that still fail, and which draws matter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import pytest

from roadlang import Falsification
from roadlang.falsification.evaluator import Proposal
from roadlang.falsification.outcome import Outcome
from roadlang.falsification.shrinking import influences, shrunk
from roadlang.testing import scenario
from tests.falsification.slider import TEXT, Slider


@pytest.fixture(scope="module")
def search() -> Falsification:
    return scenario(TEXT, kinds=[Slider]).falsify(evaluations=200, seed=3)


def test_a_failure_shrinks_to_one_that_still_fails(search: Falsification) -> None:
    failure = search.failures[0]
    simple = failure.shrink()
    places = zip(simple.outcome.point, simple.simplest, strict=True)
    plain = [value == simplest for value, simplest in places]
    assert sum(plain) > 3
    assert simple.outcome.violated == failure.outcome.violated
    assert simple.drive.verdicts["in_lane"].satisfied is False
    assert simple.drive.verdicts["in_lane"].robustness == simple.robustness["in_lane"]
    assert simple.robustness != failure.robustness
    assert simple.shrink().outcome == simple.outcome
    assert failure.drive.verdicts["in_lane"].robustness == failure.robustness["in_lane"]


def test_what_matters_comes_first(search: Falsification) -> None:
    """Speed makes the car slide; without it there is no failure."""
    found = search.failures[0].explain()
    singles = {names: rho for names, rho in found.items() if len(names) == 1}
    assert len(singles) == len(search.evaluator.task.axes)
    assert len(found) == len(singles) + 28
    worst = search.failures[0].robustness["in_lane"]
    assert worst is not None
    known = [rho for rho in found.values() if rho is not None]
    assert known == sorted(known, reverse=True)
    failure = search.failures[0].outcome
    for number, axis in enumerate(search.evaluator.task.axes):
        point = tuple(0.5 if k == number else v for k, v in enumerate(failure.point))
        (alone,) = search.evaluator.evaluate([Proposal(failure.index, point)])
        assert alone.expectations["in_lane"] == found[axis,]
    speed = found[("ego/drive 1/speed",)]
    assert speed is not None
    assert speed > worst


class Formula:
    """Evaluates points by a formula: the robustness of `a` and of `b`, violated below 0."""

    simplest = (0.0, 0.0, 0.0)
    ordered = (True, True, False)

    def __init__(self, rho: Callable[..., tuple[float, float]]) -> None:
        self.rho = rho
        self.tried: list[tuple[float, ...]] = []

    def evaluate(self, proposals: Sequence[Proposal]) -> list[Outcome]:
        self.tried += [proposal.point for proposal in proposals]
        return [self.outcome(proposal.point) for proposal in proposals]

    def outcome(self, point: tuple[float, ...]) -> Outcome:
        robustness = dict(zip("ab", self.rho(*point), strict=True))
        violated = tuple(name for name, rho in robustness.items() if rho < 0.0)
        return Outcome(0, point, False, None, {}, robustness, violated)


@pytest.mark.parametrize(
    ("rho", "start", "end"),
    [
        (lambda x, y, z: (-1.0, 1.0), (0.9, 0.8, 0.7), (0.0, 0.0, 0.0)),
        (lambda x, y, z: (0.3 - x, 1.0), (0.8, 0.8, 0.7), (0.4, 0.0, 0.0)),
        (lambda x, y, z: (0.3 - z, 1.0), (0.8, 0.8, 0.8), (0.0, 0.0, 0.8)),  # z has no half way
        (lambda x, y, z: (0.01 - x, 1.0), (0.8, 0.0, 0.0), (0.05, 0.0, 0.0)),  # steps of .05
        (lambda x, y, z: (0.3 - x, 0.6 - y), (0.8, 0.8, 0.0), (0.4, 0.0, 0.0)),  # `a` alone counts
        (lambda x, y, z: (1.0, 0.6 - y), (0.8, 0.8, 0.0), (0.0, 0.8, 0.0)),
        # of two that cannot both go, the one with which it fails worst
        (lambda x, y, z: (0.5 - x - 2.0 * y if x + y > 0.7 else 1.0, 1.0), (0.8, 0.8, 0.0),
         (0.0, 0.8, 0.0)),
    ],
)  # fmt: skip
def test_draws_go_to_their_simplest_values_or_half_way_while_the_first_violation_stays(
    rho: Any, start: tuple[float, ...], end: tuple[float, ...]
) -> None:
    evaluator: Any = Formula(rho)
    assert shrunk(evaluator.outcome(start), evaluator).point == pytest.approx(end)


def test_where_it_fails_with_the_simplest_values_one_drive_is_enough() -> None:
    """Even where no single change toward them fails."""
    at_the_ends = lambda x, y, z: (-1.0 if x + y in (0.0, 1.5) else 1.0, 1.0)  # noqa: E731
    evaluator: Any = Formula(at_the_ends)
    assert shrunk(evaluator.outcome((0.8, 0.7, 0.0)), evaluator).point == (0.0, 0.0, 0.0)
    assert len(evaluator.tried) == 1


def test_influences_are_of_the_first_violation_with_draws_at_their_medians() -> None:
    evaluator: Any = Formula(lambda x, y, z: (x - 1.0 + 0.1 * y, z - 1.0))
    listed = influences(evaluator.outcome((0.0, 0.0, 0.0)), evaluator, ["x", "y", "z"])
    found = {item.draws: item.robustness for item in listed}
    assert found == pytest.approx({
        ("x", "y"): -0.45, ("x",): -0.5, ("x", "z"): -0.5, ("y",): -0.95, ("y", "z"): -0.95,
        ("z",): -1.0,
    })  # fmt: skip
    assert list(found) == [("x", "y"), ("x",), ("x", "z"), ("y",), ("y", "z"), ("z",)]
    assert not any(item.holds for item in listed)


def test_an_expectation_that_holds_with_robustness_zero_holds() -> None:
    """As `always (ego.contacts == 0)` does: its robustness is never above 0."""
    evaluator: Any = Formula(lambda x, y, z: (0.0 if x == 0.5 else -1.0, 1.0))
    failure = evaluator.outcome((0.0, 0.0, 0.0))
    found = {item.draws: item.holds for item in influences(failure, evaluator, ["x", "y", "z"])}
    assert found[("x",)] is True
    assert found[("y",)] is False


def test_infinite_robustness_and_no_scene_are_told_apart() -> None:
    class Endless(Formula):
        def outcome(self, point: tuple[float, ...]) -> Outcome:
            found = super().outcome(point)
            if point[0] == 0.5:
                return replace(found, expectations={"a": None}, violated=())
            return replace(found, violation=1.0, expectations={}) if point[1] == 0.5 else found

    evaluator: Any = Endless(lambda x, y, z: (-1.0, 1.0))
    failure = evaluator.outcome((0.0, 0.0, 0.0))
    singles = [item for item in influences(failure, evaluator, "xyz") if len(item.draws) == 1]
    assert [(item.draws, item.holds) for item in singles] == [
        (("x",), True), (("z",), False), (("y",), None),
    ]  # fmt: skip


def test_draws_that_the_scene_does_not_make_are_left_out() -> None:
    """Those of a copy that it lacks; what a pass draws for itself is not among the draws."""

    class Copies(Formula):
        def outcome(self, point: tuple[float, ...]) -> Outcome:
            return replace(super().outcome(point), draws={"cars/at": point[0]})

    evaluator: Any = Copies(lambda x, y, z: (-1.0, 1.0))
    axes = ["cars/at", "cars/at[1]", "bent/perturb 1:0:2"]
    listed = influences(evaluator.outcome((0.0, 0.0, 0.0)), evaluator, axes)
    assert {name for item in listed for name in item.draws} == {axes[0], axes[2]}
