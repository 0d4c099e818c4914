"""What is kept of a drive once its files are made: enough for the journal, tables and lines."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any

from ..drive.batches import DriveTask
from ..drive.input_files import input_files
from ..drive.reading_files import reading_files
from ..falsification.descriptors import measures, protagonist
from ..ir.result_files import SCENE, TRACE, TRACE_TABLE
from ..scenes.emitted import Stager, held, outcome_of
from ..scenes.emitting import outputs_of_drive
from .drives import Drive, DriveSet
from .falsification_files import FINDINGS
from .scene import Scene

if TYPE_CHECKING:
    from ..diagnostics import Diagnostic
    from ..evaluate.kind_instance import KindInstance
    from ..ir.controller_failure import ControllerFailure
    from ..ir.scene import Scene as SceneRecord
    from ..ir.scene import Verdict
    from .loading import LoadedScenario

ENDINGS = (SCENE, TRACE_TABLE, TRACE, ".verdicts.json", ".drive.svg")
"""Of the files of every drive."""
_RESERVED = frozenset(ending[1:] for ending in (*ENDINGS, *FINDINGS))
"""Endings that no backend can use."""


@dataclass(frozen=True)
class FirstContact:
    """When two agents first touched."""

    agent: str
    other: str
    time: float
    """seconds"""


@dataclass(frozen=True)
class DriveLine:
    """What is printed of a drive in a line or two."""

    scene: int
    engine: str
    duration: float | None
    """seconds; None where nothing was driven"""
    verdicts: tuple[Verdict, ...]
    worst: Verdict | None
    worst_time: float | None
    """seconds; None where no moment decides the worst expectation"""
    worst_station: float | None
    worst_road: str
    """where that is decided on a road, whatever drives; else empty"""
    first_time: float | None
    """when the worst expectation first went wrong, where that is another moment"""
    contacts: tuple[FirstContact, ...]
    """of each pair the first, where no expectation is violated"""
    failures: tuple[ControllerFailure, ...]


@dataclass(frozen=True)
class FinishedDrive:
    """`entry` is its line of the journal: row, verdicts, measures and the files beside the usual
    ones; `files` by name are contents, or where these were staged."""

    entry: Mapping[str, Any]
    files: Mapping[str, bytes | PathLike[str]]
    line: DriveLine
    diagnostics: tuple[Diagnostic, ...]


@dataclass(frozen=True)
class DriveFinishing:
    """Drives scenes and makes their files: what each worker holds. `backends` write files of drives
    beside the traces; `loaded` is the scenario of the scenes, if there is one."""

    task: DriveTask
    loaded: LoadedScenario | None = None
    backends: Sequence[KindInstance] = ()
    stage: Stager = held

    def finish(self, records: Sequence[SceneRecord]) -> list[FinishedDrive]:
        """Drive some scenes, and stage their files where all are made."""
        drives = [
            Drive(Scene(record, self.loaded), driven, self.task.places)
            for record, driven in zip(records, self.task.drive(records), strict=True)
        ]
        return finished(drives, self.backends, self.stage)


def finished(
    drives: Sequence[Drive], backends: Sequence[KindInstance] = (), stage: Stager = held
) -> list[FinishedDrive]:
    """Drives with their files. Raises `DiagnosticError` for what a backend does wrong."""
    beside = [_files_beside(drive, backends) for drive in drives]
    rows = DriveSet(iter(drives)).rows()
    return [_finished(*each, stage) for each in zip(drives, beside, rows, strict=True)]


def _files_beside(drive: Drive, backends: Sequence[KindInstance]) -> dict[str, bytes]:
    """By name: what sensors measured, what humans wanted, and what backends write."""
    record = drive.scene.record
    files = reading_files(drive.readings), input_files(drive.trace)
    recorded: dict[str, str | bytes] = {**files[0], **files[1]}
    reserved = _RESERVED | {ending.casefold() for ending in recorded}
    outputs = outputs_of_drive(backends, record, drive.moving_trace, reserved)
    found = {output.path: output.content for output in outputs}
    return found | {f"{record.stem}.{ending}": _data(text) for ending, text in recorded.items()}


def _finished(
    drive: Drive, beside: Mapping[str, bytes], row: dict[str, Any], stage: Stager
) -> FinishedDrive:
    record = record_of(drive)
    verdicts = json.dumps(record, indent=2) + "\n"
    texts = drive.scene.to_json(), drive.to_csv(), drive.to_json(), verdicts, drive.svg()
    names = [drive.scene.record.stem + ending for ending in ENDINGS]
    contents = {**dict(zip(names, map(_data, texts), strict=True)), **beside}
    entry = {
        "row": row,
        "record": record,
        "measures": _measures(drive),
        "files": list(beside),
        "contacts": drive.has_unjudged_contacts,
    }
    files = {name: stage(content) for name, content in contents.items()}
    return FinishedDrive(entry, files, line_of(drive), drive.diagnostics)


def _data(text: str | bytes) -> bytes:
    return text.encode() if isinstance(text, str) else text


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


def line_of(drive: Drive) -> DriveLine:
    """What is printed of a drive."""
    worst, moment, first = drive.worst, drive.worst_moment, drive.first_violation
    times, time, station = drive.trace.time, None, None
    tightest = None if worst is None else worst.tightest
    if tightest is not None:
        station = tightest.station
    elif moment is not None and moment.actors:
        time = float(times[moment.sample])
        station = float(moment.actors[0].station[moment.sample])
    is_other = first is not None and moment is not None and first.sample != moment.sample
    return DriveLine(
        drive.scene.index,
        drive.engine,
        drive.duration if len(times) else None,
        tuple(map(outcome_of, drive.verdicts.values())),
        None if worst is None else outcome_of(worst),
        time,
        station,
        "" if tightest is None else tightest.road,
        float(times[first.sample]) if is_other and first is not None else None,
        _contacts(drive) if drive.has_unjudged_contacts else (),
        drive.trace.controller_failures,
    )


def _contacts(drive: Drive) -> tuple[FirstContact, ...]:
    found: dict[frozenset[str], FirstContact] = {}
    for event in drive.trace.events:
        if event["event"] == "contact":
            agent, other = event["agent"], event["other"]
            found.setdefault(frozenset((agent, other)), FirstContact(agent, other, event["time"]))
    return tuple(found.values())
