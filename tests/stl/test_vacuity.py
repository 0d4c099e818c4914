"""Verdicts that hang on a window between two samples are vacuous, and nothing else is."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.cli.main import main
from roadlang.stl.evaluate.measured_robustness import measured_rho, satisfied_by
from roadlang.stl.formula.evaluation_options import EvaluationOptions
from roadlang.stl.formula.formulas import Compound, Measured
from tests.stl_draws import FormulaDraw, draw_trace

SECONDS = np.arange(5.0)
X = {"x": np.array([0.0, 9, 9, 9, 9])}


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("always[0.2, 0.8] (x < 0)", "vacuous"),
        ("eventually[0.2, 0.8] (x > 0)", "vacuous"),
        ("(x < 1) until[0.2, 0.8] (x > 0)", "vacuous"),
        ("x < 1 and always[0.2, 0.8] (x < 0)", "vacuous"),
        ("x > 1 and always[0.2, 0.8] (x < 0)", "violated"),
        ("x < 1 or eventually[0.2, 0.8] (x > 0)", "satisfied"),
        ("x > 1 implies eventually[0.2, 0.8] (x > 0)", "satisfied"),
        ("eventually[0, 3] always[0.2, 0.8] (x < 0)", "vacuous"),
        ("always[0.2, 1.2] (x < 0)", "violated"),
        ("always[7, 7.5] (x < 0)", "unknown"),
        ("always[4.2, 4.7] (x < 0)", "unknown"),
        ("always[0, 4] once[0, 0.5] (x < 10)", "satisfied"),
        ("always[0, 4] historically[0.2, 0.8] (x < -1)", "vacuous"),
        ("always[0, 4] historically[1, 2] (x < 10)", "satisfied"),
        ("eventually[0, 0] once[1, 2] (x < 10)", "violated"),
    ],
)
def test_a_verdict_is_vacuous_if_an_empty_window_decides_it(text: str, verdict: str) -> None:
    assert stl.parse(text).verdict(SECONDS, X) == verdict


@pytest.mark.parametrize("seed", range(60))
def test_windows_that_reach_the_next_sample_are_never_vacuous(seed: int) -> None:
    formula = FormulaDraw(seed, corners=False).formula(1 + seed % 3)
    widest = 2.5
    formula = _widened(formula, widest)
    positions, signals = draw_trace(seed, 9, 3, even=seed % 2 == 0)

    verdicts = formula.verdict(positions, signals)

    assert set(np.asarray(verdicts).tolist()) <= {"satisfied", "violated", "unknown"}


def test_each_variant_of_a_batch_has_its_own_verdict() -> None:
    formula = stl.parse("x > 1 and always[0.2, 0.8] (x < 0)")

    verdicts = formula.verdict(SECONDS, {"x": np.array([[0.0] * 5, [2.0] * 5])})

    assert list(verdicts) == ["violated", "vacuous"]


def test_closed_roads_have_no_sample_between_the_last_and_the_first_either() -> None:
    formula = stl.parse("always[0.2, 0.8] (x < 0)")

    assert formula.verdict(SECONDS, X, wrap=5.0) == "vacuous"
    assert stl.parse("always[0.2, 1.2] (x < 10)").verdict(SECONDS, X, wrap=5.0) == "satisfied"
    assert stl.parse("always[0, 5] eventually[0.5, 1.6] (x < 10)").verdict(
        SECONDS, X, wrap=6.9
    ) == ("vacuous")


def test_an_online_monitor_knows_vacuous_verdicts() -> None:
    monitor = stl.OnlineMonitor(stl.parse("always[0.2, 0.8] (x < 0)"))
    monitor.push(0.0, {"x": 0.0})
    first = monitor.verdict
    monitor.push(1.0, {"x": 9.0})
    assert (first, monitor.verdict) == ("unknown", "vacuous")


@pytest.mark.parametrize(("options", "code"), [([], 0), (["--strict"], 4)])
def test_monitor_warns_of_a_vacuous_verdict_and_strict_fails_it(
    options: list[str], code: int, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "steps.csv").write_text("t,x\n0,0\n1,9\n2,9\n")

    with pytest.raises(SystemExit) as ended:
        main(["monitor", "always[0.2, 0.8] (x < 0)", str(tmp_path / "steps.csv"), *options])

    printed = capfd.readouterr()
    assert ended.value.code == code
    assert "steps.csv  vacuous  inf" in printed.out
    assert (
        "warning[RL308]: a window of `always[0.2, 0.8] (x < 0)` falls between two samples"
        in printed.err
    )


def _widened(formula: stl.Formula, least: float) -> stl.Formula:
    """The same formula, whose intervals are at least this long."""
    if isinstance(formula, stl.Comparison | stl.Truth):
        return formula
    parts = [_widened(part, least) for part in formula.parts]
    assert isinstance(formula, Compound)
    window = formula.window
    if window is not None:
        window = stl.Interval(window.lo, max(window.hi, window.lo + least))
    if isinstance(formula, Measured):
        (operand,) = parts
        return replace(formula, operand=operand, interval=window)
    widened: stl.Formula = type(formula).of(parts, window)
    return widened


@pytest.mark.parametrize(
    ("text", "open_", "finished"),
    [
        ("always (x < 10)", "unknown", "satisfied"),
        ("eventually (x > 10)", "unknown", "violated"),
        ("always (x > 5 implies eventually[1, 2] (x < 10))", "unknown", "violated"),
        ("next next next next next (x > 0)", "unknown", "violated"),
        ("always (x < 9)", "violated", "violated"),
        # Where no sample is looked at:
        ("always[7, 7.5] (x < 0)", "unknown", "vacuous"),
        ("not eventually[7, 9] (x < 0)", "unknown", "vacuous"),
        ("eventually[3.2, 4] always[0.5, 1] (x < 0)", "unknown", "vacuous"),
        ("count[10, 20] (x > 0) < 1", "unknown", "vacuous"),
        ("x < 1 or always[7, 8] (x < 0)", "satisfied", "satisfied"),
        ("(x < 0) until[10, 20] (x > 0)", "violated", "violated"),
        ("(x > 10) release[10, 20] (x > 0)", "unknown", "vacuous"),
        ("always[0.2, 0.8] (x < 0)", "vacuous", "vacuous"),
        ("always[0.2, 0.8] (x < 0) and always[7, 8] (x < 0)", "unknown", "vacuous"),
        ("eventually[0, 0] once[1, 2] (x < 10)", "violated", "violated"),
    ],
)
def test_a_finished_trace_has_a_verdict(text: str, open_: str, finished: str) -> None:
    formula = stl.parse(text)

    assert formula.verdict(SECONDS, X) == open_
    assert formula.verdict(SECONDS, X, finished=True) == finished
    assert formula.explain(SECONDS, X, finished=True).verdict == finished


@pytest.mark.parametrize("semantics", ["held", "linear"])
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("always (x <= 9)", "satisfied"),
        ("eventually (x > 9)", "violated"),
        ("always[0.2, 0.8] (x < 10)", "satisfied"),
        ("always[7, 8] (x < 0)", "vacuous"),
        ("x < 0 and always[7, 8] (x < 0)", "violated"),
    ],
)
def test_a_finished_trace_that_is_known_between_samples(
    text: str, verdict: str, semantics: Any
) -> None:
    formula = stl.parse(text)
    found = formula.explain(SECONDS, X, semantics=semantics, finished=True)
    assert formula.verdict(SECONDS, X, semantics=semantics, finished=True) == verdict
    assert (found.verdict, bool(found.beyond_end)) == (verdict, "[7, 8]" in text)


@pytest.mark.parametrize("seed", range(20))
def test_strict_options_fail_vacuous_verdicts_and_no_others(seed: int) -> None:
    formula = FormulaDraw(seed, corners=seed % 2 == 0).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 7, 3, even=seed % 3 == 0)
    strict, plain = EvaluationOptions(strict=True), EvaluationOptions()

    vacuous = np.equal(formula.verdict(positions, signals, finished=True), "vacuous")
    holds = satisfied_by(formula, positions, signals, plain)
    rho = measured_rho(formula, positions, signals, plain)

    np.testing.assert_array_equal(
        satisfied_by(formula, positions, signals, strict), holds & ~vacuous
    )
    np.testing.assert_array_equal(
        measured_rho(formula, positions, signals, strict), np.where(vacuous, -np.inf, rho)
    )


@pytest.mark.parametrize("seed", range(36))
def test_what_no_continuation_changes_is_the_verdict_of_the_finished_trace(seed: int) -> None:
    formula = FormulaDraw(seed, corners=seed % 2 == 0).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 7, 3, even=seed % 3 == 0)

    found = np.atleast_1d(formula.verdict(positions, signals, finished=True))
    truth = np.atleast_1d(formula.satisfied(positions, signals))
    open_ = np.atleast_1d(formula.verdict(positions, signals))

    decided = found != "vacuous"
    assert (found != "unknown").all()
    assert ((found == "satisfied") == truth)[decided].all()
    certain = np.isin(open_, ("satisfied", "violated"))
    assert (found == open_)[certain].all()
