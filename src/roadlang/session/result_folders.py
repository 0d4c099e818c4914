"""A folder holds the results of one command: those of another are never mixed with them."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from ..diagnostics import Code, DiagnosticError, diagnose
from ..falsification.journal import SearchJournal
from ..files.journal import JOURNAL_FILE, UNUSABLE, unchanged
from ..ir.manifest import MANIFEST_FILE
from ..ir.result_files import REPORT, REPORT_GENERATOR, numbered_runs
from ..ir.results_record import RESULTS_FILE
from .manifest_files import files_named_in

_HEAD = 1000
"""Bytes of a page that hold what made it."""
_OTHER = "choose another folder with `-o`, or remove that one if its results are no longer needed"


class Written(NamedTuple):
    """What a command wrote. `several`: a run for each map of `--params`, in folders of their
    own."""

    command: str
    several: bool = False

    def __str__(self) -> str:
        return f"`roadlang {self.command}{' --params' if self.several else ''}`"


def refuse_results_of_others(folder: Path, command: str, several: bool = False) -> None:
    """Raises `DiagnosticError` RL460 where a folder holds results of another command, or of one run
    where this one writes several. Results of the same command are replaced, or kept by
    `--resume`."""
    held = _written_in(folder)
    for path in numbered_runs(folder):
        held += [Written(one.command, True) for one in _written_in(path)]
    for one in held:
        if one != Written(command, several):
            file, reason = str(folder), f"it holds the results of {one}"
            raise DiagnosticError(
                diagnose(Code.OUTPUT_NOT_WRITTEN, path=file, file=file, reason=reason, help=_OTHER)
            )


def remove_report(folder: Path) -> None:
    """Remove the page that `roadlang report` made of earlier results; another page stays."""
    path = folder / REPORT
    with suppress(OSError):
        with path.open("rb") as file:
            is_ours = REPORT_GENERATOR.encode() in file.read(_HEAD)
        if is_ours:
            path.unlink()


def _written_in(folder: Path) -> list[Written]:
    journal = _command_of_journal(folder / JOURNAL_FILE)
    found = [] if journal is None else [Written(journal)]
    return [*found, Written("compile")] if _has_manifest(folder) else found


def _has_manifest(folder: Path) -> bool:
    with suppress(DiagnosticError):
        return bool(files_named_in(folder / MANIFEST_FILE))
    return False


def _command_of_journal(path: Path) -> str | None:
    """By its first line, as the whole may have millions; None where nothing is finished."""
    with suppress(OSError, *UNUSABLE), path.open("rb") as file:
        file.readline()  # the header
        entry = json.loads(unchanged(file.readline().rstrip(b"\n")))
        return "falsify" if "point" in entry else "run" if "row" in entry else None
    return None


def journal_of_search(folder: Path, key: str, resume: bool) -> SearchJournal:
    """The journal that a search begins or goes on with in a folder. What was made of its outcomes
    so far is no longer true of them: `provenance.json` is written again at the end.

    Raises `DiagnosticError` RL460 where the folder holds results of another command, and as
    `SearchJournal` does.
    """
    refuse_results_of_others(folder, "falsify")
    journal = SearchJournal(folder / JOURNAL_FILE, key, resume)
    (folder / RESULTS_FILE).unlink(missing_ok=True)
    remove_report(folder)
    return journal
