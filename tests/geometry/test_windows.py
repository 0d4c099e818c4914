"""Where a displacement acts, and how it fades."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import GeometryError, ease, fade, over


@given(st.floats(5.0, 20.0), st.floats(40.0, 90.0), st.floats(1.0, 12.0))
def test_a_window_is_one_inside_its_stretch_and_zero_outside(
    start: float, stop: float, taper: float
) -> None:
    s = np.linspace(0.0, 100.0, 401)
    window = over(s, start, stop, taper)
    assert (window.value[(s < start) | (s > stop)] == 0.0).all()
    np.testing.assert_allclose(window.value[(s > start + taper) & (s < stop - taper)], 1.0)
    assert ((window.value >= 0.0) & (window.value <= 1.0)).all()


def test_derivatives_of_windowed_displacements_are_exact() -> None:
    s = np.linspace(0.0, 100.0, 2001)
    window = over(s, 20.0, 90.0, 15.0)
    e, slope, bend = window.apply(np.sin(s / 9), np.cos(s / 9) / 9, -np.sin(s / 9) / 81)
    np.testing.assert_allclose(np.gradient(e, s)[1:-1], slope[1:-1], atol=1e-3)
    np.testing.assert_allclose(np.gradient(slope, s)[1:-1], bend[1:-1], atol=3e-3)
    assert window.apply(e)[1:] == (None, None)


def test_a_stretch_may_cross_the_seam_of_a_ring() -> None:
    s = np.linspace(0.0, 100.0, 100, endpoint=False)
    window = over(s, 90.0, 10.0, period=100.0)
    np.testing.assert_array_equal(s[window.value > 0], [*range(11), *range(90, 100)])


def test_an_endless_stretch_has_no_taper_at_its_end() -> None:
    s = np.linspace(0.0, 100.0, 11)
    window = over(s, 50.0, np.inf, taper=10.0)
    np.testing.assert_array_equal(window.value[s >= 60.0], 1.0)


def test_a_fade_holds_value_slope_and_bend_at_the_ends() -> None:
    s = np.linspace(0.0, 40.0, 81)
    window = fade(s, 40.0, reach=15.0)
    for part in (window.value, window.slope, window.bend):
        assert part[0] == part[-1] == 0.0
    assert (window.value[(s >= 15.0) & (s <= 25.0)] == 1.0).all()
    one_sided = fade(s, 40.0, reach=15.0, at_end=False)
    assert one_sided.value[-1] == 1.0


def test_on_a_short_road_each_end_fades_over_half() -> None:
    s = np.linspace(0.0, 10.0, 11)
    window = fade(s, 10.0, reach=100.0)
    assert window.value[5] == 1.0
    assert window.value[0] == window.value[-1] == 0.0


def test_ease_goes_from_zero_to_one() -> None:
    value, slope, bend = ease([-1.0, 0.0, 0.5, 1.0, 2.0])
    np.testing.assert_allclose(value, [0, 0, 0.5, 1, 1])
    np.testing.assert_allclose(slope, [0, 0, 1.875, 0, 0])
    np.testing.assert_allclose(bend, 0.0)


def test_impossible_windows_are_refused() -> None:
    s = np.linspace(0.0, 10.0, 11)
    for call in (
        lambda: over(s, 5.0, 2.0),
        lambda: over(s, 0.0, 5.0, taper=-1.0),
        lambda: fade(s, 10.0, reach=0.0),
    ):
        with pytest.raises(GeometryError):
            call()
