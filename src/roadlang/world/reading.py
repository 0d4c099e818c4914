"""Files that `read` kinds turn into roads, networks and images."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, Span, diagnose
from ..evaluate.candidates import fixed_candidate
from ..evaluate.evaluation import build
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry import Curve, Road, RoadNetwork
from ..images.image_file import read_input
from ..ir.picture import Extraction
from ..ir.scenario import FileSource, Input
from ..ir.values import PassCall
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.registry import KindEntry


@dataclass(frozen=True, eq=False)
class FileContent:
    """What a reader made of a file, and the file with its digest."""

    value: Any
    input: Input


def read_file(
    source: FileSource,
    reads: str,
    passes: tuple[PassCall, ...],
    scenario: IndexedScenario,
    span: Span | None,
) -> FileContent:
    """What a file holds: by the `read with` among `passes`, else by the ending of its name.

    `reads` is what the statement declares: "image", "network" or "road". Raises RL400 and RL401
    for a file that cannot be read, RL214 where no reader takes it, RL474 for a wrong result.
    """
    reading = [call for call in passes if call.verb == "read"]
    if reading:
        return _read_with(reading[0], source, reads, scenario, span)
    return _read_by_name(source, reads, scenario, span)


def _read_with(
    call: PassCall, source: FileSource, reads: str, scenario: IndexedScenario, span: Span | None
) -> FileContent:
    input = _input_of(source, scenario, call.span or span)
    built = build(call, fixed_candidate(scenario), single=True)
    with built.guarded:
        found = built.kind.read(Path(source.resolved))
    return FileContent(checked_input(found, reads, built.entry, call.span or span), input)


def _read_by_name(
    source: FileSource, reads: str, scenario: IndexedScenario, span: Span | None
) -> FileContent:
    ending = Path(source.path).suffix.lower()
    input = _input_of(source, scenario, span)
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
            return FileContent(checked_input(found, reads, entry, span), input)
    if failures:
        raise failures[0]
    raise DiagnosticError(
        diagnose(
            Code.NO_READER,
            span,
            file=source.path,
            role=reads,
            suffix=f"`{ending}`",
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


def _input_of(source: FileSource, scenario: IndexedScenario, span: Span | None) -> Input:
    """The file with its sha256, read once for all candidates."""

    def make() -> Input:
        content = read_input(Path(source.resolved), source.path, span)
        return Input(source.path, hashlib.sha256(content).hexdigest())

    return scenario.once(("input", source.resolved), make)
