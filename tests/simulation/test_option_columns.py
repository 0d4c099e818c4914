"""Which agents are decided together: those whose options differ in numbers alone."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.simulation.calling.option_columns import columns_of, options_of, shape_of, words_of


@pytest.mark.parametrize(
    ("value", "shape"),
    [
        (1, ()), (0.5, ()), ((1, 2.0), (2,)), ([(1, 2), (3, 4), (5, 6)], (3, 2)),
        (True, None), ("left", None), ([1, "left"], None), ([(1, 2), (3,)], None), ((), None),
        (None, None),
    ],
)  # fmt: skip
def test_numbers_have_a_shape(value: Any, shape: tuple[int, ...] | None) -> None:
    assert shape_of(value) == shape


def test_words_and_shapes_tell_agents_apart_and_numbers_do_not() -> None:
    here = {"to": "left", "speed": 3.0, "points": [(1.0, 2.0)], "force": True}
    assert words_of(here) == words_of({**here, "speed": 5.0, "points": [(7.0, 8.0)]})
    others = ({"to": "right"}, {"force": False}, {"points": [(1.0, 2.0)] * 2}, {"speed": "any"})
    assert len({words_of(here), *(words_of(here | other) for other in others)}) == 5
    assert words_of({"speed": 3.0, "gap": 1}) == ""


def test_numbers_of_agents_are_columns() -> None:
    columns = columns_of([{"to": "left", "speed": 3.0}, {"to": "left", "speed": 5.0}], {"dt": 0.1})
    assert columns["speed"].tolist() == [3.0, 5.0]
    assert (columns["to"], columns["dt"]) == ("left", 0.1)
    assert options_of(columns, np.array([1])) == {"to": "left", "speed": [5.0], "dt": 0.1}
