"""Speed and memory of STL monitoring, measured against a numpy copy and against RTAMT.

    OMP_NUM_THREADS=1 python -m benchmarks.stl [--rtamt]

CPU times, the best of several runs; a factor is relative to copying one signal of the batch into
an array that is already there, in the same run. Exit code 1 if a bar is missed.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import sys
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from roadlang import stl

VARIANTS, SAMPLES = 10_000, 500
FORMULAS = {
    "always": "always (e < 10)",
    "always[0,50]": "always[0, 50] (e < 10)",
    "phi3": "always (e > 10 implies eventually[5, 20] always[0, 30] (d < 10 and e < 10))",
    "until[2,30]": "(e < 10) until[2, 30] (d < 5)",
}
START_BARS = {"always": 3.0, "phi3": 30.0, "until[2,30]": 15.0}
TRACE_BARS = {"phi3": 45.0, "until[2,30]": 80.0}
Floats = NDArray[np.float64]


@dataclass
class Report:
    """Prints one line per measurement and remembers whether all bars were met."""

    met: bool = True

    def line(self, what: str, value: float, unit: str, bar: float, *, least: bool = False) -> None:
        """Print one measurement beside its bar, and remember whether it was met."""
        good = value >= bar if least else value <= bar
        self.met &= good
        sign = ">=" if least else "<="
        print(
            f"{what:44s} {value:10.2f} {unit:8s} bar {sign} {bar:g}  {'met' if good else 'MISSED'}"
        )


def main() -> int:
    """Run all measurements; 1 where a bar was missed."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--rtamt", action="store_true", help="compare with RTAMT (minutes)")
    arguments = options.parse_args()
    positions = np.arange(float(SAMPLES))
    signals = walks(VARIANTS, SAMPLES)
    report = Report()
    against_a_copy(report, positions, signals)
    window_independence(report, positions, signals)
    memory(report, positions, signals)
    parsing(report)
    long_traces()
    if arguments.rtamt:
        against_rtamt(report, positions, signals)
    return 0 if report.met else 1


def walks(variants: int, samples: int) -> dict[str, Floats]:
    """Two signals of random walks, which go above and below the thresholds of the formulas."""
    rng = np.random.default_rng(1)
    return {name: np.abs(np.cumsum(rng.normal(0, 1, (variants, samples)), axis=1)) for name in "ed"}


def cpu_seconds(work: Callable[[], object], runs: int = 7) -> float:
    """The best CPU time of several runs, after one to warm up."""
    work()
    times = []
    for _ in range(runs):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def against_a_copy(report: Report, positions: Floats, signals: dict[str, Floats]) -> None:
    """Evaluation time as a multiple of copying one signal."""
    target = np.empty_like(signals["e"])
    copy = cpu_seconds(lambda: np.copyto(target, signals["e"]))
    print(f"one copy of {VARIANTS} x {SAMPLES}: {copy * 1e3:.2f} ms")
    for name, text in FORMULAS.items():
        formula = stl.parse(text)
        start = cpu_seconds(partial(formula.rho, positions, signals)) / copy
        trace = cpu_seconds(partial(formula.robustness, positions, signals), 3) / copy
        report.line(f"{name} at start", start, "copies", START_BARS.get(name, np.inf))
        report.line(f"{name} full trace", trace, "copies", TRACE_BARS.get(name, np.inf))


def window_independence(report: Report, positions: Floats, signals: dict[str, Floats]) -> None:
    """Evaluation time must not grow with the window."""
    for text in ("always[0, {}] (e < 10)", "(e < 10) until[2, {}] (d < 5)"):
        times = []
        for width in (5, 500):
            formula = stl.parse(text.format(width))
            times.append(cpu_seconds(partial(formula.robustness, positions, signals), 3))
        report.line(f"w = 500 against w = 5: {text}", times[1] / times[0], "times", 2.5)


def memory(report: Report, positions: Floats, signals: dict[str, Floats]) -> None:
    """Peak memory as a multiple of one signal."""
    for name, text in FORMULAS.items():
        formula = stl.parse(text)
        for method in (formula.rho, formula.robustness):
            method(positions, signals)
            tracemalloc.start()
            method(positions, signals)
            peak = tracemalloc.get_traced_memory()[1] / signals["e"].nbytes
            tracemalloc.stop()
            report.line(f"peak memory, {name}, {method.__name__}", peak, "signals", 1.2)


def parsing(report: Report) -> None:
    """Time to parse each formula."""
    stl.parse("true")
    for name, text in FORMULAS.items():
        taken = cpu_seconds(partial(stl.parse, text)) * 1e3
        report.line(f"parse {name}", taken, "ms", 5.0)


def long_traces() -> None:
    """One trace of a million samples, full robustness trace, million samples a second."""
    positions = np.arange(1e6)
    signals = {name: values[0] for name, values in walks(1, 1_000_000).items()}
    for name, text in FORMULAS.items():
        formula = stl.parse(text)
        taken = cpu_seconds(partial(formula.robustness, positions, signals), 2)
        print(f"{name + ', one trace of 1e6 samples':44s} {1 / taken:10.2f} MS/s")


def against_rtamt(report: Report, positions: Floats, signals: dict[str, Floats]) -> None:
    """RTAMT takes one trace at a time: some of them, scaled to all; its parsing is left out."""
    for name, count in (("always[0,50]", 20), ("phi3", 10), ("until[2,30]", 2)):
        formula = stl.parse(FORMULAS[name])
        evaluate = rtamt_evaluator(formula.to_rtamt())
        rows = [
            {
                "time": positions.tolist(),
                **{key: values[k].tolist() for key, values in signals.items()},
            }
            for k in range(count)
        ]
        theirs = cpu_seconds(partial(_evaluate_all, evaluate, rows), 1) / count * VARIANTS
        ours = cpu_seconds(partial(formula.robustness, positions, signals), 3)
        expected = [value for _, value in evaluate(rows[0])]
        own = formula.robustness(positions, {key: values[0] for key, values in signals.items()})
        np.testing.assert_allclose(own, expected, atol=1e-9)
        report.line(
            f"RTAMT over roadlang, full trace, {name}", theirs / ours, "times", 200, least=True
        )


def _evaluate_all(
    evaluate: Callable[[dict[str, list[float]]], object], rows: list[dict[str, list[float]]]
) -> list[object]:
    return [evaluate(row) for row in rows]


def rtamt_evaluator(text: str) -> Callable[[dict[str, list[float]]], list[tuple[float, float]]]:
    """RTAMT's evaluation of a formula over the signals `e` and `d`."""
    import rtamt

    specification = rtamt.StlDiscreteTimeSpecification()
    with contextlib.redirect_stdout(io.StringIO()):
        for name in "ed":
            specification.declare_var(name, "float")
        specification.spec = text
        specification.parse()
    return lambda row: specification.evaluate({key: list(values) for key, values in row.items()})


if __name__ == "__main__":
    sys.exit(main())
