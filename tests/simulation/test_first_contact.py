"""When rectangles that move straight touch for the first time."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang.simulation.calling.option_columns import shape_of
from roadlang.simulation.surroundings.first_contacts import first_contact
from roadlang.simulation.surroundings.outlines import Outlines


def box(x: float, y: float, heading: float = 0.0) -> Outlines:
    """4 m long, 2 m wide."""
    numbers = (x, y, math.cos(heading), math.sin(heading), 2.0, 1.0)
    return Outlines(*(np.array([number]) for number in numbers))


@pytest.mark.parametrize(
    ("end", "heading", "shift", "share"),
    [
        ((-2.0, 0.0), 0.0, (12.0, 0.0), 10 / 12),  # from x = -14 to -2: at -4
        ((14.0, 0.0), 0.0, (24.0, 0.0), 0.25),  # from x = -10, through it
        ((14.0, 0.0), 0.0, (12.0, 0.0), 0.0),  # away from where they overlapped
        ((10.0, 1.5), 0.0, (20.0, 0.0), 0.3),
        ((10.0, 2.5), 0.0, (20.0, 0.0), math.inf),  # past it
        ((0.0, -1.0), 0.0, (0.0, 8.0), 7 / 8),  # from y = -9 to -1: at -2
        ((-5.0, 0.0), 0.0, (4.0, 0.0), 1.25),  # after the end of the way
        ((0.0, 1.0), math.pi / 2, (0.0, 8.0), 0.5),  # upright, from y = -7: at -3
    ],
)
def test_boxes_meet_where_their_sides_do(
    end: tuple[float, float], heading: float, shift: tuple[float, float], share: float
) -> None:
    moved = (np.array([shift[0]]), np.array([shift[1]]))
    (found,) = first_contact(box(*end, heading), box(0.0, 0.0), moved)
    assert found == pytest.approx(share)


def test_options_that_are_numbers_have_shapes() -> None:
    assert shape_of(3) == shape_of(2.5) == ()
    assert shape_of([1.0, 2.0]) == (2,)
    assert shape_of(((1, 2), (3, 4), (5, 6))) == (3, 2)
    for other in (True, "wide", [1, "wide"], [1, [2]], [], [[1, 2], [3]]):
        assert shape_of(other) is None
