"""A journal grows line by line, and what is in it stays."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.files.journal import JournalFile, read_lines


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "journal.jsonl"


def test_a_resumed_journal_is_added_to_and_never_written_anew(path: Path) -> None:
    JournalFile(path, "key", resume=False).append([b"1", b"2"])
    inode, before = path.stat().st_ino, path.read_bytes()
    later = JournalFile(path, "key", resume=True)
    assert later.lines == [b"1", b"2"]
    assert path.read_bytes() == before
    later.append([b"3"])
    assert path.read_bytes() == before + b"3\n"
    assert path.stat().st_ino == inode


@pytest.mark.parametrize("cut", range(1, 8))
def test_a_line_that_was_not_finished_is_cut_off(path: Path, cut: int) -> None:
    JournalFile(path, "key", resume=False).append([b'{"a": 1}', b'{"b": 2}'])
    path.write_bytes(path.read_bytes()[:-cut])
    later = JournalFile(path, "key", resume=True)
    assert later.lines == [b'{"a": 1}']
    later.append([b'{"c": 3}'])
    assert JournalFile(path, "key", resume=True).lines == [b'{"a": 1}', b'{"c": 3}']


def test_a_journal_without_a_line_is_gone_on_with(path: Path) -> None:
    JournalFile(path, "key", resume=False)
    later = JournalFile(path, "key", resume=True)
    assert later.lines == []
    later.append([b"1"])
    assert JournalFile(path, "key", resume=True).lines == [b"1"]


def test_a_header_without_its_line_break_gets_one(path: Path) -> None:
    JournalFile(path, "key", resume=False)
    path.write_bytes(path.read_bytes().rstrip(b"\n"))
    JournalFile(path, "key", resume=True).append([b"1"])
    assert JournalFile(path, "key", resume=True).lines == [b"1"]


def test_the_journal_of_something_else_stays_as_it_is(path: Path) -> None:
    JournalFile(path, "key", resume=False).append([b"1"])
    before = path.read_bytes()
    with pytest.raises(DiagnosticError):
        JournalFile(path, "other", resume=True)
    assert path.read_bytes() == before


def test_lines_are_read_of_any_key_but_damaged_and_unfinished_ones_are_not(path: Path) -> None:
    JournalFile(path, "key", resume=False).append([b'{"a": 1}', b'{"b": 2}'])
    path.write_bytes(path.read_bytes() + b'{"c": \n{"d": 4}\n{"e": 5}')
    assert read_lines(path) == [b'{"a": 1}', b'{"b": 2}', b'{"d": 4}']


@pytest.mark.parametrize("header", [b'{"schema": "other"}', b"[]", b'"text"'])
def test_another_file_is_no_journal(path: Path, header: bytes) -> None:
    path.write_bytes(header + b'\n{"a": 1}\n')
    with pytest.raises(ValueError, match="it is not a journal of roadlang"):
        read_lines(path)
