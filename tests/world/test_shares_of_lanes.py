"""`at 40%` in a network: a share of the length of all lanes that are long enough to begin in."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.world.placement.shares_of_lanes import at_share

lanes = st.lists(
    st.tuples(st.sampled_from([0.0, 5.0, 11.0, 12.0, 40.0]), st.booleans()), min_size=1, max_size=5
).filter(lambda found: any(length for length, _ in found))


@pytest.mark.parametrize(
    ("share", "lengths", "number", "station"),
    [
        (0.0, [40.0, 20.0], 0, 0.0),
        (0.5, [40.0, 20.0], 0, 30.0),
        (40 / 60, [40.0, 20.0], 1, 0.0),
        (1.0, [40.0, 20.0], 1, 20.0),
        (0.0, [5.0, 40.0], 1, 0.0),  # too short to begin in
        (1.0, [40.0, 5.0], 0, 40.0),
        (1.0, [40.0, 5.0, 5.0], 0, 40.0),
        (0.5, [40.0, 5.0, 40.0], 2, 0.0),
        (0.5, [11.0, 12.0], 1, 6.0),
        (0.5, [11.0, 9.0], 0, 10.0),  # none is long enough: all of them count
        (1.5, [40.0, 20.0], 1, 20.0),
        (-0.5, [40.0, 20.0], 0, 0.0),
    ],
)
def test_where_a_share_is(share: float, lengths: list[float], number: int, station: float) -> None:
    numbers, stations = at_share(np.array([share]), [(0.0, length) for length in lengths])
    assert numbers.tolist() == [number]
    assert stations == pytest.approx([station])


@given(lanes, st.integers(2, 9))
def test_even_shares_are_evenly_spaced(found: list[tuple[float, bool]], count: int) -> None:
    ends = [(0.0, length) if forward else (length, 0.0) for length, forward in found]
    enough = [length >= 12.0 for length, _ in found]
    counted = [n * (ok or not any(enough)) for (n, _), ok in zip(found, enough, strict=True)]
    shares = np.linspace(0.0, 1.0, count)
    numbers, stations = at_share(shares, ends)
    before = np.concatenate([[0.0], np.cumsum(counted)])
    along = [
        before[number] + abs(station - ends[number][0])
        for number, station in zip(numbers.tolist(), stations.tolist(), strict=True)
    ]
    assert along == pytest.approx((shares * sum(counted)).tolist(), abs=1e-9)
    assert all(counted[number] for number in numbers.tolist())
