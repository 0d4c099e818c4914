"""The engine gives what the definitions give, on every kind of formula and trace."""

from __future__ import annotations

import numpy as np
import pytest

from tests.stl_draws import FormulaDraw, draw_trace
from tests.stl_reference import Reference


@pytest.mark.parametrize("seed", range(80))
def test_traces_equal_the_definitions(seed: int) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 3)
    samples = (1, 2, 7, 12, 17)[seed % 5]
    positions, signals = draw_trace(seed, samples, 2, even=seed % 2 == 0)

    trace = formula.robustness(positions, signals)
    start = formula.rho(positions, signals)
    satisfied = formula.satisfied(positions, signals)

    for variant in range(2):
        row = {name: values[variant] for name, values in signals.items()}
        reference = Reference(positions, row)
        np.testing.assert_allclose(trace[variant], reference.rho(formula), atol=1e-9)
        assert satisfied[variant] == reference.satisfied(formula)[0]
    np.testing.assert_array_equal(start, trace[:, 0])


@pytest.mark.parametrize("seed", range(60))
def test_infinite_signals_and_divisions_by_zero_have_the_values_of_the_definitions(
    seed: int,
) -> None:
    formula = FormulaDraw(seed, divisions=True).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, (1, 2, 7, 12)[seed % 4], 2, even=True)
    rng = np.random.default_rng(seed)
    for values in signals.values() if seed % 2 else ():
        values[rng.random(values.shape) < 0.2] = rng.choice([np.inf, -np.inf])
    signals["z"][rng.random(signals["z"].shape) < 0.3] = rng.choice([0.0, -0.0])

    trace = formula.robustness(positions, signals)
    truth = formula.truth(positions, signals)

    for variant in range(2):
        row = {name: values[variant] for name, values in signals.items()}
        reference = Reference(positions, row)
        np.testing.assert_allclose(trace[variant], reference.rho(formula), atol=1e-9)
        assert truth[variant].tolist() == reference.satisfied(formula)
    lo, hi = formula.range(positions, signals)
    assert (lo <= trace[:, 0]).all()
    assert (trace[:, 0] <= hi).all()


@pytest.mark.parametrize("seed", range(50))
def test_windows_wrap_on_closed_roads(seed: int) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 2)
    positions, signals = draw_trace(seed, (1, 2, 7, 9)[seed % 4], 1, even=seed % 2 == 0)
    row = {name: values[0] for name, values in signals.items()}
    wrap = float(positions[-1] - positions[0]) + 0.5

    trace = formula.robustness(positions, row, wrap=wrap)

    expected = np.array(Reference(positions, row, wrap).rho(formula))
    np.testing.assert_allclose(trace, expected, atol=1e-9)
