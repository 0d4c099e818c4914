"""One value for everything the compiler has to say; renderers turn it into text or JSON."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from .catalog import page
from .source import Span

Severity = Literal["error", "warning", "note"]


@dataclass(frozen=True, slots=True)
class Fix:
    """A replacement of one place in the source that would correct the fault."""

    span: Span
    replacement: str


@dataclass(frozen=True, slots=True)
class Label:
    """A second place that a diagnostic points at, with a word on why."""

    span: Span
    text: str


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """A coded message at a place. `help` says what to do, `fixes` say it as edits."""

    code: str
    severity: Severity
    message: str
    span: Span | None = None
    help: tuple[str, ...] = ()
    labels: tuple[Label, ...] = ()
    fixes: tuple[Fix, ...] = ()
    path: str | None = None
    """The file meant when there is no span in a source (an image, an output)."""

    @property
    def is_error(self) -> bool:
        """Whether this keeps a scenario from being compiled."""
        return self.severity == "error"

    @property
    def file(self) -> str | None:
        """Path of the file that this is about, if there is one."""
        return self.span.source.path if self.span is not None else self.path

    @property
    def includes(self) -> tuple[Span, ...]:
        """The `include`s by which its file came in, the innermost first; none of a main file."""
        found: list[Span] = []
        place = self.span
        while place is not None and place.source.included_at is not None:
            place = place.source.included_at
            found.append(place)
        return tuple(found)


def diagnose(
    code: str,
    span: Span | None = None,
    *,
    help: str | Iterable[str] = (),
    labels: Iterable[Label] = (),
    fixes: Iterable[Fix] = (),
    path: str | os.PathLike[str] | None = None,
    severity: Severity | None = None,
    **values: object,
) -> Diagnostic:
    """Fill the message template of the catalog page `code` with `values`. An empty `help` is
    none."""
    entry = page(code)
    said = (help,) if isinstance(help, str) else help
    return Diagnostic(
        code=code,
        severity=severity or entry.severity,
        message=entry.message.format(path=path, **values),
        span=span,
        help=tuple(filter(None, said)),
        labels=tuple(labels),
        fixes=tuple(fixes),
        path=None if path is None else os.fspath(path),
    )


def in_order(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Sorted by place, each said once."""
    unique = list(dict.fromkeys(diagnostics))
    return sorted(
        unique,
        key=lambda d: (d.file or "", d.span.start if d.span else -1, d.code),
    )
