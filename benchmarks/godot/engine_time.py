"""CPU time of engines (Linux)."""

from __future__ import annotations

import os
from pathlib import Path

from roadlang_godot.engines.engine import Engine


def engine_seconds(running: Engine) -> float:
    """Of its process so far."""
    fields = Path(f"/proc/{running.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
