"""Recorded drives: tables of time, x, y and heading, and traces of drives."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roadlang.api import Code, DiagnosticError, diagnose, did_you_mean, read_input

if TYPE_CHECKING:
    from roadlang.geometry import Floats

_NEEDED = ("time", "x", "y", "heading")
_AT_ONCE = 16
"""Files that are remembered."""


@dataclass(frozen=True)
class Recording:
    """Poses (T, 4), x, y, heading and speed, at times (T,) that increase."""

    time: Floats
    pose: Floats

    def at(self, time: float) -> Floats:
        """(4,) the pose at a time; after the end the last one, standing."""
        import numpy as np

        found = np.array([np.interp(time, self.time, column) for column in self.pose.T])
        if time > self.time[-1]:
            found[3] = 0.0
        return found


def recording(path: str, agent: str) -> Recording:
    """What a file has of an agent; of a table without names, all of it. Raises RL477."""
    file = Path(path)
    found = _recordings(path, file.stat().st_mtime_ns)
    if "" in found:
        return found[""]
    if agent not in found:
        help_ = (*did_you_mean(agent, list(found)), f"it has {', '.join(found)}")
        raise _fault(file, f"it has no agent `{agent}`", help_)
    return found[agent]


@lru_cache(maxsize=_AT_ONCE)
def _recordings(path: str, changed: int) -> dict[str, Recording]:
    """By agent, "" where the file names none. `changed`: when the file was."""
    file = Path(path)
    text = read_input(file).decode("utf-8-sig", errors="replace")
    columns = _of_trace(file, text) if text.lstrip().startswith("{") else _of_table(file, text)
    return {name: _recording(file, values) for name, values in columns.items()}


def _of_trace(file: Path, text: str) -> dict[str, dict[str, Any]]:
    """The columns of a trace as `roadlang run` writes it."""
    try:
        document = json.loads(text)
        time, agents = document["time"], document["agents"]
        return {name: {"time": time, **values} for name, values in agents.items()}
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise _fault(file, "it is not the trace of a drive") from error


def _of_table(file: Path, text: str) -> dict[str, dict[str, Any]]:
    """The columns of a CSV file with a line of names, by its column `agent` if it has one."""
    try:
        rows = list(csv.DictReader(io.StringIO(text), skipinitialspace=True))
    except csv.Error as error:
        raise _fault(file, str(error)) from error
    names = list(rows[0]) if rows else []
    for name in _NEEDED:
        if name not in names:
            help_ = (f"its first line must have the names {', '.join(_NEEDED)}",)
            raise _fault(file, f"no column `{name}`", help_)
    out: dict[str, dict[str, Any]] = {}
    for row in rows:
        columns = out.setdefault(row.get("agent") or "", {})
        for name in (*_NEEDED, *(["speed"] if "speed" in names else [])):
            columns.setdefault(name, []).append(row[name])
    return out


def _recording(file: Path, columns: dict[str, Any]) -> Recording:
    import numpy as np

    try:
        time, x, y, heading = (np.array(columns[name], dtype=np.float64) for name in _NEEDED)
        speed = np.array(columns["speed"], dtype=np.float64) if "speed" in columns else None
    except (ValueError, TypeError, KeyError) as error:
        raise _fault(file, "not all of its values are numbers") from error
    if len(time) < 2 or not (np.diff(time) > 0.0).all():
        raise _fault(file, "its times do not increase")
    if speed is None:
        speed = np.hypot(np.gradient(x, time), np.gradient(y, time))
    pose = np.stack((x, y, np.unwrap(heading), speed), axis=1)
    if not np.isfinite(pose).all():
        raise _fault(file, "not all of its values are numbers")
    return Recording(time - time[0], pose)


def _fault(file: Path, reason: str, help_: tuple[str, ...] = ()) -> DiagnosticError:
    return DiagnosticError(
        diagnose(Code.UNREADABLE_TABLE, file=file.name, reason=reason, help=help_)
    )
