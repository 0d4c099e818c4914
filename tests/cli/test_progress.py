"""The progress bar: for people at terminals, once the work takes longer than a blink."""

from __future__ import annotations

import io

import pytest

from roadlang.cli import progress


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def shown_on(stream: io.StringIO, monkeypatch: pytest.MonkeyPatch, seconds: float) -> str:
    clock = iter([0.0, seconds, seconds + 1, seconds + 2])
    monkeypatch.setattr("roadlang.cli.progress.time.monotonic", lambda: next(clock))
    monkeypatch.setattr("roadlang.cli.progress.sys.stderr", stream)
    with progress.ProgressBar("scenes") as bar:
        bar(1, 2)
        bar(2, 2)
    return stream.getvalue()


def test_a_terminal_sees_how_far_the_work_is(monkeypatch: pytest.MonkeyPatch) -> None:
    words = shown_on(Terminal(), monkeypatch, seconds=5.0)
    assert "scenes [###############...............] 1/2" in words
    assert words.endswith("\r\x1b[K")


def test_quick_work_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = iter([0.0, 0.1, 0.2])
    monkeypatch.setattr("roadlang.cli.progress.time.monotonic", lambda: next(clock))
    stream = Terminal()
    monkeypatch.setattr("roadlang.cli.progress.sys.stderr", stream)
    with progress.ProgressBar("scenes") as bar:
        bar(1, 2)
    assert stream.getvalue() == ""


def test_a_file_or_pipe_sees_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    assert shown_on(io.StringIO(), monkeypatch, seconds=5.0) == ""
