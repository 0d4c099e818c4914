"""Where a displacement acts, and how it fades."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import GeometryError, ease, fade, over


@given(st.floats(5.0, 20.0), st.floats(40.0, 90.0), st.floats(1.0, 12.0))
def test_a_window_is_one_inside_its_interval_and_zero_outside(
    start: Any, stop: Any, taper: Any
) -> None:
    s = np.linspace(0.0, 100.0, 401)
    window = over(s, start, stop, taper)
    assert (window[(s < start) | (s > stop)] == 0.0).all()
    np.testing.assert_allclose(window[(s > start + taper) & (s < stop - taper)], 1.0)
    assert ((window >= 0.0) & (window <= 1.0)).all()


def test_an_interval_may_cross_the_seam_of_a_ring() -> None:
    s = np.linspace(0.0, 100.0, 100, endpoint=False)
    window = over(s, 90.0, 10.0, period=100.0)
    np.testing.assert_array_equal(s[window > 0], [*range(11), *range(90, 100)])


def test_an_endless_interval_has_no_taper_at_its_end() -> None:
    s = np.linspace(0.0, 100.0, 11)
    window = over(s, 50.0, np.inf, taper=10.0)
    np.testing.assert_array_equal(window[s >= 60.0], 1.0)


def test_a_fade_holds_value_slope_and_second_derivative_at_the_ends() -> None:
    s = np.linspace(0.0, 40.0, 40001)
    window = fade(s, 40.0, taper=15.0)
    for end in (window[:3], window[-3:]):
        np.testing.assert_allclose(end, 0.0, atol=1e-10)
        np.testing.assert_allclose(np.diff(end) / s[1], 0.0, atol=1e-6)
        np.testing.assert_allclose(np.diff(end, 2) / s[1] ** 2, 0.0, atol=1e-3)
    assert window[0] == window[-1] == 0.0
    assert (window[(s >= 15.0) & (s <= 25.0)] == 1.0).all()
    one_sided = fade(s, 40.0, taper=15.0, at_end=False)
    assert one_sided[-1] == 1.0


def test_on_a_short_road_each_end_fades_over_half_and_bends_no_more_than_a_long_one() -> None:
    long, short = np.linspace(0.0, 40.0, 4001), np.linspace(0.0, 10.0, 1001)
    bends = [
        np.abs(np.diff(fade(s, s[-1], taper=15.0), 2)).max() / s[1] ** 2 for s in (long, short)
    ]
    assert bends[1] == pytest.approx(bends[0], rel=1e-3)
    window = fade(short, 10.0, taper=15.0)
    assert window.argmax() == 500
    assert window[0] == window[-1] == 0.0


def test_a_dead_end_shorter_than_the_taper_is_left_nearly_where_it_is() -> None:
    s = np.linspace(0.0, 2.0, 21)
    one_sided = fade(s, 2.0, taper=15.0, at_end=False)
    np.testing.assert_allclose(one_sided, fade(s, 30.0, taper=15.0), atol=1e-12)
    assert one_sided[-1] < 0.03


def test_ease_goes_from_zero_to_one() -> None:
    np.testing.assert_allclose(ease([-1.0, 0.0, 0.5, 1.0, 2.0]), [0, 0, 0.5, 1, 1])
    slope = np.diff(ease([0.4999, 0.5001]))[0] / 0.0002
    assert slope == pytest.approx(1.875, rel=1e-6)


def test_impossible_windows_are_refused() -> None:
    s = np.linspace(0.0, 10.0, 11)
    calls: tuple[Callable[[], object], ...] = (
        lambda: over(s, 5.0, 2.0),
        lambda: over(s, 0.0, 5.0, taper=-1.0),
        lambda: fade(s, 10.0, taper=0.0),
    )
    for call in calls:
        with pytest.raises(GeometryError):
            call()
