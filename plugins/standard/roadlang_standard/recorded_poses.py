"""Recorded drives: tables of time, x, y and heading, and traces of drives."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from roadlang.api import did_you_mean, read_text

from .named_rows import Rows, column, named_rows, table_fault

if TYPE_CHECKING:
    from roadlang.geometry import Floats

_NEEDED = ("time", "x", "y", "heading")
_OPTIONAL = ("speed",)
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
        raise table_fault(file, f"it has no agent `{agent}`", help_)
    return found[agent]


@lru_cache(maxsize=_AT_ONCE)
def _recordings(path: str, changed: int) -> dict[str, Recording]:
    """By agent, "" where the file names none. `changed`: when the file was."""
    file = Path(path)
    text = read_text(file)
    columns = _of_trace(file, text) if text.lstrip().startswith("{") else _of_table(file, text)
    return {name: _recording(file, values) for name, values in columns.items()}


def _of_trace(file: Path, text: str) -> dict[str, dict[str, Floats]]:
    """The columns of a trace as `roadlang run` writes it."""
    import numpy as np

    try:
        document = json.loads(text)
        time, agents = document["time"], document["agents"]
        found = {name: {"time": time, **values} for name, values in agents.items()}
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise table_fault(file, "it is not the trace of a drive") from error
    try:
        return {
            agent: {
                name: np.array(values[name], dtype=np.float64)
                for name in (*_NEEDED, *_OPTIONAL)
                if name in values or name in _NEEDED
            }
            for agent, values in found.items()
        }
    except (ValueError, TypeError, KeyError) as error:
        raise table_fault(file, "not all of its values are numbers") from error


def _of_table(file: Path, text: str) -> dict[str, dict[str, Floats]]:
    """The columns of a CSV file with a line of names, by its column `agent` if it has one."""
    rows = named_rows(file, text)
    names = list(rows[0]) if rows else []
    for name in _NEEDED:
        if name not in names:
            help_ = (f"its first line must have the names {', '.join(_NEEDED)}",)
            raise table_fault(file, f"no column `{name}`", help_)
    by_agent: dict[str, Rows] = {}
    for row in rows:
        by_agent.setdefault(row.get("agent", ""), []).append(row)
    wanted = (*_NEEDED, *(name for name in _OPTIONAL if name in names))
    return {
        agent: {name: column(file, own, name) for name in wanted} for agent, own in by_agent.items()
    }


def _recording(file: Path, columns: dict[str, Floats]) -> Recording:
    import numpy as np

    time, x, y, heading = (columns[name] for name in _NEEDED)
    speed = columns.get("speed")
    if len(time) < 2 or not (np.diff(time) > 0.0).all():
        raise table_fault(file, "its times do not increase")
    if speed is None:
        speed = np.hypot(np.gradient(x, time), np.gradient(y, time))
    pose = np.stack((x, y, np.unwrap(heading), speed), axis=1)
    if not np.isfinite(pose).all():
        raise table_fault(file, "not all of its values are numbers")
    return Recording(time - time[0], pose)
