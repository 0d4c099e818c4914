"""Traces are read from CSV and JSON; files that are none are refused with the place."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang.stl.formats.trace_files import read_trace


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.csv", "s,x\n0,1\n2,3\n"),
        ("b.csv", "s; x\n0; 1,0\n\n2; 3\n"),
        ("c.tsv", "\ufeffs\tx\n0\t1\n2\t3\n"),
        ("c.csv", "# made by a tool\n\ns,x\n# the drive\n0,1\n\n2,3\n"),
        ("c.csv", "# s x\n0 1\n2 3\n"),
        ("c.csv", "# of a car\n#s,x\n0,1\n2,3\n"),
        ("c.csv", "s x\n0   1\n  2 3\n"),
        ("c.csv", "s,x\n[m],[m/s]\n0,1\n2,3\n"),
        ("c.csv", "s,x,\n0,1,\n2,3,\n"),
        ("c.csv", 's,"x"\r\n"0","1"\r\n2,3\r\n'),
        ("c.csv", "s,x\r0,1\r2,3\r"),
        ("c.csv", 's, "x"\n"0", "1"\n2, "3"\n'),
        ("c.csv", 's;"x"\n0;1\n2;3\n'),
        ("c.csv", "s,x\n00:00:00,1\n00:00:02.0,3\n"),
        ("c.csv", "s,x\n1970-01-01T00:00:00Z,1\n1970-01-01 01:00:02+01:00,3\n"),
        ("d.json", '{"s": [0, 2], "x": [1, 3]}'),
        ("e.json", '[{"s": 0, "x": 1}, {"s": 2, "x": 3}]'),
    ],
)
def test_layouts(tmp_path: Path, name: str, text: str) -> None:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    assert read_trace(path) == ("s", [0, 2], {"x": [1, 3]})


@pytest.mark.parametrize("header", ['"t";"v, front"', "t;v, front", '"t","v, front"'])
def test_names_may_have_commas(tmp_path: Path, header: str) -> None:
    between = ";" if ";" in header else ","
    path = tmp_path / "log.csv"
    path.write_text(f"{header}\n0{between}1\n2{between}3\n")
    assert read_trace(path) == ("t", [0, 2], {"v, front": [1, 3]})


@pytest.mark.parametrize("cell", ["1_000", "0x10", "1.#INF", "1#2", "\uff11\uff12", "1e", "1 000"])
def test_cells_that_only_look_like_numbers_are_texts(tmp_path: Path, cell: str) -> None:
    """Python takes the first and fifth for numbers, and numpy the third and fourth for 1."""
    path = tmp_path / "log.csv"
    path.write_text(f"time,x\n0,1\n1,{cell}\n", encoding="utf-8")
    _, positions, signals = read_trace(path)
    assert signals["x"] == [1, cell]
    with pytest.raises(DiagnosticError, match="RL303"):
        stl.parse("always (x < 5)").rho(positions, signals)


@pytest.mark.parametrize("cell", ["inf", "Infinity", "+inf", "INF"])
def test_infinity_is_a_number(tmp_path: Path, cell: str) -> None:
    path = tmp_path / "log.csv"
    path.write_text(f"time,x\n0,1\n1,{cell}\n2,-{cell.lstrip('+')}\n")
    assert read_trace(path)[2]["x"] == [1, math.inf, -math.inf]


def test_cells_of_logs(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text("time,on,x\ns,-,m\n0,true,1\n1,FALSE,\n2,1,nan\n")

    axis, positions, signals = read_trace(path)

    assert (axis, positions, signals["on"]) == ("time", [0, 1, 2], [1, 0, 1])
    assert signals["x"][0] == 1
    assert [math.isnan(x) for x in signals["x"]] == [False, True, True]


@pytest.mark.parametrize("ending", ["gz", "bz2", "xz", "lzma", "csv.gz"])
def test_text_in_a_file_that_is_named_as_if_it_were_compressed(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"log.{ending}"
    path.write_text("time,x\n0,1\n1,2\n")

    assert read_trace(path) == ("time", [0, 1], {"x": [1, 2]})


@pytest.mark.parametrize("encoding", ["latin-1", "utf-16", "utf-8-sig", "utf-8"])
def test_encodings(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "log.csv"
    path.write_bytes("Länge,höhe\n0,1\n2,3\n".encode(encoding))

    assert read_trace(path) == ("Länge", [0, 2], {"höhe": [1, 3]})


def test_positions_and_signals(tmp_path: Path) -> None:
    path = tmp_path / "trace.json"
    path.write_text('{"signals": {"x": [1, null]}, "positions": [0, 2]}')
    axis, positions, signals = read_trace(path)
    assert (axis, positions) == ("position", [0, 2])
    assert signals["x"][0] == 1
    assert math.isnan(signals["x"][1])


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("a.csv", "", "empty"),
        ("a.csv", "0,1\n2,3\n", "must name the columns"),
        ("a.csv", "s,x\n0,1\n2\n", "line 3 has 1 cells, not 2"),
        ("a.csv", "s,x\none,0\n", "line 2, column `s`"),
        (
            "a.csv",
            "s,x\n31.12.2025 23:59:59,0\n",
            "a time stamp is written `2026-11-22T07:16:01.5Z`",
        ),
        ("a.csv", "s,s\n0,1\n", "the same name, `s`"),
        ("a.csv", ",s,x\n0,1,2\n", r"column 1, .* has no name, .*: .*`index=False`"),
        ("a.csv", "s,,x\n0,1,2\n", "column 2 has no name"),
        ("a.csv", "s,\n0,1\n", "column 2 has no name"),
        ("a.csv", "# only\n# comments\n", "empty"),
        ("a.csv", "s,x\n0,1\non,1\n", "'on' in line 3, column `s` is not a number"),
        ("a.csv", "s,x\n0,1\n1_000,1\n", "'1_000' in line 3, column `s` is not a number"),
        ("a.csv", "s,x\r0,1\r0x1,1\r", "'0x1' in line 3, column `s` is not a number"),
        ("a.csv", "s\tx\n0\t1\n1,5\t1\n", "write `1.5`, or part the cells by `;`"),
        ("a.csv", "s,x\n0,5,1,5\n", "part the cells by `;` if the numbers have decimal commas"),
        ("a.json", '{"s": [0, "1_000"], "x": [1, 2]}', "'1_000' in `s`, sample 1"),
        ("a.csv", "# hi\ns,x\n0,1\n1,2,3\n", "line 4 has 3 cells, not 2"),
        ("a.json", "{", "not JSON"),
        ("a.json", "3", "neither"),
        ("a.json", '{"s": 3}', "not a list"),
        ("a.json", '{"s": [0, 1], "x": [1]}', "1 values for 2 positions"),
        ("a.json", '{"s": ["no"]}', "`s`, sample 0"),
        ("a.json", "{}", "no columns"),
    ],
)
def test_files_that_are_no_traces(tmp_path: Path, name: str, text: str, problem: str) -> None:
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(DiagnosticError, match=problem):
        read_trace(path)


@pytest.mark.parametrize(
    ("name", "text", "place"),
    [
        ("a.csv", "s,x,who\n0,1,ego\n1,2,lead\n", "'ego' in line 2"),
        ("a.csv", "s,x,who\n0,1,3\n\n1,2,n/a\n", "'n/a' in line 4"),
        ("a.csv", "s,x,who\n0,1,12:00:00\n", "'12:00:00' in line 2"),
        ("a.json", '[{"s": 0, "x": 1, "who": "ego"}]', "'ego' at sample 0"),
        ("a.json", '{"s": [0, 1], "x": [1, 2], "who": [3, "on"]}', "'on' at sample 1"),
    ],
)
def test_columns_of_text_are_refused_by_formulas_that_read_them(
    tmp_path: Path, name: str, text: str, place: str
) -> None:
    path = tmp_path / name
    path.write_text(text)
    _, positions, signals = read_trace(path)
    assert stl.parse("x > 0").satisfied(positions, signals)
    with pytest.raises(DiagnosticError, match=rf"RL303.*`who` must be numbers, but is {place}"):
        stl.parse("who > 0").rho(positions, signals)


@pytest.mark.parametrize("column", ["x [m]", "x(m)", "x [km/h]"])
def test_a_column_whose_name_has_a_unit_is_named_as_it_has_to_be_written(column: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        stl.parse("x > 0").rho([0.0], {column: [1.0]})
    assert f"did you mean `` `{column}` `` (in back quotes)?" in str(caught.value)
    assert stl.parse(f"`{column}` > 0").satisfied([0.0], {column: [1.0]})


def test_a_name_with_a_unit_is_written_in_back_quotes() -> None:
    with pytest.raises(DiagnosticError, match=r"stands in back quotes: `` `x \[km/h\]` ``"):
        stl.parse("always (x [km/h] < 3)")


def test_missing_and_binary_files(tmp_path: Path) -> None:
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00")
    for name in ("missing.csv", "binary.csv"):
        with pytest.raises(DiagnosticError, match="RL340"):
            read_trace(tmp_path / name)


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1"])
def test_what_stands_around_the_numbers_does_not_matter(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "t.csv"
    path.write_bytes("# gemäß Protokoll\n\ns,größe\n# übrigens\n0,1\n\n2,3\n".encode(encoding))
    assert read_trace(path) == ("s", [0.0, 2.0], {"größe": [1.0, 3.0]})


def test_other_bytes_than_text_are_said_to_be_none(tmp_path: Path) -> None:
    path = tmp_path / "drive.csv"
    path.write_bytes(b"time,x\n0,1\n1,\xff\x00\n")
    with pytest.raises(DiagnosticError, match="it is not text"):
        read_trace(path)


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("deep.json", "[" * 100_000, "its JSON is nested too deeply"),
        ("scene.rl", "road main\n", "`roadlang run scene.rl -o DIR` writes traces"),
    ],
)
def test_what_is_no_trace_says_what_it_is(tmp_path: Path, name: str, text: str, told: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(DiagnosticError, match="RL340") as caught:
        stl.read_trace(tmp_path / name)
    assert told in str(caught.value)
