"""The files of driven scenes, and the journal by which a run that was interrupted goes on."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..diagnostics import Diagnostic
from ..files.journal import JOURNAL_FILE, UNUSABLE, JournalFile, read_lines
from ..files.staging import staging_folder
from ..files.transaction import is_plain
from ..files.writing import reported, write_all, write_file
from ..ir.results_record import RESULTS_FILE
from ..ir.scene import file_stem
from ..scenes.emitted import Stager, held
from .falsification_files import FINDINGS
from .finished_drives import ENDINGS, FinishedDrive
from .result_folders import remove_report

if TYPE_CHECKING:
    from ..search.worker_pool import Workers


class RunFolder:
    """A folder of drives. `key` stands for all that they depend on, `provenance` says it to people;
    `resume`: what is there of an earlier run with the same key is kept; otherwise its files are
    removed.

    `finished` holds the rows of scenes by their number. Raises `DiagnosticError` RL702 where the
    journal is that of another run, RL460 where nothing can be written.
    """

    def __init__(
        self,
        folder: Path,
        key: str,
        provenance: str,
        resume: bool,
    ) -> None:
        self._folder = folder
        earlier = [] if resume else _files_of_drives(folder)
        self._journal = JournalFile(folder / JOURNAL_FILE, key, resume, _entry)
        for path in earlier:
            path.unlink(missing_ok=True)
        remove_report(folder)
        write_file(folder / RESULTS_FILE, provenance)
        self._findings = {name for name in os.listdir(folder) if name.endswith(FINDINGS)}
        """of earlier drives: nobody else writes here while the journal is locked"""
        self.finished: dict[int, Mapping[str, Any]] = {
            entry["row"]["scene"]: entry
            for entry in self._journal.entries
            if self._has_files(entry)
        }

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """A warning of lines of the journal that cannot be read (RL724)."""
        return self._journal.diagnostics

    def removed_if_nothing_is_driven(self) -> AbstractContextManager[None]:
        """Where a `DiagnosticError` ends the run before a drive is finished, nothing is left."""
        return self._journal.removed_if_nothing_is_finished(self._folder / RESULTS_FILE)

    def staging(self, workers: Workers) -> AbstractContextManager[Stager]:
        """How drives hand over the contents of their files: workers that see this folder stage them
        in it, and at the end those that were not added are removed; others send them."""
        return self._staging() if workers.write_here else contextlib.nullcontext(held)

    @contextlib.contextmanager
    def _staging(self) -> Iterator[Stager]:
        with staging_folder(self._folder) as room:
            yield room.stage

    def add(self, drives: Sequence[FinishedDrive]) -> None:
        """Write the files of drives, all of them or none, and then their lines in the journal."""
        names = (file_stem(drive.line.scene) + ending for drive in drives for ending in FINDINGS)
        for name in self._findings.intersection(names):
            (self._folder / name).unlink(missing_ok=True)
        write_all(self._folder, {n: c for drive in drives for n, c in drive.files.items()})
        entries = [drive.entry for drive in drives]
        self._journal.append([json.dumps(entry).encode() for entry in entries])
        self.finished |= {entry["row"]["scene"]: entry for entry in entries}

    def rows(self, scenes: Iterable[int]) -> list[dict[str, Any]]:
        """The rows of scenes, in their order."""
        return [dict(self.finished[number]["row"]) for number in scenes]

    def records(self, scenes: Iterable[int]) -> list[dict[str, Any]]:
        """The verdicts of scenes, in their order."""
        return [dict(self.finished[number]["record"]) for number in scenes]

    def contacts(self, scenes: Iterable[int]) -> int:
        """In how many of these scenes agents touch something, and no expectation is violated."""
        return sum(bool(self.finished[number].get("contacts")) for number in scenes)

    def _has_files(self, entry: Mapping[str, Any]) -> bool:
        stem = file_stem(entry["row"]["scene"])
        paths = [*(stem + end for end in ENDINGS), *entry.get("files", ())]
        return all((self._folder / path).is_file() for path in paths)


def remove_run(folder: Path) -> None:
    """Remove what a run wrote into a folder, and the folder where nothing else is in it."""
    found = [*_files_of_drives(folder), folder / RESULTS_FILE, folder / JOURNAL_FILE]
    with reported(folder):
        for path in found:
            path.unlink(missing_ok=True)
    remove_report(folder)
    with contextlib.suppress(OSError):
        folder.rmdir()


def _files_of_drives(folder: Path) -> list[Path]:
    """The files of the scenes that the journal in a folder names."""
    found: list[str] = []
    with contextlib.suppress(OSError, *UNUSABLE):
        for _, line in read_lines(folder / JOURNAL_FILE):
            entry = _entry(line)
            stem = file_stem(entry["row"]["scene"])
            found += [stem + ending for ending in (*ENDINGS, *FINDINGS)]
            found += map(str, entry.get("files", ()))
    return [folder / name for name in found if is_plain(name)]


def _entry(line: bytes) -> Mapping[str, Any]:
    """A line of the journal, with what is read of it."""
    entry: Mapping[str, Any] = json.loads(line)
    if not isinstance(entry["row"]["scene"], int) or not entry["record"].keys() >= {"expectations"}:
        raise ValueError("its JSON does not have the form that roadlang writes")
    return entry
