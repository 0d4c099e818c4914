"""Files that grow a line at a time while work goes on, so that what is finished is kept."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose
from .not_written import not_written

SCHEMA = "roadlang.journal/1"
JOURNAL_FILE = "journal.jsonl"
"""Its name in the folder that `run` or `falsify` writes."""
_ANEW = "choose another folder with `-o`, or leave out `--resume` to start over"


class JournalFile:
    """A header with a key, then lines of JSON. A line that was not finished is left out.

    `lines` are those of an earlier run with the same key, where `resume` says to go on with it;
    otherwise the file is begun anew. Raises `DiagnosticError` RL702 where the file has another key,
    RL460 where it cannot be written.
    """

    def __init__(self, path: Path, key: str, resume: bool) -> None:
        self.path = path
        header = json.dumps({"schema": SCHEMA, "key": key}).encode()
        self.lines: list[bytes] = []
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            if resume and path.exists():
                self.lines = _finished(path, header)
            else:
                path.write_bytes(header + b"\n")
        except OSError as error:
            raise not_written(path, error) from error

    def append(self, lines: Sequence[bytes]) -> None:
        """Write lines at once. Raises `DiagnosticError` RL460."""
        try:
            with self.path.open("ab") as file:
                file.write(b"".join(line + b"\n" for line in lines))
        except OSError as error:
            raise not_written(self.path, error) from error


def read_lines(path: Path) -> list[bytes]:
    """The finished lines of a journal, whatever its key. Raises `OSError`, and `ValueError` for a
    file that is no journal."""
    first, *lines = path.read_bytes().split(b"\n")
    header = json.loads(first)
    if not isinstance(header, dict) or header.get("schema") != SCHEMA:
        raise ValueError("it is not a journal of roadlang")
    return [line for line in lines[:-1] if _is_json(line)]


def _finished(path: Path, header: bytes) -> list[bytes]:
    """The finished lines below the header. Only a line without its end is cut off: it would run
    into the next one."""
    content = path.read_bytes()
    first, *lines = content.split(b"\n")
    if first != header:
        raise DiagnosticError(diagnose(Code.OTHER_JOURNAL, path=str(path), help=_ANEW))
    if not lines:
        with path.open("ab") as file:
            file.write(b"\n")
    elif lines[-1]:
        os.truncate(path, len(content) - len(lines[-1]))
    return [line for line in lines[:-1] if _is_json(line)]


def _is_json(line: bytes) -> bool:
    try:
        json.loads(line)
    except ValueError:
        return False
    return True
