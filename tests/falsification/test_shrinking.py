"""The simplest draws that still fail, and which draws matter."""

from __future__ import annotations

import pytest

from roadlang import Falsification
from roadlang.falsification.evaluator import Proposal
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
