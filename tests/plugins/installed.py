"""Installs a plugin for one test: its module and its metadata in a folder of `sys.path`."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path


def install(
    folder: Path,
    name: str,
    text: str,
    *,
    name_of_entry: str | None = None,
    commands: str = "",
    kinds: str = "",
    requires: str = "",
) -> None:
    """What pip leaves behind: `roadlang_NAME.py` and a dist-info with the entry point NAME.

    `commands` are lines of the entry points `roadlang.commands`, `requires` is a requirement.
    `kinds` are lines of `roadlang.kinds.NAME`, which then take the place of the entry point NAME.
    """
    module = f"roadlang_{name}"
    (folder / f"{module}.py").write_text(text)
    info = folder / f"{name}_plugin-1.2.dist-info"
    info.mkdir()
    metadata = f"Metadata-Version: 2.1\nName: {name}-plugin\nVersion: 1.2\n"
    metadata += f"Requires-Dist: {requires}\n" if requires else ""
    (info / "METADATA").write_text(metadata)
    entry = name_of_entry or name
    points = (
        f"[roadlang.kinds.{entry}]\n{kinds}\n" if kinds else f"[roadlang]\n{entry} = {module}\n"
    )
    points += f"[roadlang.commands]\n{commands}\n" if commands else ""
    (info / "entry_points.txt").write_text(points)


def start(folder: Path, *arguments: str) -> subprocess.Popen[str]:
    """A real `roadlang` process with the plugins of `folder`, in that folder."""
    return subprocess.Popen(
        [sys.executable, "-m", "roadlang", *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(folder), "MARKER": str(folder / "reached")},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
