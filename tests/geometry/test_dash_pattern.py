"""Where the dashes of broken lines lie."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import DashPattern
from roadlang.geometry.lanes.dash_pattern import PERIOD


@given(st.floats(0.1, 500.0), st.floats(-100.0, 100.0))
def test_no_dash_is_cut_where_a_road_ends_at_a_junction(length: float, start: float) -> None:
    """Dashes of 3 m lie in the middle of their periods."""
    pattern = DashPattern.between(start, start + length, (start - 1.0, start + length))
    for station in (start, start + length):
        away = pattern.at(station) / PERIOD
        assert abs(away - round(away)) < 0.01
    dashes = list(pattern.dashes(start, start + length))
    assert len(dashes) == round(length / PERIOD)
    for low, high in dashes:
        assert (high - low) * pattern.scale == pytest.approx(3.0)
        assert start < low < high < start + length


def test_dashes_of_a_road_with_open_ends_are_cut_off_where_it_ends() -> None:
    pattern = DashPattern.between(0.0, 22.0, (0.0, 22.05))
    assert list(pattern.dashes(0.0, 22.0)) == [(3.0, 6.0), (12.0, 15.0), (21.0, 22.0)]
    assert list(pattern.dashes(5.0, 14.0)) == [(5.0, 6.0), (12.0, 14.0)]
