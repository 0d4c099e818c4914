"""Pixels of a picture and meters of the world, both ways."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.api import Picture


def picture(scale: float = 0.5) -> Picture:
    return Picture(np.zeros((40, 60, 3), np.uint8), scale)


@pytest.mark.parametrize(
    ("pixel", "world"),
    [
        ((-0.5, 39.5), (0.0, 0.0)),  # the lower left corner of the lower left pixel
        ((0.0, 39.0), (0.25, 0.25)),  # its center
        ((0.0, 0.0), (0.25, 19.75)),
        ((59.5, -0.5), (30.0, 20.0)),  # the upper right corner of all
    ],
)
def test_the_origin_is_the_lower_left_corner_and_y_goes_up(
    pixel: tuple[float, float], world: tuple[float, float]
) -> None:
    np.testing.assert_allclose(picture().to_world(np.array(pixel)), world, atol=1e-12)
    np.testing.assert_allclose(picture().to_pixels(np.array(world)), pixel, atol=1e-12)


@given(st.floats(-100, 100), st.floats(-100, 100), st.floats(0.01, 10))
def test_there_and_back(x: float, y: float, scale: float) -> None:
    made = picture(scale)
    point = np.array([[x, y]])
    np.testing.assert_allclose(made.to_pixels(made.to_world(point)), point, atol=1e-9)


def test_a_road_of_pixels_becomes_one_of_meters() -> None:
    found = picture(0.5).network([np.array([[0.0, 10.0], [40.0, 10.0]])], width=8.0)
    (edge,) = found.network.edges
    assert edge.length == pytest.approx(20.0)
    assert edge.width.at(np.array([5.0]))[0] == pytest.approx(4.0)


def test_a_typed_picture_is_as_wide_as_its_longest_line() -> None:
    typed = Picture(None, 2.0, characters=("##", "#####", "#"))
    assert (typed.width, typed.height) == (5, 3)
