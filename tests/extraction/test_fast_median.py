"""Medians, quantiles and even steps are those of numpy, to the last bit."""

import numpy as np
import pytest

from roadlang_standard.extraction.colors.fast_median import median, quantile
from roadlang_standard.extraction.curves.smoothing import evenly

RNG = np.random.default_rng(5)


@pytest.mark.parametrize("count", [1, 10, 50_000, 50_001])
@pytest.mark.parametrize("levels", [2, 40, 0])
def test_it_is_that_of_numpy(count: int, levels: int) -> None:
    values = RNG.normal(size=count).astype(np.float32)
    values = np.round(values * levels) if levels else values
    assert median(values) == float(np.median(values))


def test_a_sample_that_says_nothing_does_no_harm() -> None:
    values = np.arange(60_000, dtype=np.float32)
    values[:: len(values) // 5000] = -1  # all that is sampled
    assert median(values) == float(np.median(values))


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("share", [0.1, 0.5, 0.7, 0.9])
def test_quantiles_are_those_of_numpy(kind: type, share: float) -> None:
    for count in [*range(1, 60), 3999, 4000]:
        values = RNG.normal(size=count).astype(kind)
        assert quantile(values, share) == float(np.quantile(values, share))


def test_of_what_is_not_a_number_there_is_no_quantile() -> None:
    assert np.isnan(quantile(np.array([1.0, np.nan, 2.0]), 0.1))
    assert np.isnan(median(np.array([1.0, np.nan, 2.0])))


def test_even_steps_are_those_of_numpy() -> None:
    for count in range(2, 300):
        last = float(RNG.uniform(0, 900))
        assert evenly(last, count).tobytes() == np.linspace(0, last, count).tobytes()
    assert evenly(0.0, 2).tolist() == [0.0, 0.0]
