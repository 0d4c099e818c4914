"""How well a value separates failures from the other drives."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from roadlang.report.draw_charts import separation


@given(arrays(np.float64, st.integers(2, 40), elements=st.integers(-5, 5).map(float)), st.data())
def test_separation_compares_every_pair(values: np.ndarray, data: st.DataObject) -> None:
    some = data.draw(st.sets(st.integers(0, len(values) - 1), min_size=1, max_size=len(values) - 1))
    failed = np.isin(np.arange(len(values)), list(some))
    pairs = np.sign(values[failed][:, None] - values[~failed][None, :])
    assert separation(values.tolist(), failed) == pytest.approx(pairs.mean())


def test_words_set_nothing_apart() -> None:
    assert separation(["car", "truck", "car"], np.array([True, False, False])) == 0.0
    assert separation([True, False, True], np.array([True, False, False])) == 0.0
