"""Records made of columns are those that are made one by one."""

from __future__ import annotations

from dataclasses import fields
from itertools import repeat

import pytest

from roadlang.ir.read_only import FrozenDict
from roadlang.ir.record_columns import records_of
from roadlang.ir.scene_actor import Call, SceneActor


def test_records_of_columns_are_those_made_one_by_one() -> None:
    options = {"height": 4.0, "color": "#ffffff"}
    rows = [
        ("t[0]", "t", "tree", 1.0, 2.0, 0.5, 3.0, 3.0, 4.0, "main", 9.0, 1.0, None, "back",
         options, (), None, None, (), "tree", ""),
        ("t[1]", "t", "car", 3.0, 4.0, 0.1, 4.0, 2.0, 1.5, None, None, None, -1, "forward",
         {}, (Call("idle"),), 2.0, None, (), "car", "taxi"),
    ]  # fmt: skip
    names = [field.name for field in fields(SceneActor)]
    columns = dict(zip(names, zip(*rows, strict=True), strict=True))
    made = records_of(SceneActor, 2, columns)
    assert made == [SceneActor(*row) for row in rows]
    assert type(made[0].options) is FrozenDict
    with pytest.raises(AttributeError):
        made[0].name = "other"  # type: ignore[misc]


def test_one_value_stands_for_a_whole_column_and_cannot_be_changed_either() -> None:
    made = records_of(Call, 3, {"kind": ["a", "b", "c"], "options": repeat({"gain": 1.0}),
                                "when": repeat(None), "during": repeat(None)})  # fmt: skip
    assert [call.kind for call in made] == ["a", "b", "c"]
    assert all(call.options is made[0].options for call in made)
    assert type(made[0].options) is FrozenDict
