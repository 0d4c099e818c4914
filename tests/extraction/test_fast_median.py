"""The median of many values is that of numpy, whatever they are."""

import numpy as np
import pytest

from roadlang_standard.extraction.fast_median import median

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
