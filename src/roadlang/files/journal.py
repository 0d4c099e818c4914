"""Files that grow a line at a time while work goes on, so that what is finished is kept."""

from __future__ import annotations

import json
import re
import zlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Generic, TypeVar

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from .locking import FileLock
from .not_written import not_written
from .writing import write_file

T = TypeVar("T")

SCHEMA = "roadlang.journal/1"
JOURNAL_FILE = "journal.jsonl"
"""Its name in the folder that `run` or `falsify` writes."""
UNUSABLE = (ValueError, KeyError, TypeError, AttributeError)
"""What reading a line raises that is no JSON, or of another form."""
_FIRST_LINE = 2
"""Number of the line below the header."""
_MOST_SHOWN = 5
_CHECKSUM = re.compile(rb',"checksum":"([0-9a-f]{8})"\}$')
_ANEW = "choose another folder with `-o`, or leave out `--resume` to start over"


def header_of(key: str) -> bytes:
    """The first line, without its end."""
    return json.dumps({"schema": SCHEMA, "key": key}).encode()


def with_checksum(line: bytes) -> bytes:
    """A JSON object with one more member, the CRC-32 of the others; another line as it is."""
    if not (line.startswith(b"{") and line.endswith(b"}") and len(line) > len(b"{}")):
        return line
    return b'%b,"checksum":"%08x"}' % (line[:-1], zlib.crc32(line[:-1]))


def unchanged(line: bytes) -> bytes:
    """The line without its checksum, if it has one. Raises ValueError where that differs."""
    found = _CHECKSUM.search(line)
    if found is None:
        return line
    written = line[: found.start()]
    if int(found[1], 16) != zlib.crc32(written):
        raise ValueError("it is not what was written: its checksum differs")
    return written + b"}"


class JournalFile(Generic[T]):
    """A header with a key, then lines of JSON with checksums. A line that was not finished is
    left out.

    `entries` are what `parse` makes of the lines of an earlier run with the same key, where
    `resume` says to go on with it; otherwise the file is begun anew. A line was changed if its
    checksum differs, or if `parse` refuses it with ValueError, KeyError, TypeError or
    AttributeError: it is taken out of the file, and `diagnostics` warns of it (RL724). Raises
    `DiagnosticError` RL702 where the file has another key, RL460 where it cannot be written, or
    another process writes it.
    """

    def __init__(self, path: Path, key: str, resume: bool, parse: Callable[[bytes], T]) -> None:
        self.path = path
        header = header_of(key)
        self.entries: list[T] = []
        self.diagnostics: tuple[Diagnostic, ...] = ()
        self._made_folders = [folder for folder in path.parents if not folder.exists()]
        """the innermost first"""
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            goes_on = resume and path.exists()
            self._lock = FileLock(path)
            if goes_on:
                self._read(header, parse)
                self._lock = FileLock(path)  # which may be another file of that name now
            else:
                path.write_bytes(header + b"\n")
        except BlockingIOError as error:
            raise DiagnosticError(
                diagnose(
                    Code.OUTPUT_NOT_WRITTEN,
                    path=str(path),
                    file=str(path),
                    reason="another `roadlang run` or `roadlang falsify` is writing it",
                    help="wait until it has finished, or choose another folder with `-o`",
                )
            ) from error
        except OSError as error:
            raise not_written(path, error) from error
        self._has_lines = bool(self.entries)

    @contextmanager
    def removed_if_nothing_is_finished(self, *beside: Path) -> Iterator[None]:
        """Where a `DiagnosticError` ends the work before there is a line, the file is removed again
        with others `beside` it, and the folders that were made for them."""
        try:
            yield
        except DiagnosticError:
            if not self._has_lines:
                with suppress(OSError):
                    for path in (self.path, *beside):
                        path.unlink(missing_ok=True)
                    for folder in self._made_folders:
                        folder.rmdir()
            raise

    def append(self, lines: Sequence[bytes]) -> None:
        """Write lines at once. Raises `DiagnosticError` RL460."""
        self._has_lines = self._has_lines or bool(lines)
        try:
            with self.path.open("ab") as file:
                file.write(b"".join(with_checksum(line) + b"\n" for line in lines))
        except OSError as error:
            raise not_written(self.path, error) from error

    def _read(self, header: bytes, parse: Callable[[bytes], T]) -> None:
        content = self.path.read_bytes()
        first, *lines = content.split(b"\n")
        if first != header:
            raise DiagnosticError(diagnose(Code.OTHER_JOURNAL, path=str(self.path), help=_ANEW))
        kept, damaged = [], []
        for number, line in enumerate(lines[:-1], _FIRST_LINE):
            try:
                self.entries.append(parse(unchanged(line)))
            except UNUSABLE:
                damaged.append(number)
            else:
                kept.append(line)
        whole = b"".join(line + b"\n" for line in (header, *kept))
        if whole != content:  # what was not finished would run into the next line
            write_file(self.path, whole)
        if damaged:
            self.diagnostics = (_damaged(self.path, damaged),)


def _damaged(path: Path, numbers: list[int]) -> Diagnostic:
    shown = ", ".join(map(str, numbers[:_MOST_SHOWN]))
    more = f" and {len(numbers) - _MOST_SHOWN} more" if len(numbers) > _MOST_SHOWN else ""
    where = f"line{'s' if len(numbers) > 1 else ''} {shown}{more}"
    return diagnose(Code.DAMAGED_JOURNAL, path=str(path), lines=where)


def read_lines(path: Path) -> list[tuple[int, bytes]]:
    """The finished lines of a journal, each with its number and checksum, whatever its key. Raises
    `OSError`, and `ValueError` for a file that is no journal."""
    first, *lines = path.read_bytes().split(b"\n")
    header = json.loads(first)
    if not isinstance(header, dict) or header.get("schema") != SCHEMA:
        raise ValueError("it is not a journal of roadlang")
    return list(enumerate(lines[:-1], _FIRST_LINE))
