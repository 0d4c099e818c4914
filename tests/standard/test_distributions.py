"""Random values by inversion: the right shares, the ends kept, every level of a grid a value."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.diagnostics import DiagnosticError
from roadlang_standard.distribution_choice import Choice
from roadlang_standard.distribution_integer import UniformInteger
from roadlang_standard.distribution_normal import Normal
from roadlang_standard.distribution_uniform import Uniform

EVEN = ((np.arange(20_000) + 0.5) / 20_000)[:, None]
ENDS = np.array([[0.0], [1.0 - 2.0**-53]])


def test_uniform_keeps_its_ends() -> None:
    low, high = Uniform(2.0, 5.0).quantile(ENDS)[:, 0]
    assert low == 2.0
    assert high == pytest.approx(5.0)
    assert Uniform(2.0, 5.0).quantile(EVEN).mean() == pytest.approx(3.5)


def test_bounds_may_be_drawn_themselves() -> None:
    high: Any = np.linspace(1, 2, 20_000)[:, None]  # a column, as batches have it
    assert (Uniform(0.0, high).quantile(EVEN) <= high).all()


@given(
    mean=st.floats(-50, 50), sd=st.floats(0.01, 20), low=st.floats(-60, 60), size=st.floats(0.1, 50)
)
def test_a_cut_normal_is_a_cut_normal(mean: float, sd: float, low: float, size: float) -> None:
    values = Normal(mean, sd, (low, low + size)).quantile(EVEN[::100])[:, 0]
    assert (values >= low).all()
    assert (values <= low + size).all()
    assert (np.diff(values) >= 0).all()
    a, b = (low - mean) / sd, (low + size - mean) / sd
    if max(abs(a), abs(b)) < 6:
        from scipy.stats import truncnorm  # takes a second: not in every worker

        truth = truncnorm(a, b, mean, sd).ppf(EVEN[::100, 0])
        np.testing.assert_allclose(values, truth, atol=1e-6 * (abs(mean) + sd + 1))


def test_a_normal_without_ends_is_normal() -> None:
    values = Normal(3.0, 2.0).quantile(EVEN)
    assert values.mean() == pytest.approx(3.0, abs=1e-3)
    assert values.std() == pytest.approx(2.0, rel=1e-2)


def test_a_normal_without_width_is_its_mean() -> None:
    assert (Normal(3.0, 0.0).quantile(EVEN) == 3.0).all()


def test_choice_follows_its_weights() -> None:
    words = Choice(("car", "truck"), (3.0, 1.0)).quantile(EVEN)
    assert (words == "car").mean() == pytest.approx(0.75)
    numbers = Choice((8.0, 12.0, 16.0)).quantile(EVEN)
    assert numbers.dtype == float
    for value in (8.0, 12.0, 16.0):
        assert (numbers == value).mean() == pytest.approx(1 / 3, abs=1e-3)


def test_choice_among_drawn_values_takes_each_of_its_variant() -> None:
    column = np.arange(20_000.0)[:, None]
    chosen = Choice((column, -1.0)).quantile(EVEN)
    assert (chosen[:10_000] == column[:10_000]).all()
    assert (chosen[10_000:] == -1.0).all()


def test_an_integer_is_whole_and_both_ends_are_in() -> None:
    values, counts = np.unique(UniformInteger(0, 3).quantile(EVEN), return_counts=True)
    assert values.tolist() == [0, 1, 2, 3]
    assert counts.tolist() == [5000] * 4


def test_a_grid_sees_each_value_once() -> None:
    made = Choice(("a", "b", "c"), (1.0, 0.0, 2.0))
    assert made.quantile(np.array(made.levels(5))[:, None])[:, 0].tolist() == ["a", "c"]
    dice = UniformInteger(1, 6)
    assert dice.quantile(np.array(dice.levels(2))[:, None])[:, 0].tolist() == [1, 2, 3, 4, 5, 6]
    span = Uniform(0.0, 4.0)
    assert span.quantile(np.array(span.levels(5))[:, None])[:, 0].tolist() == [0, 1, 2, 3, 4]


@pytest.mark.parametrize("weights", [(1.0,), (1.0, -1.0), (0.0, 0.0)])
def test_weights_that_are_none_are_refused(weights: tuple[float, ...]) -> None:
    with pytest.raises(DiagnosticError, match="RL476"):
        Choice(("a", "b"), weights).quantile(EVEN)
