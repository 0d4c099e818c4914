"""Grading, distinct failures and statistics, each by itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from roadlang.falsification import search_loop
from roadlang.falsification.axes import _ascending, _coordinate
from roadlang.falsification.distinct import DistinctFailures
from roadlang.falsification.evaluator import Evaluator, Proposal, _is_of_draws
from roadlang.falsification.grading import Grading
from roadlang.falsification.journal import NoJournal
from roadlang.falsification.outcome import Moment, Outcome
from roadlang.falsification.outcome_rows import row_of
from roadlang.falsification.search_loop import _evaluated, _screened, equal_parts
from roadlang.falsification.statistics import (
    best_so_far,
    clopper_pearson,
    coverage,
    failure_rate,
)


def driven(index: int, violated: str = "", **robustness: float | None) -> Outcome:
    return Outcome(index, (0.5,), False, None, {}, robustness, tuple(violated.split()))


def test_a_row_of_a_table_has_draws_coordinates_of_passes_and_the_moment_of_a_failure() -> None:
    safe = replace(driven(3, a=1.0), point=(0.1, 0.2), draws={"end": 90.0})
    row = {
        "evaluation": 3, "random": False, "end": 90.0, "main/perturb 1:0": 0.2, "a": 1.0,
        "violated": "",
    }  # fmt: skip
    assert row_of(safe, ["end", "main/perturb 1:0"], {"end"}) == row
    moment = Moment("a", 1.5, "ego", 2.0, 3.0, station=4.0, partner="lead")
    where = {"time": 1.5, "agent": "ego", "x": 2.0, "y": 3.0, "station": 4.0, "partner": "lead"}
    fails = replace(safe, violated=("a", "b"), moment=moment)
    more = {f"violation {name}": value for name, value in where.items()}
    assert row_of(fails, ["end", "main/perturb 1:0"], {"end"}) == {**row, "violated": "a b", **more}
    nowhere = row_of(replace(fails, moment=None), ["end", "main/perturb 1:0"], {"end"})
    assert nowhere == {**row, "violated": "a b", **dict.fromkeys(more)}


def test_a_row_leaves_out_draws_that_were_not_made() -> None:
    outcome = replace(driven(3, a=1.0), point=(0.1, 0.2, 0.3), draws={"cars/kind[1]": "van"})
    row = row_of(outcome, ["cars/kind[1]", "cars/kind[2]", "cars/drive 1:0"], {"cars/kind"})
    assert row["cars/kind[1]"] == "van"
    assert "cars/kind[2]" not in row
    assert row["cars/drive 1:0"] == 0.3


def invalid(index: int, violation: float) -> Outcome:
    return Outcome(index, (0.5,), False, violation)


def test_invalid_is_above_safe_and_safe_above_failing() -> None:
    outcomes = [
        invalid(0, 3.0),
        invalid(1, 0.01),
        driven(2, a=None),
        driven(3, a=5.0),
        driven(4, a=0.1),
        driven(5, a=1e-6),
        driven(6, "a", a=0.0),
        driven(7, "a", a=-0.1),
        driven(8, "a", a=-50.0),
        driven(9, "a", a=None),
    ]
    values = Grading(["a"]).values(outcomes)
    assert (np.diff(values) < 0).all()
    assert (values[:2] >= 1).all()
    assert ((values[2:6] >= 0) & (values[2:6] < 1)).all()
    assert (values[6:] < 0).all()


def test_violating_the_more_important_expectation_counts_for_more() -> None:
    first, second = driven(0, "a", a=-0.1, b=1.0), driven(1, "b", a=1.0, b=-9.0)
    values = Grading(["a", "b"]).values([first, second])
    assert values[0] < values[1] < 0


def test_safe_scenes_are_measured_by_the_expectation_they_are_nearest_to_violating() -> None:
    """Units do not matter: robustness counts in the median of its expectation."""
    outcomes = [driven(0, a=1.0, b=100.0), driven(1, a=1.0, b=10.0), driven(2, a=0.1, b=100.0)]
    values = Grading(["a", "b"]).values(outcomes)
    assert values[1] == pytest.approx(values[2])
    assert values[0] > values[1]


def test_an_equality_that_holds_does_not_hide_the_other_expectations() -> None:
    """`contacts == 0` holds with robustness 0, whatever happens."""
    outcomes = [driven(0, a=0.0, b=5.0), driven(1, a=0.0, b=0.1), driven(2, "a", a=-1.0, b=5.0)]
    values = Grading(["a", "b"]).values(outcomes)
    assert values[2] < 0.0 < values[1] < values[0] < 1.0
    assert values[:2].tolist() == pytest.approx(Grading(["b"]).values(outcomes)[:2].tolist())


@given(st.lists(st.floats(-10, 10).filter(bool), min_size=2, max_size=20))
def test_one_expectation_is_graded_as_its_robustness_ranks(robustness: list[float]) -> None:
    outcomes = [driven(i, "a" if rho < 0 else "", a=rho) for i, rho in enumerate(robustness)]
    values = Grading(["a"]).values(outcomes)
    for i, j in zip(range(len(values)), range(1, len(values)), strict=False):
        if robustness[i] < robustness[j]:
            assert values[i] <= values[j]


def failing(index: int, place: float, expectation: str = "a", partner: str = "") -> Outcome:
    moment = Moment(expectation, 1.0, "ego", 0.0, 0.0, partner_kind=partner)
    outcome = driven(index, expectation, **{expectation: -1.0})
    return replace(outcome, descriptor=(place, 0.0), moment=moment)


def test_failures_are_distinct_further_apart_than_one_or_of_another_cause() -> None:
    distinct = DistinctFailures()
    assert distinct.add(failing(0, 0.0))
    assert not distinct.add(failing(1, 1.0))
    assert distinct.add(failing(2, 1.01))
    assert distinct.add(failing(3, 0.0, "b"))
    assert distinct.add(failing(4, 0.0, "a", "pedestrian"))
    assert not distinct.add(failing(5, 0.5, "a", "pedestrian"))
    assert [outcome.index for outcome in distinct.found] == [0, 2, 3, 4]


@pytest.mark.parametrize("seed", range(5))
def test_a_failure_is_distinct_if_it_is_farther_than_one_from_all_that_are(seed: int) -> None:
    distinct, kept = DistinctFailures(), np.empty((0, 3))
    for index, point in enumerate(np.random.default_rng(seed).uniform(-2.0, 3.0, (60, 3))):
        outcome = replace(failing(index, 0.0), descriptor=tuple(point.tolist()))
        is_far = bool((np.linalg.norm(kept - point, axis=1) > 1.0).all())
        assert distinct.add(outcome) is is_far
        if is_far:
            kept = np.vstack([kept, point])
    assert 5 < len(kept) < 60


@pytest.mark.parametrize(
    ("successes", "trials", "low", "high"),
    [
        (0, 0, 0.0, 1.0),
        (0, 100, 0.0, 0.0362),
        (100, 100, 0.9638, 1.0),
        (7, 50, 0.0582, 0.2674),
        (1, 10, 0.0025, 0.4450),
        (9, 10, 0.5550, 0.9975),
        (1, 1, 0.025, 1.0),
    ],
)
def test_intervals_of_clopper_and_pearson(
    successes: int, trials: int, low: float, high: float
) -> None:
    assert clopper_pearson(successes, trials) == pytest.approx((low, high), abs=5e-5)


def test_the_failure_rate_is_that_of_valid_random_candidates() -> None:
    outcomes = [
        replace(driven(i, "a" if i % 5 == 0 else "", a=0.0), is_random=True) for i in range(20)
    ]
    outcomes += [driven(20 + i, "a", a=-1.0) for i in range(50)]
    outcomes += [replace(invalid(70, 1.0), is_random=True)]
    rate = failure_rate(outcomes)
    assert (rate.failures, rate.scenes) == (4, 20)
    assert rate.low < 0.2 < rate.high


def test_coverage_counts_scenes_and_failures() -> None:
    outcomes = [
        replace(driven(i, "a" if i == 9 else ""), measures={"speed": float(i), "gap": None})
        for i in range(10)
    ]
    found = coverage(outcomes, parts=5)
    assert set(found) == {"speed"}
    assert (found["speed"].low, found["speed"].high) == (0.0, 9.0)
    assert found["speed"].scenes == (2, 2, 2, 2, 2)
    assert found["speed"].failures == (0, 0, 0, 0, 1)


def test_the_best_robustness_goes_down() -> None:
    outcomes = [driven(i, a=rho) for i, rho in enumerate([3.0, 4.0, None, 1.0, 1.0, -2.0])]
    assert best_so_far(outcomes, "a") == [(0, 3.0), (3, 1.0), (5, -2.0)]


@pytest.mark.parametrize(
    ("candidates", "workers", "sizes"),
    [
        (0, 4, []), (1, 4, [1]), (15, 4, [15]), (16, 4, [8, 8]), (100, 1, [100]),
        (100, 4, [25] * 4), (35, 4, [8, 9, 9, 9]), (100, 0, [100]),
    ],
)  # fmt: skip
def test_a_batch_is_divided_among_workers_in_parts_of_eight_at_least(
    candidates: int, workers: int, sizes: list[int]
) -> None:
    parts = equal_parts(candidates, workers)
    assert [part.stop - part.start for part in parts] == sizes
    assert [i for part in parts for i in range(candidates)[part]] == list(range(candidates))


class Pool:
    """Two workers, which are forked when the first jobs are handed out to them."""

    workers = 2

    def __init__(self) -> None:
        self.sizes: list[list[int]] = []
        scenario = SimpleNamespace(simulate=SimpleNamespace(kind="slow"))
        self.state = SimpleNamespace(
            task=SimpleNamespace(scenario=scenario, registry=None, engine=None)
        )

    @property
    def will_fork(self) -> bool:
        return not any(len(sizes) > 1 for sizes in self.sizes)

    def map(self, work: Any, jobs: Any) -> Iterator[Any]:
        self.sizes.append([len(job) for job in jobs])
        for job in jobs:
            yield np.zeros(len(job)) if work is Evaluator.screen else [driven(p.index) for p in job]


@pytest.mark.parametrize(("at_once", "first"), [(64, [[8], [16, 16]]), (8, [[20, 20]])])
def test_a_few_candidates_are_driven_before_processes_are_forked(
    at_once: int, first: list[list[int]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unless each of them takes long."""
    pool: Any = Pool()
    monkeypatch.setattr(
        search_loop, "scenes_at_once", lambda registry, engine: {"slow": at_once}[engine]
    )
    assert len(_screened(np.zeros((40, 1)), pool)) == 40
    for start in (0, 40):
        proposals = [Proposal(index, (0.5,)) for index in range(start, start + 40)]
        found = list(_evaluated(proposals, pool, NoJournal()))
        assert [outcome.index for outcome in found] == [*range(start, start + 40)]
    assert len(_screened(np.zeros((40, 1)), pool)) == 40
    assert [sizes for sizes in pool.sizes if sizes] == [[40], *first, [20, 20], [20, 20]]


ODD = diagnose(Code.DEGENERATE_ROAD, name="main")
BEYOND = replace(ODD, code=Code.POSITION_OFF_ROAD)
DRAWN = replace(ODD, code=Code.DRAWN_VALUE_OUT_OF_BOUNDS)
OURS = replace(ODD, code=Code.UNKNOWN_LANE)


@pytest.mark.parametrize(
    ("found", "is_of_draws"),
    [((ODD,), True), ((DRAWN, BEYOND), True), ((BEYOND, OURS), False), ((OURS,), False)],
)
def test_a_fault_is_of_the_draws_if_each_part_of_it_is(
    found: tuple[Diagnostic, ...], is_of_draws: bool
) -> None:
    assert _is_of_draws(DiagnosticError(*found)) is is_of_draws


@pytest.mark.parametrize(
    ("cells", "ends"),
    [((1.0,), [1.0]), ((0.25, 0.25, 1), [0.25, 0.25, 1.0]), ((0.0, 1.0 + 1e-10), [0.0, 1.0])],
)
def test_cells_of_an_axis_end_in_order_at_one(cells: tuple[float, ...], ends: list[float]) -> None:
    assert _ascending(iter(cells)) == ends


@pytest.mark.parametrize("cells", [(), (0.5, 0.25, 1.0), (-0.1, 1.0), (0.5, 1.1)])
def test_cells_that_are_none_are_refused(cells: tuple[float, ...]) -> None:
    with pytest.raises(ValueError, match="its cells end at"):
        _ascending(iter(cells))


def test_the_simplest_value_is_in_the_unit_interval() -> None:
    assert [_coordinate(place) for place in (0, 0.5, 0.999)] == [0.0, 0.5, 0.999]
    for place in (-0.001, 1.0, float("nan")):
        with pytest.raises(ValueError, match="its simplest value is at"):
            _coordinate(place)
