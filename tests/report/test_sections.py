"""The parts of the page, from results made by hand."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import pytest

from roadlang.falsification.statistics import FailureRate
from roadlang.ir.results_record import ResultsRecord
from roadlang.report.charts import progress_chart
from roadlang.report.results import ResultRow, Results
from roadlang.report.sections import facts, heading, headline, progress, provenance

RECORD = ResultsRecord(
    "falsify", "roadlang falsify a.rl", "town", "", "a.rl", 7, "1.0", sampler="cma",
    params={"speed": "9 m/s"}, inputs={"a.png": "00ff"},
    plugins={"roadlang": "1.0", "acme": "2.0"},
)  # fmt: skip


def row(number: int, rho: float | None, failed: bool = False, **values: Any) -> ResultRow:
    return ResultRow(number, failed, {"scene": number, **values}, {"apart": rho})


ROWS = (row(0, 3.0), row(4, None), row(7, -2.0, True), row(8, -0.5, True))


def results(rows: Any = ROWS, **changes: Any) -> Results:
    return Results(**{
        "record": RECORD, "expects": ("apart",), "rows": rows, "drives": (), "coverage": {},
        **changes,
    })  # fmt: skip


def words(page: str) -> str:
    """Without elements and with plain blanks."""
    plain = re.sub("<[^>]*>", "|", page).replace("\N{NO-BREAK SPACE}", " ")
    return re.sub(r"\|+", "|", plain).replace("\N{MINUS SIGN}", "-").strip("|")


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"evaluations": 10}, "Search for failures with cma, seed 7"),
        ({}, "Scenes, driven; seed 7"),
    ],
)
def test_what_was_done(changes: dict[str, Any], said: str) -> None:
    assert heading(results(**changes)) == said


def test_a_scene_without_a_seed_was_driven_alone() -> None:
    assert heading(results(record=replace(RECORD, seed=None))) == "One scene, driven"


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"expects": ()}, "4 scenes driven; the file has no expectations."),
        ({"rows": (), "distinct": 0}, "No candidate satisfies the requirements."),
        ({"rows": ROWS[:1]}, "All expectations hold in 1 scene."),
        ({"rows": ROWS[:2], "distinct": 0}, "All expectations hold in 2 scenes."),
        ({}, "All expectations hold in 2 of 4 scenes."),
        ({"distinct": 1}, "1 distinct failure: 2 of 4 scenes fail."),
        ({"distinct": 2}, "2 distinct failures: 2 of 4 scenes fail."),
    ],
)
def test_the_result_in_a_sentence(changes: dict[str, Any], said: str) -> None:
    assert headline(results(**changes)) == said


def test_the_result_of_a_search_in_numbers() -> None:
    rate = FailureRate(2, 40, 0.01, 0.17)
    assert words(facts(results(evaluations=1200, distinct=2, rate=rate), ())).split("|") == [
        "Evaluations", "1,200", "4 satisfy the requirements", "Failing", "2",
        "50% of the scenes driven", "Distinct", "2", "other road, behavior or cause",
        "First failure", "7", "evaluation", "Failure rate at random", "1% to 17%",
        "95% interval, 2 of 40", "Lowest robustness of apart", "-2", "evaluation 7",
    ]  # fmt: skip


def test_the_result_of_a_run_in_numbers() -> None:
    assert words(facts(results(), ())).split("|") == [
        "Scenes", "4", "Failing", "2", "50% of the scenes driven",
        "Lowest robustness of apart", "-2", "scene 7",
    ]  # fmt: skip
    in_runs = results((row(0, 1.0, run=3), row(1, 2.0, run=4)))
    assert words(facts(in_runs, ())).endswith("Lowest robustness of apart|1|3, scene 0")
    assert words(facts(results((), evaluations=9), ())).split("|") == [
        "Evaluations", "9", "0 satisfy the requirements", "Failing", "0",
    ]  # fmt: skip
    assert words(facts(results(expects=()), ())) == "Scenes|4"


def test_the_progress_of_an_expectation_is_that_of_the_drives_that_have_it() -> None:
    best = [(0, 3.0), (7, -2.0)]
    found = progress(results(best={"apart": best}), ())
    chart = progress_chart([0, 7, 8], [3.0, -2.0, -0.5], [False, True, True], best, "")
    assert chart in found
    assert words(found).startswith("Robustness of apart during the search| Each dot is a drive")
    assert progress(results(), ()) == ""
    empty = progress(results(best={"other": []}), ())
    assert "<svg" not in empty


def test_what_results_were_made_from() -> None:
    assert words(provenance(results())).split("|") == [
        "Command", "roadlang falsify a.rl", "Scene file", "a.rl", "Params", "speed = 9 m/s",
        "Inputs (SHA-256)", "a.png 00ff", "Versions", "roadlang 1.0", "acme 2.0",
    ]  # fmt: skip
