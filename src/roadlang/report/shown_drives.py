"""A drive that the page shows: its files, judged again."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..judging.drives import judge
from ..plugins.registry import Registry
from .reading import read_drive
from .results import ShownDrive

MOST_FAILING, MOST_SAFE = 100, 12
"""Drives that are shown in full."""


def shown_drive(
    folder: Path,
    name: str,
    label: str,
    row: int,
    has_failed: bool,
    registry: Registry,
    shrunk: Mapping[str, Any] | None = None,
    explanation: Mapping[str, Any] | None = None,
) -> ShownDrive:
    """The drive with the files `folder/name.*`. Raises `DiagnosticError` RL721."""
    scene, trace = read_drive(folder / name)
    verdicts = judge(scene, trace, registry).verdicts
    return ShownDrive(name, label, row, scene, trace, verdicts, has_failed, shrunk, explanation)
