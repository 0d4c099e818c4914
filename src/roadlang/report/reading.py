"""The files of results, read with diagnostics that name the file."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import msgspec

from ..diagnostics import Code, DiagnosticError, diagnose
from ..drive.standing import with_objects
from ..drive.trace_files import from_json
from ..files.journal import JOURNAL_FILE, UNUSABLE, read_lines, unchanged
from ..files.reading import UnreadableFile, read_file
from ..ir.encoding import scene_from_json
from ..ir.result_files import SCENE, TRACE
from ..ir.results_record import RESULTS_FILE, RESULTS_SCHEMA, ResultsRecord
from ..ir.scene import Scene
from ..ir.trace import Trace

T = TypeVar("T")


def read_record(folder: Path) -> ResultsRecord:
    """What the results in a folder were made from.

    Raises `DiagnosticError` RL720 where the folder has none.
    """
    path = folder / RESULTS_FILE
    if not os.path.isfile(path):
        raise _no_results(folder)
    return parsed(path, _record)


def _no_results(folder: Path) -> DiagnosticError:
    """What is there instead, and the folder that is meant, if one is near."""
    reason, help_ = f"there is no {RESULTS_FILE}", f"`roadlang run FILE -o {folder}` makes them"
    if os.path.isfile(folder):
        reason, help_ = "it is a file", "`roadlang run FILE -o DIR` makes a folder with results"
    elif not os.path.exists(folder):
        reason = "there is no such folder"
    if os.path.isfile(folder.parent / RESULTS_FILE):
        help_ = f"did you mean `{folder.parent}`?"
    elif os.path.isfile(folder / JOURNAL_FILE):
        help_ = "it was interrupted: run the same command again with `--resume`"
    return DiagnosticError(diagnose(Code.NO_RESULTS, path=str(folder), reason=reason, help=help_))


def read_drive(stem: Path) -> tuple[Scene, Trace]:
    """The scene `STEM.json` and its trace, with the objects that stand. Raises RL721."""
    scene = parsed(stem.with_name(f"{stem.name}{SCENE}"), scene_from_json)
    trace = parsed(stem.with_name(f"{stem.name}{TRACE}"), from_json)
    return scene, with_objects(trace, scene)


def read_journal(folder: Path, parse: Callable[[bytes], T]) -> list[T]:
    """What `parse` makes of the lines of the journal. Raises RL721, which names the line."""
    path, found = folder / JOURNAL_FILE, []
    try:
        lines = read_lines(path)
    except (OSError, ValueError) as error:
        raise broken(path, reason_of(error)) from error
    for number, line in lines:
        try:
            found.append(parse(unchanged(line)))
        except UNUSABLE as error:
            known = isinstance(error, KeyError | msgspec.ValidationError)
            reason = reason_of(error) if known else "it is not JSON that roadlang writes"
            fault = broken(path, f"line {number}: {reason}")
            raise fault from error
    return found


def read_typed(path: Path, kind: type[T]) -> T:
    """A JSON file as a dataclass; other members are left out. Raises RL721."""
    return parsed(path, lambda text: msgspec.json.decode(text, type=kind))


def parsed(path: Path, parse: Callable[[str], T]) -> T:
    """What `parse` makes of the text of a file. Raises RL721 for what it refuses."""
    try:
        return parse(read_file(path).decode("utf-8"))
    except UnreadableFile as error:
        raise broken(path, error.reason) from error
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise broken(path, reason_of(error)) from error


def reason_of(error: Exception) -> str:
    """What is wrong with the text, not what a parser says when it stumbles over that."""
    if isinstance(error, KeyError):
        return f"{str(error).replace(chr(39), '`')} is missing"
    if isinstance(error, json.JSONDecodeError):
        return f"it is not JSON from line {error.lineno}, column {error.colno} on"
    if isinstance(error, (TypeError, AttributeError, RecursionError)):
        return "its JSON does not have the form that roadlang writes"
    return str(error)


def broken(path: Path, reason: str) -> DiagnosticError:
    """RL721, to be raised."""
    has_command = any(os.path.isfile(folder / RESULTS_FILE) for folder in path.parents[:2])
    help: str | tuple[()] = ()
    if path.name == RESULTS_FILE:  # which has the command, but cannot be read
        help = "create the folder again, with the same command"
    elif has_command:
        help = f"create it again with the command in {RESULTS_FILE}"
    return DiagnosticError(diagnose(Code.BROKEN_RESULTS, path=str(path), reason=reason, help=help))


def _record(text: str) -> ResultsRecord:
    record = msgspec.json.decode(text, type=ResultsRecord)
    if record.schema != RESULTS_SCHEMA:
        raise ValueError(f"its schema is {record.schema!r}, not {RESULTS_SCHEMA!r}")
    return record
