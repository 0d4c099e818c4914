"""Smooth robustness goes to robustness as it sharpens, and its gradient is its derivative."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from tests.stl_draws import FormulaDraw, draw_trace


def _case(seed: Any) -> Any:
    formula = FormulaDraw(seed).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 9, 1, even=seed % 2 == 0)
    rng = np.random.default_rng(seed)
    row = {name: values[0] + rng.normal(0, 0.1, 9) for name, values in signals.items()}
    return formula, positions, row


@pytest.mark.parametrize("seed", range(50))
@pytest.mark.parametrize("wrap", [None, 30.0])
def test_sharp_is_exact(seed: int, wrap: float | None) -> None:
    formula, positions, row = _case(seed)
    exact = formula.rho(positions, row, wrap=wrap)
    smooth = stl.smooth_rho(formula, positions, row, sharpness=1e7, wrap=wrap).rho
    assert smooth == pytest.approx(exact, abs=1e-4)


@pytest.mark.parametrize("seed", range(36))
def test_gradients_are_derivatives(seed: int) -> None:
    formula, positions, row = _case(seed)
    found = stl.smooth_rho(formula, positions, row, sharpness=3.0)
    if not np.isfinite(found.rho):
        return
    for name, gradient in found.gradient.items():
        for sample in range(0, 9, 2):
            ends = []
            for move in (1e-6, -1e-6):
                moved = {**row, name: row[name] + move * (np.arange(9) == sample)}
                ends.append(stl.smooth_rho(formula, positions, moved, sharpness=3.0).rho)
            assert gradient[sample] == pytest.approx((ends[0] - ends[1]) / 2e-6, abs=1e-4)


def test_one_number_has_one_derivative() -> None:
    formula = stl.parse("always (x < limit)")
    found = stl.smooth_rho(formula, [0, 1, 2], {"x": [1.0, 2.0, 3.0], "limit": 4.0})
    assert found.gradient["limit"].tolist() == pytest.approx([1.0])
    assert found.gradient["x"].sum() == pytest.approx(-1.0)


def test_what_has_no_rule_is_refused() -> None:
    with pytest.raises(DiagnosticError, match="RL343"):
        stl.smooth_rho(stl.parse("x ^ 2 < 4"), [0], {"x": [1.0]})


def test_a_batch_has_the_gradients_of_its_rows() -> None:
    rng = np.random.default_rng(2)
    signals = {"x": rng.normal(0, 1, (3, 7)), "limit": rng.normal(1, 0.1, 7)}
    formula = stl.parse("always[0, 3] (x < limit) or eventually (x > 1)")
    batch = stl.smooth_rho(formula, np.arange(7), signals)
    assert batch.rho.shape == (3,)
    for row in range(3):
        alone = stl.smooth_rho(formula, np.arange(7), {**signals, "x": signals["x"][row]})
        assert batch.rho[row] == alone.rho
        for name in signals:
            np.testing.assert_array_equal(batch.gradient[name][row], alone.gradient[name])
