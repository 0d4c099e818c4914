"""`roadlang monitor --follow` judges lines as they are written."""

from __future__ import annotations

import io
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.command_lines import Done, roadlang

LINES = "# a log\nt,x\n0,1\n1,2\n2,9\n3,1\n4,1\n5,1\n"


def followed_here(formula: str, text: str, monkeypatch: pytest.MonkeyPatch) -> Done:
    """In this process, which is started much sooner than another."""
    stream = io.TextIOWrapper(io.BytesIO(text.encode()), encoding="utf-8")
    monkeypatch.setattr(sys, "stdin", stream)
    return roadlang("monitor", formula, "-", "--follow", cwd=Path())


def follow(formula: str, text: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "roadlang", "monitor", formula, "-", "--follow"],
        input=text, capture_output=True, text=True, check=False,
    )  # fmt: skip


def test_changes_of_the_verdict_are_printed_once() -> None:
    ended = follow("historically[0, 1] (x < 5)", LINES)

    assert ended.stdout.splitlines() == [
        "historically[0, 1] (x < 5)",
        "0             holds     4",
        "2             violated  -4",
        "4             holds     4",
    ]
    assert ended.returncode == 4


def test_what_looks_ahead_is_decided_at_the_end_of_the_stream() -> None:
    ended = follow("eventually[0, 2] (x > 5)", LINES)

    assert [line.split() for line in ended.stdout.splitlines()[1:]] == [
        ["0", "holds", "4"],
        ["3", "violated", "-4"],
    ]


def test_lines_come_out_before_the_stream_ends(tmp_path: Path) -> None:
    """The file has no end: the line can only have come while it was being watched."""
    trace = tmp_path / "growing.csv"
    trace.write_text(LINES)
    process = subprocess.Popen(
        [sys.executable, "-m", "roadlang", "monitor", "once[0, 1] (x > 5)", str(trace), "--follow"],
        stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    assert process.stdout is not None
    seen = [process.stdout.readline() for _ in range(3)]
    with trace.open("a") as file:
        file.write("6,8")
        file.flush()
        file.write("\n")
    seen += [process.stdout.readline(), process.stdout.readline()]
    process.terminate()
    process.stdout.close()
    process.wait()

    assert [line.split()[:2] for line in seen[1:]] == [
        ["0", "violated"], ["2", "holds"], ["4", "violated"], ["6", "holds"],
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("formula", "text", "code"),
    [
        ("always (x < 1)", LINES, "RL309"),
        ("once (y < 1)", LINES, "RL304"),
        ("once (x < 1)", "t,x\n0,1\n1\n", "RL340"),
        ("once (x < 1)", "t,x\n0,1\n0,1\n", "RL301"),
        ("once (x < 1)", "t,x\n0,one\n", "RL303"),
        ("once (x < 1)", "t,x\none,0\n", "RL340"),
    ],
)
def test_streams_and_formulas_that_do_not_fit(
    formula: str, text: str, code: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    ended = followed_here(formula, text, monkeypatch)

    assert ended.returncode == 1
    assert f"error[{code}]" in ended.stderr
    assert "Traceback" not in ended.stderr


def test_follow_takes_one_trace() -> None:
    ended = roadlang("monitor", "x > 0", "a.csv", "b.csv", "--follow", cwd=Path())

    assert ended.returncode == 2
    assert "--follow takes one TRACE" in ended.stderr


def test_at_exactly_zero_the_comparison_decides() -> None:
    text = "time,x\n0,1\n1,0\n2,1\n"
    assert follow("x >= 0", text).stdout.splitlines()[1:] == ["0             holds     1"]
    ended = follow("x > 0", text)
    assert ended.stdout.splitlines()[1:] == [
        "0             holds     1",
        "1             violated  0",
        "2             holds     1",
    ]
    assert ended.returncode == 4
