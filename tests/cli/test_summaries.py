"""What commands say of many scenes in a line."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.cli.compilation import Compilation
from roadlang.cli.console import counted, holding, report, violations
from roadlang.cli.drive_lines import summary
from roadlang.diagnostics import Code, Source, diagnose
from roadlang.search.worker_pool import ALONE
from roadlang.session.expectations import Expectation
from roadlang.session.loading import loads

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
expect long: length(main) > 500m
expect short: length(main) < 20m
"""


def expectation(count: int, worst: float | None = -0.25) -> Expectation:
    return Expectation("near", "e < 1m", tuple(range(20)), tuple(range(count)), worst)


@pytest.mark.parametrize(
    ("count", "listed"),
    [(1, "(0)"), (8, "(0, 1, 2, 3, 4, 5, 6, 7)"), (9, "(0, 1, 2, 3, 4, 5, 6, 7, ...)")],
)
def test_the_first_eight_scenes_that_violate_are_listed(count: int, listed: str) -> None:
    (line,) = violations([expectation(count), expectation(0)])
    assert f"near: e < 1m, in {count} of 20 scenes {listed}" in line
    assert line.endswith("; least robustness -0.25")


def test_without_a_robustness_none_is_told() -> None:
    (line,) = violations([expectation(2, None)])
    assert line.endswith("(0, 1)")


@pytest.mark.parametrize(
    ("satisfied", "scenes", "text"),
    [(3, 4, "hold in 3 of 4 scenes"), (0, 1, "hold in 0 of 1 scene")],
)
def test_in_how_many_scenes_all_hold(satisfied: int, scenes: int, text: str) -> None:
    assert holding(satisfied, scenes).endswith(text)


def test_the_worst_scene_may_have_no_finite_robustness() -> None:
    """It violates what none of its samples is about."""
    rows = [
        {"scene": 0, "worst": "slow", "slow": -3.0, "slow satisfied": False, "worst time": 2.0},
        {"scene": 1, "worst": "late", "late": None, "late satisfied": False},
        {"scene": 2, "worst": "slow", "slow": 1.0, "slow satisfied": True},
    ]
    assert "1 of 3 scenes; worst: scene 1, late; " in summary(rows, [False, False, True])
    assert "1 of 2 scenes; worst: scene 0, slow -3 at 2.0 s; " in summary(
        [rows[0], rows[2]], [False, True]
    )


def test_a_scene_that_violates_two_expectations_counts_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run = Compilation(loads(TEXT), tmp_path / "out")
    assert run.check()
    run.compile(3, 0, ALONE)
    run.report()
    assert "; all expectations hold in 0 of 3 scenes" in capsys.readouterr().out
    assert run.exit_code == 4


def test_errors_and_warnings_are_counted_where_they_are_written(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Diagnostics and their count go to standard error; standard output is for results."""
    source = Source("a.rl", "param a = 3m\n")
    found = [diagnose(Code.UNUSED_LET, source.span(6, 7), name=name) for name in ("a", "b")]
    errors = [diagnose(Code.NOT_FINITE, source.span(6, 7), what=f"`{n}`") for n in range(3)]
    report([*found, *errors])
    out, err = capsys.readouterr()
    assert out == ""
    assert err.endswith("\n3 errors and 2 warnings\n")
    report(errors[:1])
    assert "1 error" not in capsys.readouterr().err


def test_one_of_a_kind_is_not_many() -> None:
    assert [counted(number, "scene") for number in (0, 1, 2_000)] == [
        "0 scenes", "1 scene", "2,000 scenes"
    ]  # fmt: skip
    assert holding(1, 1) == "all expectations hold in 1 of 1 scene"
