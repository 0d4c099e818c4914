"""Evaluations in scene JSON that are not as they were written."""

from __future__ import annotations

import pytest

from roadlang.stl.formats.evaluation_json import UnreadableEvaluation, evaluation_from_json


def test_an_unknown_member_is_answered_with_those_that_there_are() -> None:
    with pytest.raises(UnreadableEvaluation, match="the members are semantics, ") as raised:
        evaluation_from_json({"strikt": True})
    assert raised.value.place == "strikt"
