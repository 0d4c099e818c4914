"""JSON has no infinity and no NaN: the error says where in a record such a number is."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass, field
from typing import Any

import pytest

from roadlang.ir.encoding import NotFinite, to_json


@dataclass(frozen=True)
class Record:
    name: str = "r"
    width: float = 1.0
    rows: tuple[tuple[float, ...], ...] = ()
    options: dict[str, Any] = field(default_factory=dict)


@pytest.mark.parametrize(
    ("record", "place"),
    [
        (Record(width=math.inf), "width"),
        (Record(rows=((1.0, 2.0), (3.0, math.nan))), "rows[1][1]"),
        (Record(options={"b": 1.0, "a": {"deep": -math.inf}}), "options.a.deep"),
        (Record(options={"a": [0.5, {"x": math.nan}]}), "options.a[1].x"),
    ],
)
def test_the_place_of_a_number_that_is_not_finite_is_named(record: Record, place: str) -> None:
    with pytest.raises(NotFinite) as caught:
        to_json(record)
    assert caught.value.place == place
    assert str(caught.value) == f"`{place}` is not a finite number"


def test_finite_records_read_back_and_end_with_a_line_break() -> None:
    text = to_json(Record(rows=((1.5, 2.0),), options={"b": True, "a": None}))
    assert text.endswith("}\n")
    assert json.loads(text) == {
        "name": "r", "width": 1.0, "rows": [[1.5, 2.0]], "options": {"a": None, "b": True},
    }  # fmt: skip
    assert text.index('"a"') < text.index('"b"')


def test_a_plain_map_is_sorted_and_has_two_blanks_for_each_level() -> None:
    record = {"b": [1, 2.5], "schema": "x/1", "a": {"y": [{"z": 1}], "x": None}, "empty": {}}
    lines = """{
  "a": {
    "x": null,
    "y": [
      {
        "z": 1
      }
    ]
  },
  "b": [1, 2.5],
  "empty": {},
  "schema": "x/1"
}
"""
    assert to_json(record) == lines


def test_a_record_has_its_schema_first() -> None:
    @dataclass(frozen=True)
    class Versioned:
        name: str = "r"
        schema: str = "x/1"

    assert to_json(Versioned()) == '{\n  "schema": "x/1",\n  "name": "r"\n}\n'
