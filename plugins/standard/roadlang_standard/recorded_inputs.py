"""Recorded inputs of a human: what was wanted at each step of a drive."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from roadlang.api import Code, DiagnosticError, diagnose, read_input

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
    text = read_input(file).decode("utf-8-sig", errors="replace")
    header, _, rest = text.partition("\n")
    if [name.strip(' "\r') for name in header.split(",")] != list(_COLUMNS):
        return None
    try:
        rows = [row for row in csv.reader(io.StringIO(rest)) if row]
        table = np.array(rows, dtype=np.float64).reshape(-1, len(_COLUMNS))
    except (ValueError, csv.Error) as error:
        raise _fault(file) from error
    if not len(table) or not np.isfinite(table).all() or not (np.diff(table[:, 0]) > 0.0).all():
        raise _fault(file)
    return RecordedInputs(table[:, 0] - table[0, 0], table[:, 1:])


def _fault(file: Path) -> DiagnosticError:
    reason = "it has no rows, or its times do not increase, or not all of its values are numbers"
    return DiagnosticError(diagnose(Code.UNREADABLE_TABLE, file=file.name, reason=reason, help=()))
