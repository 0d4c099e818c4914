"""The size of a formula when it is written out, without writing it out."""

from __future__ import annotations

import pytest

from roadlang.stl import And, Comparison, Constant, Formula, Iff, Not, Variable, parse
from roadlang.stl.formula.size import written_out_size

P = Comparison("<", Variable("x"), Constant(1.0))


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("x < 1", 3),
        ("not x < 1", 4),
        ("always[0, 5] (x < 1 and y + x > 2)", 10),
        ("x < 1 implies y < 1", 8),
        ("x < 1 iff y < 1", 17),
    ],
)
def test_every_operator_variable_and_number_counts(text: str, size: int) -> None:
    assert written_out_size(parse(text)) == size


def test_what_is_shared_counts_each_time_but_costs_once() -> None:
    doubled: Formula = P
    either: Formula = P
    for _ in range(60):
        doubled = And((doubled, doubled))
        either = Iff(either, Not(either))
    assert written_out_size(doubled) == 4 * 2**60 - 1
    assert written_out_size(either) > 4**60
