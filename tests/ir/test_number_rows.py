"""Rows of numbers that scenes have, and the arrays that are made of them."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from roadlang.geometry.arrays import read_only
from roadlang.ir.read_only import Floats

NUMBERS = [0.0, -0.0, 1.5, 1e30]


@pytest.fixture(params=["alone", "of a row"])
def floats(request: pytest.FixtureRequest) -> Floats:
    row = read_only(np.array(NUMBERS))
    return Floats(NUMBERS) if request.param == "alone" else Floats.of_row(NUMBERS, row)


def test_arrays_of_them_have_the_same_bits_as_those_of_a_tuple(floats: Floats) -> None:
    assert np.asarray(floats).tobytes() == np.array(tuple(NUMBERS)).tobytes()
    assert np.array(floats, np.float32).dtype == np.float32
    assert np.stack([floats, floats], axis=-1).shape == (4, 2)
    assert np.asarray(Floats()).shape == (0,)


def test_what_is_written_to_an_array_changes_nothing_else(floats: Floats) -> None:
    np.asarray(floats)[0] = 7.0
    assert floats[0] == 0.0
    assert np.asarray(floats)[0] == 0.0


def test_they_are_pickled_as_numbers_alone(floats: Floats) -> None:
    again = pickle.loads(pickle.dumps(floats))
    assert type(again) is Floats
    assert again == floats
    assert len(pickle.dumps(floats)) == len(pickle.dumps(Floats(NUMBERS)))
