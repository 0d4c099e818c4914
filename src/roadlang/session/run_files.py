"""The files of driven scenes, and the journal by which a run that was interrupted goes on."""

from __future__ import annotations

import contextlib
import dataclasses
import json
from collections.abc import Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..diagnostics import Diagnostic, DiagnosticError
from ..drive.input_files import input_files
from ..drive.reading_files import reading_files
from ..falsification.descriptors import measures, protagonist
from ..files.journal import JOURNAL_FILE, UNUSABLE, JournalFile, read_lines
from ..files.transaction import is_plain
from ..files.writing import write_all, write_file
from ..ir.manifest import MANIFEST_FILE
from ..ir.result_files import SCENE, TRACE, TRACE_TABLE
from ..ir.results_record import RESULTS_FILE
from ..ir.scene import file_stem
from ..scenes.emitting import outputs_of_drive
from .drives import Drive
from .falsification_files import FINDINGS
from .manifest import files_named_in

if TYPE_CHECKING:
    from ..evaluate.kind_instance import KindInstance
    from .drives import DriveSet

_ENDINGS = (SCENE, TRACE_TABLE, TRACE, ".verdicts.json", ".drive.svg")
_RESERVED = frozenset(ending[1:] for ending in (*_ENDINGS, *FINDINGS))
"""Endings that no backend can use."""


class RunFolder:
    """A folder of drives. `key` stands for all that they depend on, `provenance` says it to people;
    `resume`: what is there of an earlier run with the same key is kept; otherwise its files are
    removed. `backends` write files of drives beside the traces.

    `finished` holds the rows of scenes by their number. Raises `DiagnosticError` RL702 where the
    journal is that of another run, RL460 where nothing can be written.
    """

    def __init__(
        self,
        folder: Path,
        key: str,
        provenance: str,
        resume: bool,
        backends: Sequence[KindInstance] = (),
    ) -> None:
        self._folder = folder
        self._backends = backends
        earlier = [] if resume else _files_of_earlier_run(folder)
        self._journal = JournalFile(folder / JOURNAL_FILE, key, resume, _entry)
        for path in earlier:
            path.unlink(missing_ok=True)
        write_file(folder / RESULTS_FILE, provenance)
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

    def add(self, drives: DriveSet) -> None:
        """Write the files of drives, all of them or none, and then their lines in the journal."""
        recorded: list[dict[str, str | bytes]] = [
            {**reading_files(drive.readings), **input_files(drive.trace)} for drive in drives
        ]
        outputs = [
            outputs_of_drive(self._backends, drive.scene.record, drive.moving_trace,
                             _RESERVED | {ending.casefold() for ending in parts})
            for drive, parts in zip(drives, recorded, strict=True)
        ]  # fmt: skip
        written: list[list[str]] = []
        files: dict[str, str | bytes] = {}
        for drive, found, parts in zip(drives, outputs, recorded, strict=True):
            stem = drive.scene.record.stem
            traces = drive.scene.to_json(), drive.to_csv(), drive.to_json()
            contents = *traces, verdicts_json(drive), drive.svg()
            files |= {stem + end: text for end, text in zip(_ENDINGS, contents, strict=True)}
            beside: dict[str, str | bytes] = {output.path: output.content for output in found}
            beside |= {f"{stem}.{ending}": content for ending, content in parts.items()}
            files |= beside
            written.append(list(beside))
            for ending in FINDINGS:  # of an earlier drive
                (self._folder / (stem + ending)).unlink(missing_ok=True)
        write_all(self._folder, files)
        entries: list[dict[str, Any]] = [
            {
                "row": row,
                "record": record_of(drive),
                "measures": _measures(drive),
                "files": paths,
                "contacts": drive.has_unjudged_contacts,
            }
            for row, drive, paths in zip(drives.rows(), drives, written, strict=True)
        ]
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
        paths = [*(stem + end for end in _ENDINGS), *entry.get("files", ())]
        return all((self._folder / path).is_file() for path in paths)


def _files_of_earlier_run(folder: Path) -> list[Path]:
    """The files of the scenes that the journal in a folder names, but for those that `compile` has
    written there."""
    found: list[str] = []
    with contextlib.suppress(OSError, *UNUSABLE):
        for _, line in read_lines(folder / JOURNAL_FILE):
            entry = _entry(line)
            stem = file_stem(entry["row"]["scene"])
            found += [stem + ending for ending in (*_ENDINGS, *FINDINGS)]
            found += map(str, entry.get("files", ()))
    kept: set[str] = set()
    with contextlib.suppress(DiagnosticError):
        kept.update(files_named_in(folder / MANIFEST_FILE))
    return [folder / name for name in found if is_plain(name) and name not in kept]


def _entry(line: bytes) -> Mapping[str, Any]:
    """A line of the journal, with what is read of it."""
    entry: Mapping[str, Any] = json.loads(line)
    if not isinstance(entry["row"]["scene"], int) or not entry["record"].keys() >= {"expectations"}:
        raise ValueError("its JSON does not have the form that roadlang writes")
    return entry


def record_of(drive: Drive) -> dict[str, Any]:
    """How the expectations came out, and which controllers failed, where any did."""
    failures = [dataclasses.asdict(failure) for failure in drive.trace.controller_failures]
    return {
        "scene": drive.scene.index,
        "name": drive.scene.name,
        "expectations": [
            {"name": v.name, "text": v.text, "robustness": v.robustness, "satisfied": v.satisfied}
            for v in drive.verdicts.values()
        ],
        **({"controller_failures": failures} if failures else {}),
    }


def _measures(drive: Drive) -> dict[str, float | None]:
    """What coverage is counted of."""
    scene = drive.scene.record
    return measures(scene, drive.trace, protagonist(scene, list(drive.verdicts)))


def verdicts_json(drive: Drive) -> str:
    """`record_of` as a file."""
    return json.dumps(record_of(drive), indent=2) + "\n"
