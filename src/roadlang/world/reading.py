"""Files that `read` kinds turn into roads, networks and images."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, Span, diagnose
from ..evaluate.building import build
from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry import Curve, Road, RoadNetwork
from ..images.image_file import read_input
from ..ir.picture import Extraction
from ..ir.scenario import FileSource
from ..ir.values import PassCall
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.registry import KindEntry


def read_with(
    call: PassCall, source: FileSource, reads: str, scenario: IndexedScenario, span: Span | None
) -> Any:
    """What the reader of a call makes of a file."""
    only = CandidateBatch(scenario, 0, np.zeros(1, np.int64), np.zeros(1, np.int64))
    note_digest(source, scenario, call.span or span)
    built = build(call, only, single=True)
    with built.guarded:
        found = built.kind.read(Path(source.resolved))
    return checked_input(found, reads, built.entry, call.span or span)


def read_by_name(
    source: FileSource, reads: str, scenario: IndexedScenario, span: Span | None
) -> tuple[Any, KindEntry]:
    """What the reader of a file's ending makes of it. Raises RL410 when there is none."""
    ending = Path(source.path).suffix.lower()
    note_digest(source, scenario, span)
    known: set[str] = set()
    failures: list[DiagnosticError] = []
    for entry in scenario.registry.of("read"):
        try:
            with plugin_guard(entry, span):
                kind: Any = entry.load()
                suffixes = set(kind.suffixes) if reads in kind.reads else set()
        except DiagnosticError as failure:  # it may not be the reader that is wanted
            failures.append(failure)
            continue
        known |= suffixes
        if ending in suffixes:
            with plugin_guard(entry, span):
                found = kind().read(Path(source.resolved))
            return checked_input(found, reads, entry, span), entry
    if failures:
        raise failures[0]
    raise DiagnosticError(
        diagnose(
            Code.UNSUPPORTED_FILE_TYPE,
            span,
            file=source.path,
            what=reads,
            help=f"known endings: {', '.join(sorted(known))}; or name the reader: "
            "`{ read with ... }`",
        )
    )


def checked_input(found: Any, reads: str, entry: KindEntry, span: Span | None) -> Any:
    """What a reader gave, if it is what a statement can use. Raises RL474."""
    if reads == "road":
        fits, due = isinstance(found, Curve | Road), "a Curve or a Road"
    elif reads == "network":
        fits, due = isinstance(found, RoadNetwork | Extraction), "a RoadNetwork"
    else:
        fits, due = _is_picture(found), "an array (height, width, 3) of uint8"
    if not fits:
        raise wrong_result(entry, span, f"gave {_described(found)}, not {due}")
    return found


def _is_picture(found: Any) -> bool:
    if not isinstance(found, np.ndarray) or found.dtype != np.uint8 or 0 in found.shape:
        return False
    return found.ndim == 2 or (found.ndim == 3 and found.shape[2] >= 3)


def _described(found: Any) -> str:
    if isinstance(found, np.ndarray):
        return f"an array {found.shape} of {found.dtype}"
    return f"a {type(found).__name__}"


def note_digest(source: FileSource, scenario: IndexedScenario, span: Span | None) -> None:
    """Keep the sha256 of an input for the provenance. Raises RL400, RL401."""
    if source.path not in scenario.digests:
        content = read_input(Path(source.resolved), source.path, span)
        scenario.digests[source.path] = hashlib.sha256(content).hexdigest()
