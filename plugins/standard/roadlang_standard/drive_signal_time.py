"""`time` over the time of a drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import DriveSignal

if TYPE_CHECKING:
    from roadlang.api import Trace
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Time(DriveSignal):
    """Time since the start of the drive."""

    name: ClassVar[str] = "time"
    unit: ClassVar[str] = "s"
    looks_back: ClassVar[float] = 0
    member: ClassVar[bool] = False

    def values_in(self, trace: Trace) -> Floats:
        return trace.time
