"""The origin and the step of the clock do not matter to windows."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from tests.stl_draws import FormulaDraw, draw_trace
from tests.stl_reference import Reference

EPOCH = 1_700_000_000.0


@pytest.mark.parametrize("origin", [0.0, 1e3, -1e6, 2.0**27, EPOCH, -(2.0**40)])
@pytest.mark.parametrize("seed", range(20))
def test_the_origin_of_the_clock_changes_nothing(seed: int, origin: float) -> None:
    """Steps are multiples of 1/8, so that positions are exact at every origin."""
    formula = FormulaDraw(seed).formula(1 + seed % 3)
    _, signals = draw_trace(seed, 17, 2, even=True)
    rng = np.random.default_rng(seed)
    positions = np.cumsum(rng.choice([0.125, 0.25, 0.5, 0.5, 2.0], size=17))

    np.testing.assert_array_equal(
        formula.robustness(origin + positions, signals), formula.robustness(positions, signals)
    )
    np.testing.assert_array_equal(
        formula.range(origin + positions, signals), formula.range(positions, signals)
    )


@pytest.mark.parametrize(("unit", "origin"), [(1e3, EPOCH * 1e3), (1e9, EPOCH * 1e9), (1e-10, 0)])
@pytest.mark.parametrize("seed", range(20))
def test_the_unit_of_the_clock_changes_nothing(seed: int, unit: float, origin: float) -> None:
    draw = FormulaDraw(seed)
    formula = draw.formula(1 + seed % 3)
    draw = FormulaDraw(seed)
    draw.step *= unit
    scaled = draw.formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 12, 1, even=True)

    np.testing.assert_array_equal(
        scaled.robustness(origin + (positions - 3) * unit, signals),
        formula.robustness(positions, signals),
    )


def test_half_a_second_at_ten_hertz_is_six_samples_since_1970() -> None:
    e = np.zeros(100)
    e[12] = 9
    stamps = EPOCH + np.arange(100) * 0.1
    formula = stl.parse("always[0, 0.5] (e < 5)")

    assert formula.rho(stamps, {"e": e}) == 5
    assert np.flatnonzero(formula.robustness(stamps, {"e": e}) < 0).tolist() == list(range(7, 13))
    assert stl.parse("eventually[0.1, 0.2] (e > 5)").rho(stamps, {"e": e}) == -5


def test_a_clock_that_adds_up_its_steps_still_meets_its_windows() -> None:
    stamps = np.cumsum(np.full(200_000, 0.1))
    x = np.zeros(stamps.size)
    x[-1] = 1.0

    trace = stl.parse("eventually[50, 50] (x > 0)").robustness(stamps, {"x": x})

    assert np.isfinite(trace[:-500]).all()
    assert np.flatnonzero(trace == 1).tolist() == [stamps.size - 501]


def test_steps_below_a_nanosecond_are_told_apart() -> None:
    stamps = np.arange(100) * 1e-10
    x = (np.arange(100) == 7).astype(float)

    assert stl.parse("eventually[0, 5e-10] (x > 0.5)").rho(stamps, {"x": x}) == -0.5
    assert stl.parse("eventually[0, 7e-10] (x > 0.5)").rho(stamps, {"x": x}) == 0.5


@pytest.mark.parametrize("seed", range(60))
def test_traces_since_1970_equal_the_definitions(seed: int) -> None:
    formula = FormulaDraw(seed, corners=False).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 9, 1, even=seed % 2 == 0)
    row = {name: values[0] for name, values in signals.items()}

    np.testing.assert_allclose(
        formula.robustness(EPOCH + positions, row),
        Reference(positions, row).rho(formula),
        atol=1e-9,
    )


def test_large_positions_are_written_out() -> None:
    stamps = EPOCH + np.arange(30) * 0.1
    x = np.where(np.arange(30) == 12, 9.0, 0.0)

    lines = stl.parse("always (x < 5)").explain(stamps, {"x": x}).lines()

    assert lines[1] == "decided at 1700000001.2: x < 5, where x = 9"
    assert lines[2] == "from 1700000001.2 to 1700000001.2 not x < 5, worst -4 at 1700000001.2"
    with pytest.raises(DiagnosticError, match=r"1700000000\.1 is followed by 1700000000"):
        stl.parse("x > 0").rho([EPOCH + 0.1, EPOCH], {"x": [1.0, 1.0]})
