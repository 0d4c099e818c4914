"""Columns of angles."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang.geometry.arrays import wrapped, wrapped_angle


@pytest.mark.parametrize("most", [3.0, math.pi, 4.0, 20.0])
@pytest.mark.parametrize("count", [3, 1000])
def test_angles_of_many_are_wrapped_as_those_of_few(most: float, count: int) -> None:
    angles = np.random.default_rng(1).uniform(-most, most, count)
    angles[0], angles[1], angles[2] = math.pi, -math.pi, most
    expected = (angles + math.pi) % (2.0 * math.pi) - math.pi
    found = wrapped(angles)
    assert found.tobytes() == expected.tobytes()
    assert found[0] == -math.pi


def test_one_angle_and_what_is_no_number() -> None:
    assert wrapped(np.array([4.0]))[0] == pytest.approx(4.0 - 2.0 * math.pi)
    angles = np.zeros(1000)
    angles[5] = math.nan
    assert np.isnan(wrapped(angles)).tolist() == [i == 5 for i in range(1000)]


def test_one_angle_is_wrapped_as_those_of_columns() -> None:
    angles = [*np.random.default_rng(2).uniform(-20.0, 20.0, 1000).tolist(), math.pi, -math.pi]
    alone = np.array([wrapped_angle(angle) for angle in angles])
    assert alone.tobytes() == wrapped(np.array(angles)).tobytes()
