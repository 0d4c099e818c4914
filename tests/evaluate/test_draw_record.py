"""What candidates have drawn keeps the order in which it was drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.evaluate.draw_record import CopyDraws, DrawRecord

NAMES = [f"road{number}/perturb 1/amplitude" for number in range(20)]
"""More than a set would have in order by chance"""


def test_what_single_candidates_drew_is_added_in_its_order() -> None:
    alone = DrawRecord({name: np.array([0.5]) for name in NAMES})
    record = DrawRecord()
    record.add_alone({1: alone}, 3)
    assert list(record.coordinates) == NAMES
    assert list(record.absent) == NAMES


def test_what_some_candidates_lack_is_taken_in_its_order() -> None:
    lacking = {name: np.array([True, False, False]) for name in NAMES}
    record = DrawRecord({name: np.zeros(3) for name in NAMES}, absent=lacking)
    assert list(record.take(np.array([0, 1]), 3).absent) == NAMES


def test_draws_that_no_taken_candidate_has_are_gone_and_full_ones_are_not_absent() -> None:
    lacking = {
        "never": np.array([True, True, False]),
        "partly": np.array([True, False, False]),
        "always": np.array([False, False, True]),
    }
    taken = DrawRecord({name: np.arange(3.0) for name in lacking}, absent=lacking).take(
        np.array([0, 1]), 3
    )
    assert list(taken.coordinates) == ["partly", "always"]
    assert {name: lacks.tolist() for name, lacks in taken.absent.items()} == {
        "partly": [True, False]
    }


def test_what_copies_drew_is_named_by_copy_and_left_out_where_a_candidate_has_none() -> None:
    table = np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])
    lacking = np.array([[False, False, True], [False, True, True]])
    record = DrawRecord({"tree/at": CopyDraws("tree/at", (1, 2, 10), table, lacking)})
    record.coordinates["ego/at"] = np.array([0.7, 0.8])
    assert list(record.named_coordinates()) == ["tree/at[1]", "tree/at[2]", "tree/at[10]", "ego/at"]
    assert record.coordinates_of_rows(2) == [
        {"ego/at": 0.7, "tree/at[1]": 0.1, "tree/at[2]": 0.2},
        {"ego/at": 0.8, "tree/at[1]": 0.4},
    ]
    taken = record.take(np.array([1]), 2)
    assert taken.coordinates_of_rows(1) == [{"ego/at": 0.8, "tree/at[1]": 0.4}]


def test_what_was_drawn_is_in_the_order_of_its_names() -> None:
    words = np.array([["b", "a", "c"]])
    record = DrawRecord(values={"tree/kind": CopyDraws("tree/kind", (2, 10, 100), words)})
    record.values["a/at"] = np.array([[5.0]])
    (found,) = record.values_of_rows(1, lambda column: column.reshape(-1).tolist())
    assert list(found.items()) == [
        ("a/at", 5.0), ("tree/kind[100]", "c"), ("tree/kind[10]", "a"), ("tree/kind[2]", "b"),
    ]  # fmt: skip


@pytest.mark.parametrize("columns", [False, True])
def test_what_another_kind_drew_stands_where_a_candidate_lacks_the_first(columns: bool) -> None:
    """Each candidate has the one or the other; the last has neither."""
    record = DrawRecord()
    into: dict[str, Any] = record.values if columns else record.coordinates
    for numbers, lacking in (([1.0, 2.0, 3.0], [0, 1, 1]), ([4.0, 5.0, 6.0], [1, 0, 1])):
        column = np.array(numbers)[:, None] if columns else np.array(numbers)
        record.add_shared(into, "ego/length", column, np.array(lacking, bool))
    assert into["ego/length"].shape == ((3, 1) if columns else (3,))
    assert into["ego/length"].reshape(-1)[:2].tolist() == [1.0, 5.0]
    assert record.absent["ego/length"].tolist() == [False, False, True]


def test_copies_of_different_kinds_draw_at_one_place() -> None:
    """Cars are copies 1 and 2 in the first candidate, 1 alone in the second; the rest are vans."""
    cars = CopyDraws(
        "queue/length", (1, 2), np.array([[4.1, 4.2], [4.3, 0.0]]), np.array([[0, 0], [0, 1]], bool)
    )
    vans = CopyDraws(
        "queue/length", (2, 3), np.array([[0.0, 6.1], [6.2, 0.0]]), np.array([[1, 0], [0, 1]], bool)
    )
    for first, later in ((cars, vans), (vans, cars)):
        record = DrawRecord()
        record.add_copies(record.coordinates, first)
        record.add_copies(record.coordinates, later)
        assert record.coordinates_of_rows(2) == [
            {"queue/length[1]": 4.1, "queue/length[2]": 4.2, "queue/length[3]": 6.1},
            {"queue/length[1]": 4.3, "queue/length[2]": 6.2},
        ]
    whole = cars.joined(CopyDraws("queue/length", (2,), np.array([[7.0], [8.0]])))
    assert whole.absent is None
    assert whole.table.tolist() == [[4.1, 7.0], [4.3, 8.0]]


def test_copies_of_taken_candidates_are_those_that_some_of_them_have() -> None:
    table, lacking = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]), np.zeros((3, 2), bool)
    lacking[1:, 1] = True
    lacking[2] = True
    drawn = CopyDraws("tree/at", (1, 2), table, lacking)
    (first, both, none) = (drawn.take(np.array(rows)) for rows in ([1], [0, 1], [2]))
    assert first is not None
    assert both is not None
    assert (first.copies, first.table.tolist(), first.absent) == ((1,), [[3.0]], None)
    assert (both.copies, both.table.tolist()) == ((1, 2), [[1.0, 2.0], [3.0, 4.0]])
    assert both.absent is not None
    assert both.absent.tolist() == [[False, False], [False, True]]
    assert none is None
    every = CopyDraws("tree/at", (1, 2), table).take(np.array([2, 0]))
    assert every is not None
    assert (every.copies, every.table.tolist()) == ((1, 2), [[5.0, 6.0], [1.0, 2.0]])


def test_what_single_candidates_drew_is_in_their_rows_alone() -> None:
    record = DrawRecord({"known": np.array([0.1, 0.2, 0.3])})
    alone = {
        0: DrawRecord({"known": np.array([0.9]), "some": np.array([0.5])}),
        2: DrawRecord({"some": np.array([0.7]), "last": np.array([0.8])}),
    }
    record.add_alone(alone, 3)
    assert record.coordinates_of_rows(3) == [
        {"known": 0.1, "some": 0.5}, {"known": 0.2}, {"known": 0.3, "some": 0.7, "last": 0.8}
    ]  # fmt: skip
    record.add_alone(dict.fromkeys(range(3), DrawRecord({"all": np.array([0.4])})), 3)
    assert "all" not in record.absent
