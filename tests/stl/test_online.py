"""An online monitor says after each sample what the whole prefix says, and forgets what it may."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from tests.stl_draws import FormulaDraw, draw_trace


def _compare(formula: Any, positions: Any, row: Any, every: int = 1) -> None:
    monitor = stl.OnlineMonitor(formula)
    for k, position in enumerate(positions):
        lo, hi = monitor.push(position, {name: values[k] for name, values in row.items()})
        if k % every == 0:
            prefix = {name: values[: k + 1] for name, values in row.items()}
            assert (lo, hi) == pytest.approx(formula.range(positions[: k + 1], prefix), abs=1e-12)
            assert monitor.verdict == formula.verdict(positions[: k + 1], prefix)


@pytest.mark.parametrize("seed", range(15))
def test_each_step_equals_the_range_of_the_prefix(seed: int) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 2)
    positions, signals = draw_trace(seed, 9, 1, even=seed % 2 == 0)
    _compare(formula, positions, {name: values[0] for name, values in signals.items()})


@pytest.mark.parametrize(
    "text",
    [
        "always (x < 4)",
        "always (y <= 6)",
        "eventually (y > 5 and eventually[1, 3] (x < -1))",
        "always (x > 2 implies eventually[0, 4] always[0, 1] (z < 5))",
        "eventually always (x > -9)",
        "always (once[0, 3] (x > 0) or y < 5)",
        "always (y > 3 implies once[1, 2] (x > -6))",
        "eventually (historically[0, 2] (x > 1) and eventually[0, 1] once[0, 4] (z > 2))",
        "always (count[0, 3] (x > 0) >= 1 or (y < 2) since[0, 2] (x > 3))",
    ],
)
def test_folding_the_past_changes_nothing(text: str) -> None:
    positions, signals = draw_trace(7, 260, 1, even=True)
    row = {name: values[0] for name, values in signals.items()}
    _compare(stl.parse(text), positions, row, every=53)


@pytest.mark.parametrize("inner", ["eventually[0, 2]", "once[0, 2]", "eventually[0, 1] once[0, 1]"])
def test_a_step_costs_what_the_formula_looks_at_not_the_past(inner: str) -> None:
    monitor = stl.OnlineMonitor(stl.parse(f"always (x < 4 or {inner} (x < 3))"))
    for k in range(300):
        monitor.push(0.1 * k, {"x": np.sin(k)})
    assert len(monitor._positions) < 200


def test_a_wrong_sample_is_refused_and_forgotten() -> None:
    monitor = stl.OnlineMonitor(stl.parse("always (x < 4)"))
    monitor.push(0, {"x": 1})
    wrong: list[tuple[float, dict[str, float]]]
    wrong = [(0, {"x": 1}), (1, {"x": float("nan")}), (1, {"y": 1})]
    for position, values in wrong:
        with pytest.raises(DiagnosticError):
            monitor.push(position, values)
    assert monitor.push(1, {"x": 2}) == (-np.inf, 2)
