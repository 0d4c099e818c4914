"""The files that the manifest of an earlier compilation names."""

from __future__ import annotations

import json
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose
from ..files.reading import UnreadableFile, read_file
from ..ir.manifest import MANIFEST_SCHEMA


def files_named_in(path: Path) -> list[str]:
    """The files that an earlier manifest names. Raises `DiagnosticError` RL460 for another file
    of this name: what roadlang has not written, it does not replace."""
    try:
        record = json.loads(read_file(path))
        schema = str(record["schema"])
        if not schema.startswith(MANIFEST_SCHEMA.rpartition("/")[0]):
            raise ValueError(schema)
        return [str(file["path"]) for file in record["files"]]
    except (UnreadableFile, ValueError, KeyError, TypeError, RecursionError):
        reason = "it already exists and was not written by roadlang"
        raise DiagnosticError(
            diagnose(
                Code.OUTPUT_NOT_WRITTEN,
                path=str(path),
                file=str(path),
                reason=reason,
                help="move it away, or write into another folder with `-o`",
            )
        ) from None
