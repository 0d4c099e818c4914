"""Tables of points as they are found in the wild."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.geometry import Curve, Road
from roadlang_standard.csv_table import read_table
from roadlang_standard.read_csv import Csv

RING = [(50 * np.cos(a), 50 * np.sin(a)) for a in np.linspace(0, 2 * np.pi, 40, endpoint=False)]


def read(folder: Path, text: str, **options: str) -> Curve | Road:
    path = folder / "road.csv"
    path.write_text(text)
    drawn: Curve | Road = Csv(**options).read(path)
    return drawn


@pytest.mark.parametrize(
    "text",
    [
        "x,y\n0,0\n50,0\n100,0\n",
        "0,0\n50,0\n100,0\n",
        "# x_m, y_m\n0,0\n50,0\n100,0\n",
        "x;y\n0;0\n50;0\n100;0\n",
        "x\ty\n0\t0\n50\t0\n100\t0\n",
        "0 0\n50 0\n100 0\n",
        "\ufeffy,x\n0,0\n0,50\n0,100\n",
        "x;y\n0,0;0\n49,5;0,0\n100,0;0\n",
        "x,y\r0,0\r50,0\r100,0\r",
        "X [m],Y (m)\n0,0\n50,0\n100,0\n",
        "name,x,y\nstart,0,0\n,50,0\nend,100,0\n",
        "x,y\nm,m\n0,0\n50,0\n100,0\n",
        "lap,x,y\nnan,0,0\nnan,50,0\ninf,100,0,\n",
    ],
)
def test_separators_and_heads_are_found_out(tmp_path: Path, text: str) -> None:
    curve = read(tmp_path, text)
    assert isinstance(curve, Curve)
    assert curve.length == pytest.approx(100)
    assert not curve.closed


@pytest.mark.parametrize(
    ("head", "names"),
    [
        ("", ("x", "y")),
        ("Y;X\n", ("y", "x")),
        ("# y_m; X_m\n", ("y_m", "x_m")),
        ("# y_m; x_m\n# drawn; twice\n", ("y_m", "x_m")),  # the first comment has them
        ("# y_m; x_m\nx; y\n", ("x", "y")),  # but a line of their own counts for more
        ("# 1; 2\n", ("x", "y")),  # a row that was left out
        ("The table of a track\n", ("x", "y")),  # a title
    ],
)
def test_names_are_in_the_first_comment_or_in_a_line_of_their_own(
    tmp_path: Path, head: str, names: tuple[str, ...]
) -> None:
    path = tmp_path / "road.csv"
    path.write_text(head + "1;2\n3;4\n")
    table = read_table(path)
    assert table.names == names
    assert table.rows.tolist() == [[1.0, 2.0], [3.0, 4.0]]


def test_a_table_may_be_in_utf_16(tmp_path: Path) -> None:
    path = tmp_path / "road.csv"
    path.write_bytes("x\ty\n0\t0\n50\t0\n100\t0\n".encode("utf-16"))
    assert read_table(path).rows.tolist() == [[0.0, 0.0], [50.0, 0.0], [100.0, 0.0]]


def test_widths_make_a_road(tmp_path: Path) -> None:
    road = read(tmp_path, "x,y,width\n0,0,6\n50,0,7\n100,0,8\n")
    assert isinstance(road, Road)
    assert road.width.at(75.0) == pytest.approx(7.5)


def test_racetracks_have_a_width_on_either_side(tmp_path: Path) -> None:
    rows = "\n".join(f"{x},{y},4.5,5.5" for x, y in RING)
    road = read(tmp_path, "# x_m,y_m,w_tr_right_m,w_tr_left_m\n" + rows)
    assert isinstance(road, Road)
    assert road.closed
    assert road.width.at(10.0) == pytest.approx(10)
    assert road.length == pytest.approx(2 * np.pi * 50, rel=1e-3)


@pytest.mark.parametrize("repeated", [False, True])
def test_widths_of_a_ring_stay_at_their_points(tmp_path: Path, repeated: bool) -> None:
    """From 4 m at the first of 40 points up by 10 cm each, whether the first is repeated or not."""
    rows = [f"{x},{y},{4 + number / 10}" for number, (x, y) in enumerate(RING)]
    rows += rows[:1] if repeated else []
    road = read(tmp_path, "x,y,width\n" + "\n".join(rows))
    assert isinstance(road, Road)
    assert road.closed
    at = road.length * np.array([0, 10, 20, 39]) / 40
    assert road.width.at(at) == pytest.approx([4, 5, 6, 7.9], abs=0.01)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("x,z\n0,0\n1,1\n", "no column `y`"),
        ("x,y\n0,0\n1,one\n", "`one` in line 3 is not a finite number"),
        ("x,y\n0,0\n1_000,1\n", "`1_000` in line 3"),
        ("x,y\n0,0\n0x10,1\n", "`0x10` in line 3"),
        ("x,y,name\n0,0,a\n1,,b\n", "an empty cell in line 3"),
        ("x,y\n0,0\n\uff11\uff12,1\n", "line 3"),
        ("x,y\n0,0,1,5\n50,0,2,5\n", "line 2 has 4 columns, not 2"),
        ("a; b; c\n1;2\n3;4\n", "line 2 has 2 columns, not 3"),
        ("x,y\n0,0\n1\n", "line 3 has 1 columns"),
        ("x,y\n0,0\n", "fewer than two rows"),
        ("x,y\n0,0\nnan,1\n", "in line 3 is not a finite number"),
        ("x,y\n0,0\n-Infinity,1\n", "in line 3 is not a finite number"),
        ("# nothing\n", "fewer than two rows"),
    ],
)
def test_what_is_no_table_is_refused(tmp_path: Path, text: str, says: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        read(tmp_path, text)
    assert caught.value.diagnostics[0].code == "RL477"
    assert says in caught.value.diagnostics[0].message


@pytest.mark.parametrize(("gap", "closed"), [(0.0, True), (1.5, True), (2.1, False), (2.5, False)])
def test_a_table_is_a_loop_where_the_gap_is_at_most_two_usual_steps(
    tmp_path: Path, gap: float, closed: bool
) -> None:
    """The usual step is 1 m; a single long one does not make the gap usual."""
    rows = [(float(x), 0.0) for x in range(21)] + [(20.0, float(y)) for y in range(1, 11)]
    rows += [(float(x), 10.0) for x in range(19, -1, -1)] + [(0.0, y) for y in (9.0, 2.0, gap)]
    text = "x,y\n" + "".join(f"{x},{y}\n" for x, y in rows)
    assert read(tmp_path, text).closed == closed


def test_widths_of_a_loop_stay_with_their_points(tmp_path: Path) -> None:
    """The last row is the first again: its width is not that of the point before it."""
    rows = [(x, y, 6.0 + index / 10) for index, (x, y) in enumerate(RING)]
    text = "x,y,width\n" + "".join(f"{x},{y},{width}\n" for x, y, width in [*rows, rows[0]])
    loop = read(tmp_path, text)
    assert isinstance(loop, Road)
    assert loop.closed
    quarter = loop.curve.length / 4
    assert loop.width.at(np.array([0.0, quarter, 2 * quarter])) == pytest.approx(
        [6, 7, 8], abs=0.05
    )
