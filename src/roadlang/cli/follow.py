"""`roadlang monitor --follow`: judge a trace while it is being written."""

from __future__ import annotations

import io
import sys
import time
from collections.abc import Generator, Iterable
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING

from .console import echo

if TYPE_CHECKING:
    from ..stl import DecidedSample, Formula

_PAUSE = 0.05
"""Seconds between two looks at a file that has not grown."""


def follow(formula: Formula, path: str) -> bool:
    """Print a line whenever the formula begins or ceases to hold; whether it ever failed.

    `-` is standard input, which ends; a file is watched until the command is interrupted.
    Raises DiagnosticError.
    """
    from ..diagnostics import Code, DiagnosticError, diagnose
    from ..stl import StreamMonitor
    from ..stl.formats.delimited_text import DelimitedTextFault
    from ..stl.formats.trace_stream import samples_of_lines
    from .read_traces import judging

    monitor, truth = StreamMonitor(formula), StreamMonitor(formula, boolean=True)
    changes = _Changes()
    echo(str(formula))
    try:
        with closing(_lines(path)) as lines:
            for position, values in samples_of_lines(lines):
                with judging(path):
                    decided = monitor.push(position, values), truth.push(position, values)
                changes.report(*decided)
    except DelimitedTextFault as fault:
        raise DiagnosticError(
            diagnose(Code.UNREADABLE_TRACE, path=path, file=_name(path), problem=str(fault))
        ) from None
    except KeyboardInterrupt:
        return changes.failed
    changes.report(monitor.finish(), truth.finish())
    return changes.failed


class _Changes:
    """Prints the samples at which the verdict changes."""

    def __init__(self) -> None:
        self.holds: bool | None = None
        self.failed = False

    def report(self, decided: Iterable[DecidedSample], truth: Iterable[DecidedSample]) -> None:
        """`truth` decides where robustness is exactly 0."""
        from ..stl.evaluate.position_text import position_text

        for (position, rho), (_, satisfied) in zip(decided, truth, strict=True):
            holds = (rho or satisfied) > 0
            self.failed |= not holds
            if holds != self.holds:
                word = "holds" if holds else "violated"
                echo(f"{position_text(position):<12}  {word:<8}  {rho + 0.0:.6g}")
            self.holds = holds


def _lines(path: str) -> Generator[str, None, None]:
    """The lines of a stream or of a file that grows; an unfinished last line waits for its end."""
    if path == "-":
        yield from io.TextIOWrapper(sys.stdin.buffer, encoding="utf-8", errors="replace")
        return
    from ..diagnostics import Code, DiagnosticError, diagnose

    try:
        with Path(path).open(encoding="utf-8-sig", errors="replace") as file:
            pending = ""
            while True:
                pending += file.readline()
                if pending.endswith("\n"):
                    yield pending
                    pending = ""
                else:
                    time.sleep(_PAUSE)
    except OSError as problem:
        reason = str(problem.strerror).lower()
        raise DiagnosticError(
            diagnose(Code.UNREADABLE_TRACE, path=path, file=_name(path), problem=reason)
        ) from None


def _name(path: str) -> str:
    return "standard input" if path == "-" else Path(path).name
