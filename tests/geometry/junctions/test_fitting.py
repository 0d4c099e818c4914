"""Curves of connections reach their ends exactly, and are drivable where they say so."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry.junctions.connection_curves import TIGHTEST, ConnectionEnds, fitted, sampled

EVERYWHERE = np.zeros((0, 3))


def fit(stop: tuple[float, float], heading: float, most_radius: float = math.inf):  # type: ignore[no-untyped-def]
    """From the origin eastward."""
    one = np.zeros(1)
    ends = ConnectionEnds(
        np.zeros((1, 2)), one, np.array([stop]), np.array([heading]), one + most_radius
    )
    return fitted(ends, EVERYWHERE)


def test_a_quarter_turn_is_one_arc() -> None:
    found = fit((10.0, 10.0), math.pi / 2)
    assert found.pieces(0) == ((pytest.approx(5 * math.pi), pytest.approx(0.1)),)


def test_an_arc_round_a_curb_has_lines_before_and_after() -> None:
    lengths, curvatures = zip(*fit((10.0, 10.0), math.pi / 2, 6.0).pieces(0), strict=True)
    assert lengths == pytest.approx((4.0, 3 * math.pi, 4.0))
    assert curvatures == pytest.approx((0.0, 1 / 6, 0.0))


def test_a_shift_is_two_arcs_of_opposite_bend() -> None:
    (_, first), (_, second) = fit((20.0, 2.0), 0.0).pieces(0)
    assert first == pytest.approx(-second)
    assert first > 0.0


def test_straight_on_is_straight() -> None:
    assert fit((12.0, 0.0), 0.0).curvatures == pytest.approx(np.zeros((1, 3)))


def test_what_is_too_tight_says_so() -> None:
    assert not fit((3.0, 3.0), math.pi / 2).drivable[0]
    assert fit((4.01, 4.01), math.pi / 2).drivable[0]


@given(st.floats(-40, 40), st.floats(-40, 40), st.floats(-math.pi, math.pi))
def test_the_ends_are_exact(x: float, y: float, heading: float) -> None:
    if math.hypot(x, y) < 0.5:
        return
    found = fit((x, y), heading)
    points, headings = sampled(found, np.array([0.0, 1.0]))
    if found.drivable[0]:
        assert points[0, -1] == pytest.approx((x, y), abs=1e-9)
        assert math.cos(headings[0, -1] - heading) == pytest.approx(1.0, abs=1e-12)
        assert found.peak[0] <= TIGHTEST * (1 + 1e-12)
