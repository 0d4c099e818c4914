"""Files that `read` kinds turn into roads, networks and images."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

from ..diagnostics import DiagnosticError, Span, diagnose
from ..ir.scenario import FileSource
from ..ir.values import PassCall
from ..plugins.registry import KindEntry
from .blame import blaming
from .building import build
from .image_file import read_input
from .plan import Plan
from .variants import Variants


def read_with(call: PassCall, source: FileSource, plan: Plan, span: Span | None) -> Any:
    """What the reader of a call makes of a file."""
    import numpy as np

    only = Variants(plan, 0, np.zeros(1, np.int64), np.zeros(1, np.int64))
    note_digest(source, plan, call.span or span)
    built = build(call, only, single=True)
    with built.blamed:
        return built.kind.read(Path(source.resolved))


def read_by_name(
    source: FileSource, reads: str, plan: Plan, span: Span | None
) -> tuple[Any, KindEntry]:
    """What the reader of a file's ending makes of it. Raises RL410 when there is none."""
    ending = Path(source.path).suffix.lower()
    note_digest(source, plan, span)
    for entry in plan.registry.of("read"):
        with blaming(entry, span):
            kind: Any = entry.load()
            fits = ending in kind.suffixes and reads in kind.reads
            if fits:
                return kind().read(Path(source.resolved)), entry
    known = sorted({s for e in plan.registry.of("read") for s in getattr(e.load(), "suffixes", ())})
    raise DiagnosticError(
        diagnose(
            "RL410",
            span,
            file=source.path,
            what=reads,
            help=f"known endings: {', '.join(known)}; or name the reader: `{{ read with ... }}`",
        )
    )


def note_digest(source: FileSource, plan: Plan, span: Span | None) -> None:
    """Keep the sha256 of an input for the provenance. Raises RL400, RL401."""
    if source.path not in plan.digests:
        content = read_input(Path(source.resolved), source.path, span)
        plan.digests[source.path] = hashlib.sha256(content).hexdigest()
