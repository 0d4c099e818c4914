"""Where the numbers of a program lie, and which calls put its results where they are wanted."""

from __future__ import annotations

import numpy as np

from roadlang.simulation.tapes.registers import Registers, aligned


def test_results_are_computed_where_they_are_wanted() -> None:
    rows = [aligned(1, 3)[0], aligned(1, 3)[0]]
    memory = Registers(3, {0: np.ones(3)})
    memory.put_results([1, 2], rows)
    for register in (1, 2):
        memory.for_number(register)[:] = register
    assert memory.copies([1, 2], rows) == []
    assert [row.tolist() for row in rows] == [[1.0] * 3, [2.0] * 3]


def test_results_that_are_given_are_copied_and_stay_where_they_are() -> None:
    given, row = np.array([1.0, 2.0, 3.0]), aligned(1, 3)[0]
    row[:] = 0.0
    memory = Registers(3, {0: given})
    memory.put_results([0], [row])
    assert memory.number(0, []) is given
    (copy,) = memory.copies([0], [row])
    copy()
    assert row.tolist() == given.tolist()


def test_of_two_wishes_for_one_result_the_first_is_met_and_the_other_copied() -> None:
    rows = [aligned(1, 2)[0], aligned(1, 2)[0]]
    memory = Registers(2, {})
    memory.put_results([5, 5], rows)
    memory.for_number(5)[:] = 7.0
    (copy,) = memory.copies([5, 5], rows)
    copy()
    assert [row.tolist() for row in rows] == [[7.0, 7.0]] * 2
