"""Recorded inputs of a human: what was wanted at each step of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from roadlang.api import read_text

from .csv_table import separator_of
from .named_rows import column, named_rows, table_fault

if TYPE_CHECKING:
    from roadlang.geometry import Floats

_COLUMNS = ("time", "steering", "acceleration")
_END_BRAKING = 4.0
"""m/s^2, after the end of the recording."""
_AT_ONCE = 16
"""Files that are remembered."""


@dataclass(frozen=True)
class RecordedInputs:
    """Steering angle and acceleration (T, 2) that were wanted from times (T,) on."""

    time: Floats
    wanted: Floats

    def at(self, time: float, step: float) -> Floats:
        """(2,) what was wanted in the step of `step` seconds that begins at a time; after the end
        the agent brakes."""
        import numpy as np

        middle = time + 0.5 * step
        if middle > self.time[-1] + step:
            return np.array([self.wanted[-1, 0], -_END_BRAKING])
        return np.asarray(self.wanted[max(int(np.searchsorted(self.time, middle)) - 1, 0)])


def recorded_inputs(path: str) -> RecordedInputs | None:
    """Those of a file; None where it holds something else. Raises RL477."""
    file = Path(path)
    return _inputs(path, file.stat().st_mtime_ns)


@lru_cache(maxsize=_AT_ONCE)
def _inputs(path: str, changed: int) -> RecordedInputs | None:
    """`changed`: when the file was."""
    import numpy as np

    file = Path(path)
    text = read_text(file)
    head = next((line for line in text.splitlines() if line.strip() and line[0] != "#"), "")
    names = head.split(separator_of(head))
    if [name.strip(' "') for name in names] != list(_COLUMNS):
        return None
    rows = named_rows(file, text)
    if not rows:
        raise table_fault(file, "it has no rows")
    time, steering, acceleration = (column(file, rows, name) for name in _COLUMNS)
    if not (np.diff(time) > 0.0).all():
        raise table_fault(file, "its times do not increase")
    return RecordedInputs(time - time[0], np.stack((steering, acceleration), axis=1))
