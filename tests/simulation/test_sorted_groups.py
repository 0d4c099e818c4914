"""Groups of equal keys are those of `numpy.unique`."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from roadlang.simulation.surroundings.sorted_groups import sorted_groups


@given(st.lists(st.integers(-3, 3)))
def test_groups_of_sorted_keys_are_those_of_numpy(keys: list[int]) -> None:
    column = np.array(sorted(keys), dtype=np.int64)
    found = sorted_groups(column)
    expected = np.unique(column, return_index=True, return_inverse=True)
    for mine, theirs in zip(found, expected, strict=True):
        np.testing.assert_array_equal(mine, theirs)
