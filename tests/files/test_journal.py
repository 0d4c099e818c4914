"""A journal grows line by line, and what is in it stays."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from roadlang.diagnostics import Code, DiagnosticError, diagnose
from roadlang.files.journal import JournalFile, read_lines, with_checksum


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "journal.jsonl"


def test_a_resumed_journal_is_added_to_and_never_written_anew(path: Path) -> None:
    JournalFile(path, "key", resume=False, parse=bytes).append([b"1", b"2"])
    inode, before = path.stat().st_ino, path.read_bytes()
    later = JournalFile(path, "key", resume=True, parse=bytes)
    assert later.entries == [b"1", b"2"]
    assert path.read_bytes() == before
    later.append([b"3"])
    assert path.read_bytes() == before + b"3\n"
    assert path.stat().st_ino == inode


@pytest.mark.parametrize("cut", range(1, 8))
def test_a_line_that_was_not_finished_is_cut_off(path: Path, cut: int) -> None:
    JournalFile(path, "key", resume=False, parse=bytes).append([b'{"a": 1}', b'{"b": 2}'])
    path.write_bytes(path.read_bytes()[:-cut])
    later = JournalFile(path, "key", resume=True, parse=bytes)
    assert later.entries == [b'{"a": 1}']
    later.append([b'{"c": 3}'])
    assert JournalFile(path, "key", resume=True, parse=bytes).entries == [b'{"a": 1}', b'{"c": 3}']


def test_a_journal_without_a_line_is_gone_on_with(path: Path) -> None:
    JournalFile(path, "key", resume=False, parse=bytes)
    later = JournalFile(path, "key", resume=True, parse=bytes)
    assert later.entries == []
    later.append([b"1"])
    assert JournalFile(path, "key", resume=True, parse=bytes).entries == [b"1"]


def test_a_header_without_its_line_break_gets_one(path: Path) -> None:
    JournalFile(path, "key", resume=False, parse=bytes)
    path.write_bytes(path.read_bytes().rstrip(b"\n"))
    JournalFile(path, "key", resume=True, parse=bytes).append([b"1"])
    assert JournalFile(path, "key", resume=True, parse=bytes).entries == [b"1"]


def test_the_journal_of_something_else_stays_as_it_is(path: Path) -> None:
    JournalFile(path, "key", resume=False, parse=bytes).append([b"1"])
    before = path.read_bytes()
    with pytest.raises(DiagnosticError):
        JournalFile(path, "other", resume=True, parse=bytes)
    assert path.read_bytes() == before


def test_lines_are_read_of_any_key_but_unfinished_ones_are_not(path: Path) -> None:
    JournalFile(path, "key", resume=False, parse=bytes).append([b'{"a": 1}', b"{"])
    path.write_bytes(path.read_bytes() + b'{"e": 5}')
    assert read_lines(path) == [(2, with_checksum(b'{"a": 1}')), (3, b"{")]


@pytest.mark.parametrize("damage", [b'{"c": ', b"{}", b'"text"', b'{"a": "b"}', b""])
def test_damaged_lines_are_told_and_taken_out(path: Path, damage: bytes) -> None:
    def parse(line: bytes) -> int:
        return int(json.loads(line)["a"]) + 0

    JournalFile(path, "key", False, parse).append([b'{"a": 1}', damage, b'{"a": 3}'])
    later = JournalFile(path, "key", True, parse)
    assert later.entries == [1, 3]
    (warning,) = later.diagnostics
    assert warning.code == "RL724"
    assert "line 3 of" in warning.message
    assert JournalFile(path, "key", True, parse).diagnostics == ()
    kept = [with_checksum(line) for line in (b'{"a": 1}', b'{"a": 3}')]
    assert read_lines(path) == [*enumerate(kept, 2)]


def test_a_line_that_still_is_json_but_was_changed_is_taken_out(path: Path) -> None:
    """A digit of a result, which nothing but a checksum tells."""
    lines = [b'{"a": 1, "robustness": -0.25}', b'{"a": 2}']
    JournalFile(path, "key", False, json.loads).append(lines)
    path.write_bytes(path.read_bytes().replace(b"-0.25", b"-0.35"))
    later = JournalFile(path, "key", True, json.loads)
    assert [entry["a"] for entry in later.entries] == [2]
    assert "line 2 of" in later.diagnostics[0].message


def test_lines_without_a_checksum_are_read(path: Path) -> None:
    JournalFile(path, "key", False, bytes)
    path.write_bytes(path.read_bytes() + b'{"a": 1}\n')
    later = JournalFile(path, "key", True, json.loads)
    assert (later.entries, later.diagnostics) == ([{"a": 1}], ())


@pytest.mark.parametrize("header", [b'{"schema": "other"}', b"[]", b'"text"'])
def test_another_file_is_no_journal(path: Path, header: bytes) -> None:
    path.write_bytes(header + b'\n{"a": 1}\n')
    with pytest.raises(ValueError, match="it is not a journal of roadlang"):
        read_lines(path)


@pytest.mark.skipif(sys.platform == "win32", reason="files are not locked there")
@pytest.mark.parametrize("resume", [False, True])
def test_a_journal_that_another_process_writes_is_left_alone(path: Path, resume: bool) -> None:
    import fcntl

    JournalFile(path, "key", resume=False, parse=bytes).append([b"1"])
    before = path.read_bytes()
    with path.open("rb") as other:  # a lock of another open file is as that of another process
        fcntl.flock(other, fcntl.LOCK_EX)
        with pytest.raises(DiagnosticError, match="another `roadlang run`") as caught:
            JournalFile(path, "key", resume=resume, parse=bytes)
        assert caught.value.diagnostics[0].code == "RL460"
        assert path.read_bytes() == before
    JournalFile(path, "key", resume=True, parse=bytes).append([b"2"])


def test_journals_of_one_process_are_not_in_the_way_of_each_other(path: Path) -> None:
    first = JournalFile(path, "key", resume=False, parse=bytes)
    first.append([b"1"])
    assert JournalFile(path, "key", resume=True, parse=bytes).entries == [b"1"]


FAULT = DiagnosticError(diagnose(Code.NOTHING_TO_SEARCH))


def ended(journal: JournalFile[bytes], beside: Path, error: Exception = FAULT) -> None:
    beside.write_text("{}")
    with pytest.raises(type(error)), journal.removed_if_nothing_is_finished(beside):
        raise error


def test_an_error_before_the_first_line_leaves_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "deep"
    journal = JournalFile(folder / "journal.jsonl", "key", resume=False, parse=bytes)
    ended(journal, folder / "provenance.json")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("notes", [["notes.txt"], []])
def test_a_folder_that_was_there_stays_and_what_is_in_it(path: Path, notes: list[str]) -> None:
    for name in notes:
        (path.parent / name).write_text("mine")
    journal = JournalFile(path, "key", resume=False, parse=bytes)
    ended(journal, path.parent / "provenance.json")
    assert [each.name for each in path.parent.iterdir()] == notes


@pytest.mark.parametrize("resume", [False, True])
def test_an_error_after_the_first_line_leaves_all(path: Path, resume: bool) -> None:
    journal = JournalFile(path, "key", resume=False, parse=bytes)
    journal.append([b"1"])
    if resume:
        journal = JournalFile(path, "key", resume=True, parse=bytes)
    ended(journal, path.parent / "provenance.json")
    assert path.read_bytes().endswith(b"\n1\n")
    assert (path.parent / "provenance.json").exists()


def test_an_interruption_leaves_a_journal_to_go_on_with(path: Path) -> None:
    journal = JournalFile(path, "key", resume=False, parse=bytes)
    ended(journal, path.parent / "provenance.json", RuntimeError())
    assert path.exists()
