"""Evaluations in scene JSON that are not as they were written."""

from __future__ import annotations

from typing import Any

import pytest

from roadlang.stl.formats.evaluation_json import UnreadableEvaluation, evaluation_from_json

OPERAND = {">": ["ego.speed", 1.0]}


@pytest.mark.parametrize(
    ("record", "place", "says"),
    [
        ({"strikt": True}, "strikt", "an evaluation has no member `strikt`: did you mean "
         "`strict`?"),
        ({"zz": 1}, "zz", "an evaluation has no member `zz`: it has `semantics`, `robustness`, "
         "`weights` and `strict`"),
        ({"semantics": "helt"}, "semantics", "expected `sampled`, `held` or `linear`, found "
         '`"helt"`: did you mean `held`?'),
        ({"robustness": ["time"]}, "robustness", "expected `space`, `time`, `time_left` or "
         '`average`, found `["time"]`'),
        ({"strict": 1}, "strict", "expected `true` or `false`, found `1`"),
        ({"weights": {"a": 1}}, "weights", "expected a list of pairs, each a formula and its "
         'weight, found `{"a": 1}`'),
        ({"weights": [2.0]}, "weights[0]", "expected a pair, a formula and its weight, found "
         "`2.0`"),
        ({"weights": [[OPERAND, 0]]}, "weights[0][1]", "expected a weight, a number above 0, "
         "found `0`"),
        ({"semantics": "held", "robustness": "time"}, "semantics", "`semantics` and `robustness` "
         "cannot be used together: leave out one of them"),
    ],
)  # fmt: skip
def test_what_was_expected_and_found_is_said(record: dict[str, Any], place: str, says: str) -> None:
    with pytest.raises(UnreadableEvaluation) as raised:
        evaluation_from_json(record)
    assert (raised.value.place, str(raised.value)) == (place, says)


def test_a_long_value_is_cut() -> None:
    with pytest.raises(UnreadableEvaluation) as raised:
        evaluation_from_json({"strict": "x" * 500})
    assert str(raised.value).endswith(f'found `"{"x" * 56}...`')
