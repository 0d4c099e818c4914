"""Random formulas on random traces: their texts, robustness, ranges, causes and plots, in lines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from roadlang import DiagnosticError, stl
from roadlang.stl.explain.plot import plot_svg
from roadlang.stl.formats.rtamt import to_rtamt
from tests.golden.summaries import array, of_svg, runs
from tests.stl_draws import NAMES, FormulaDraw


def _value(value: object) -> str:
    return array(np.atleast_1d(np.asarray(value, dtype=float)).ravel().tolist())


def formula_lines(first: int, count: int, *, contextual: bool = False) -> Iterator[str]:
    """`count` formulas from the seed `first` on."""
    rng = np.random.default_rng(first)
    for seed in range(first, first + count):
        draw = FormulaDraw(seed, past=seed % 3 > 0, divisions=seed % 4 == 0, contextual=contextual)
        formula = draw.formula(1 + seed % 3)
        size = int(rng.integers(2, 40))
        positions = np.cumsum(rng.choice([0.5, 0.5, 1.0], size)) - 0.5
        signals = {name: np.round(rng.normal(0.0, 2.0, (3, size)), 1) for name in NAMES}
        one = {name: values[0] for name, values in signals.items()}
        yield f"{seed}: {formula}"
        yield f"  normal {stl.normal_form(formula)}"
        yield f"  json {stl.to_json(formula)}"
        try:
            yield f"  rtamt {to_rtamt(formula)}"
        except DiagnosticError as fault:
            yield f"  {fault}".replace("\n", " / ")
        try:
            yield f"  robustness {_value(formula.robustness(positions, signals))}"
            yield f"  rho {_value(formula.rho(positions, signals))}"
            yield f"  holds {_value(formula.satisfied(positions, signals))}"
            yield f"  explained {formula.explain(positions, one)}".replace("\n", " / ")
            yield f"  range {[_value(end) for end in formula.range(positions, signals)]}"
            yield f"  verdict {formula.verdict(positions, signals)}"
            yield f"  {formula.temporal} {sorted(formula.variables)}"
            yield f"  smooth {_value(stl.smooth_rho(formula, positions, one, sharpness=5.0)[0])}"
        except DiagnosticError as fault:
            yield f"  {fault}".replace("\n", " / ")


def online_lines(first: int, count: int) -> Iterator[str]:
    """Formulas that are monitored sample by sample, and over bounds of what is not seen yet."""
    rng = np.random.default_rng(first)
    for seed in range(first, first + count):
        formula = FormulaDraw(seed, bounded=True, contextual=False).formula(1 + seed % 2)
        yield f"{seed}: {formula}"
        monitor = stl.OnlineMonitor(formula)
        said: list[float] = []
        verdicts = []
        for sample in range(14):
            values = {name: float(np.round(rng.normal(0.0, 2.0), 1)) for name in NAMES}
            said += monitor.push(0.5 * sample, values)
            verdicts.append(monitor.verdict)
        yield f"  {_value(said)} {' '.join(runs(verdicts))}"


def range_lines(first: int, count: int) -> Iterator[str]:
    """Deeper formulas: what later samples may make of them, and slopes of their smooth values."""
    rng = np.random.default_rng(first)
    for seed in range(first, first + count):
        formula = FormulaDraw(seed, past=seed % 5 > 0, contextual=False).formula(2 + seed % 2)
        size = int(rng.integers(3, 20))
        positions = np.cumsum(rng.choice([0.5, 0.5, 1.0], size)) - 0.5
        signals = {name: np.round(rng.normal(0.0, 2.0, size), 1) for name in NAMES}
        yield f"{seed}: {formula}"
        try:
            yield f"  range {[_value(end) for end in formula.range(positions, signals)]}"
            value, slopes = stl.smooth_rho(formula, positions, signals, sharpness=3.0)
            yield f"  smooth {_value(value)} {[_value(slopes[name]) for name in sorted(slopes)]}"
        except DiagnosticError as fault:
            yield f"  {fault}".replace("\n", " / ")


_MINED = (
    ("always (x < high)", {"high": (-9.0, 9.0)}),
    ("always (x > low)", {"low": (-9.0, 9.0)}),
    ("always (x > low and x < high)", {"low": (-9.0, 0.0), "high": (0.0, 9.0)}),
    ("eventually[0, tau] (y > level)", {"tau": (0.0, 25.0), "level": (-3.0, 3.0)}),
    ("always (x > 2 implies eventually[0, tau] (y < 0))", {"tau": (0.0, 25.0)}),
    ("always[tau, 20] (z < 1.5)", {"tau": (0.0, 19.0)}),
    ("always (abs(x - level) > 0.5)", {"level": (-4.0, 4.0)}),
    ("always (x < high)", {"high": (-9.0, 0.0)}),
)


def mining_lines() -> Iterator[str]:
    """Formulas with parameters, and the tightest of these."""
    positions = np.arange(0.0, 30.0, 0.5)
    recordings = [
        (
            positions,
            {"x": 3.0 * np.sin(positions / a), "y": np.cos(positions / b), "z": positions / 20},
        )
        for a, b in ((4.0, 3.0), (5.5, 2.0))
    ]
    ways: tuple[dict[str, Any], ...] = (
        {},
        {"margin": 0.25},
        {"digits": 3},
        {"unknown_holds": True},
    )
    for text, bounds in _MINED:
        parameters = [stl.Parameter(name, *ends) for name, ends in bounds.items()]
        for options in ways:
            yield f"{text} {options}"
            try:
                yield f"  {stl.mine(text, parameters, recordings, **options)}"
                if len(parameters) > 1 and not options:
                    for point in stl.mine_front(text, parameters, recordings, points=4, **options):
                        yield f"  front {point}"
            except DiagnosticError as fault:
                yield f"  {fault}".replace("\n", " / ")


def plot_lines() -> Iterator[str]:
    """The plot of a formula on a trace."""
    formula = stl.parse("always (abs(x) < 3 or eventually[0, 4] (y > 1)) and once (z < 2)")
    positions = np.arange(0.0, 30.0, 0.5)
    signals = {
        "x": 4.0 * np.sin(positions / 4),
        "y": np.cos(positions / 3),
        "z": 0.1 * positions,
    }
    yield from of_svg(plot_svg(formula, positions, signals))
