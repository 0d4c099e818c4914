"""One trace, and one sample at a time, beside RTAMT and scipy.

    OMP_NUM_THREADS=1 python -m benchmarks.stl.single_traces [rounds]

CPU times; what is compared is measured in turn, round after round, and the best of each counts, so
that other processes matter little. Needs RTAMT (`pip install rtamt`). Exit code 1 if a bar is
missed.
"""

from __future__ import annotations

import contextlib
import io
import sys
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from scipy.ndimage import minimum_filter1d

from benchmarks.stl.__main__ import FORMULAS, Report, rtamt_evaluator, walks
from roadlang import stl
from roadlang.diagnostics import DiagnosticError

SAMPLES, MILLION, PUSHED = 2_000, 1_000_000, 2_000
STREAMS = (
    "historically[0, 500] (e < 9)",
    "always[0, 500] (e < 9)",
    "(e < 10) since[0, 50] (d < 1)",
    "(e < 10) until[0, 50] (d < -1)",
    "historically (e < 12)",
    "once[0, 500] (min(e, d) > 1)",
)
"""The last one cannot be written for RTAMT."""


def main() -> int:
    """Run all measurements; 1 where a bar was missed."""
    rounds = int([*sys.argv[1:], "5"][0])
    report = Report()
    beside_discrete(report, rounds)
    beside_a_filter(report, rounds)
    explained(report)
    for text in STREAMS:
        beside_online(report, text, rounds)
    return 0 if report.met else 1


def seconds(work: Callable[[], object], times: int = 1) -> float:
    """CPU time of a call, the mean of several in a row."""
    start = time.process_time()
    for _ in range(times):
        work()
    return (time.process_time() - start) / times


def least(rounds: int, *works: Callable[[], float]) -> list[float]:
    """The least that each of several measurements gives, taken in turn."""
    return [
        min(found) for found in zip(*([w() for w in works] for _ in range(rounds)), strict=True)
    ]


def beside_discrete(report: Report, rounds: int) -> None:
    """The full robustness of one trace, RTAMT in discrete time beside it."""
    positions = np.arange(float(SAMPLES))
    signals = {name: values[0] for name, values in walks(1, SAMPLES).items()}
    row = {"time": positions.tolist(), **{key: x.tolist() for key, x in signals.items()}}
    for name in ("always[0,50]", "phi3"):
        formula = stl.parse(FORMULAS[name])
        evaluate = rtamt_evaluator(formula.to_rtamt())
        expected = [value for _, value in evaluate(row)]
        np.testing.assert_allclose(formula.robustness(positions, signals), expected, atol=1e-9)
        theirs, ours = least(
            rounds,
            partial(seconds, partial(evaluate, row)),
            partial(seconds, partial(formula.robustness, positions, signals), 50),
        )
        what = f"RTAMT over roadlang, one trace of 2,000, {name}"
        report.line(what, theirs / ours, "times", 60, least=True)


def beside_a_filter(report: Report, rounds: int) -> None:
    """A window over a trace of a million samples, and the sliding minimum of scipy."""
    positions, e = np.arange(float(MILLION)), walks(1, MILLION)["e"][0]
    formula = stl.parse(FORMULAS["always[0,50]"])
    ours, theirs = least(
        rounds,
        partial(seconds, partial(formula.robustness, positions, {"e": e})),
        partial(seconds, partial(minimum_filter1d, 10 - e, 51)),
    )
    report.line("always[0,50] on 1e6 over minimum_filter1d", ours / theirs, "times", 3)


def explained(report: Report) -> None:
    """Why a formula is violated, on a million rows."""
    positions = np.arange(float(MILLION))
    x = np.where(positions < MILLION / 2, 3 * np.sin(positions), 0.0)
    formula = stl.parse("always eventually (x > 2)")
    taken = seconds(partial(formula.explain, positions, {"x": x}))
    report.line("always eventually (x > 2), 1e6 rows, explained", taken, "s", 3)


def beside_online(report: Report, text: str, rounds: int) -> None:
    """Pushing one sample after the other, RTAMT online beside it where it can say the formula."""
    formula, e, d = stl.parse(text), *(x[0] for x in walks(1, PUSHED).values())
    rows = [(k, {"e": float(e[k]), "d": float(d[k])}) for k in range(PUSHED)]
    try:
        theirs = rtamt_monitor(formula.to_rtamt())
    except DiagnosticError:
        (ours,) = least(rounds, partial(_pushed, formula, rows))
        report.line(f"push, us, RTAMT refuses: {text}", ours * 1e6 / PUSHED, "us", np.inf)
        return
    mine, other = least(
        rounds, partial(_pushed, formula, rows), partial(_updated, theirs, rows[:500])
    )
    report.line(f"push over RTAMT online: {text}", mine / PUSHED / (other / 500), "times", 2)


def _pushed(formula: stl.Formula, rows: list[tuple[int, dict[str, float]]]) -> float:
    monitor = stl.StreamMonitor(formula)

    def push() -> None:
        for position, values in rows:
            monitor.push(position, values)

    return seconds(push)


def _updated(monitor: Callable[[], Any], rows: list[tuple[int, dict[str, float]]]) -> float:
    specification = monitor()

    def update() -> None:
        for position, values in rows:
            specification.update(position, list(values.items()))

    return seconds(update)


def rtamt_monitor(text: str) -> Callable[[], Any]:
    """Makes a new online monitor of RTAMT, over the signals `e` and `d`."""

    def make() -> Any:
        import rtamt

        specification = rtamt.StlDiscreteTimeOnlineSpecification()
        with contextlib.redirect_stdout(io.StringIO()):
            for name in "ed":
                specification.declare_var(name, "float")
            specification.spec = text
            specification.parse()
            specification.pastify()
        return specification

    return make


if __name__ == "__main__":
    sys.exit(main())
