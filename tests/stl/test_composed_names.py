"""Letters with marks are one name, whether they are written as one character or as two."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Literal
from unicodedata import normalize

import pytest

from roadlang.stl import parse, read_trace
from roadlang.stl.formats.trace_stream import samples_of_lines

Form = Literal["NFC", "NFD"]

NAME = "größe"
TABLE = f"time,{NAME}\n0,1\n1,2\n"
ROWS = [{"time": 0, NAME: 1}, {"time": 1, NAME: 2}]
COLUMNS = {"time": [0, 1], NAME: [1, 2]}


@pytest.mark.parametrize("form", ["NFC", "NFD"])
def test_formulas_name_columns_in_either_form(form: Form) -> None:
    (name,) = parse(normalize(form, f"always (`{NAME}` > 0)")).variables
    assert name == normalize("NFC", NAME)


@pytest.mark.parametrize("form", ["NFC", "NFD"])
@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.csv", TABLE),
        ("a.csv", f"# time {NAME}\n0 1\n1 2\n"),
        ("a.json", json.dumps(COLUMNS, ensure_ascii=False)),
        ("a.json", json.dumps(ROWS, ensure_ascii=False)),
    ],
)
def test_traces_have_composed_names(name: str, text: str, form: Form, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_text(normalize(form, text), encoding="utf-8")
    _, times, signals = read_trace(path)
    assert signals == {normalize("NFC", NAME): [1, 2]}
    assert parse(f"always (`{NAME}` > 0)").robustness(times, signals)[0] == 1


def test_streams_have_composed_names() -> None:
    lines = normalize("NFD", TABLE).splitlines(keepends=True)
    assert [list(values) for _, values in samples_of_lines(lines)] == [[NAME], [NAME]]
