"""A controller that failed during a drive while the drive went on."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

CONTROLLER_FAILED = "controller_failed"
_NAMES_ERROR = re.compile(
    r"(?:[\w.:]*(?:Error|Exception)\b|.*\bpanicked at\b|fatal\b)", re.IGNORECASE
)
"""`ValueError: too fast`, `Error: too fast` (Node.js), `thread 'main' panicked at` (Rust)"""


@dataclass(frozen=True, slots=True)
class ControllerFailure:
    """Who was no longer driven as written, when, and why."""

    agent: str
    time: float
    """seconds"""
    reason: str
    """may have several lines, such as the end of what a program wrote"""

    @property
    def event(self) -> dict[str, Any]:
        """As traces have it."""
        return {
            "time": self.time,
            "event": CONTROLLER_FAILED,
            "agent": self.agent,
            "reason": self.reason,
        }

    @property
    def summary(self) -> str:
        """The reason in one line: of several lines the first, and the last that names an error, as
        tracebacks do; the last of all where none does."""
        lines = [line.strip() for line in self.reason.splitlines() if line.strip()]
        named = [line for line in lines[1:] if _NAMES_ERROR.match(line)]
        return " ".join(dict.fromkeys((*lines[:1], *(named or lines)[-1:])))


def controller_failures(events: Iterable[Mapping[str, Any]]) -> tuple[ControllerFailure, ...]:
    """Those among the events of a trace, in their order."""
    return tuple(
        ControllerFailure(str(event["agent"]), float(event["time"]), str(event["reason"]))
        for event in events
        if event.get("event") == CONTROLLER_FAILED
    )


def failure_columns(failures: Iterable[ControllerFailure]) -> dict[str, Any]:
    """The first of a drive, as columns of tables; none where there is none."""
    first = next(iter(failures), None)
    if first is None:
        return {}
    return {
        "controller failure time": first.time,
        "controller failure agent": first.agent,
        "controller failure reason": first.summary,
    }
