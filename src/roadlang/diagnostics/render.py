"""Diagnostics as text for people and as JSON for machines."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from .diagnostic import Diagnostic, Label
from .printable import columns, one_line, printable
from .source import Span

_COLORS = {"error": "31", "warning": "33", "note": "36"}
_BLUE = "34"
_WIDEST_LINE = 160


def render(diagnostic: Diagnostic, *, color: bool = False) -> str:
    """A diagnostic with its source line, the place underlined, and what to do.

    Control characters of the source, of names and of messages are shown as `U+001B`.
    """
    return "\n".join(_TextReport(diagnostic, color).lines())


@dataclass(frozen=True)
class _TextReport:
    """Renders one diagnostic."""

    diagnostic: Diagnostic
    color: bool

    def lines(self) -> Iterator[str]:
        found = self.diagnostic
        color = _COLORS[found.severity]
        head = self.style(f"{found.severity}[{found.code}]", f"1;{color}")
        yield f"{head}: {self.style(one_line(found.message), '1')}"
        if found.span is not None:
            yield self.location(str(found.span))
            yield from self.excerpt(found.span, "", "^", color)
        elif found.path is not None:
            yield self.location(found.path)
        for label in self.labels:
            if found.span is None or label.span.source is not found.span.source:
                yield self.location(str(label.span))
            yield from self.excerpt(label.span, label.text, "-", _BLUE)
        for text in found.help:
            head = f"{self.gutter} {self.style('=', _BLUE)} {self.style('help', '1')}: "
            yield head + f"\n{self.gutter}   ".join(printable(line) for line in text.splitlines())

    def style(self, text: str, code: str) -> str:
        return f"\x1b[{code}m{text}\x1b[0m" if self.color else text

    @cached_property
    def labels(self) -> tuple[Label, ...]:
        """The places that it points at, then those by which its file came in."""
        includes = (Label(span, "included here") for span in self.diagnostic.includes)
        return (*self.diagnostic.labels, *includes)

    @property
    def gutter(self) -> str:
        """Blanks as wide as the greatest line number shown."""
        spans = [label.span for label in self.labels]
        if self.diagnostic.span is not None:
            spans.append(self.diagnostic.span)
        return " " * max((len(str(span.line)) for span in spans), default=1)

    def location(self, place: str) -> str:
        return f"{self.gutter}{self.style('-->', _BLUE)} {one_line(place)}"

    def excerpt(self, span: Span, text: str, mark: str, color: str) -> Iterator[str]:
        """The line of a span, and below it the underline with a label."""
        before, marked, after = _cut(span)
        bar = self.style("|", _BLUE)
        underline = " " * columns(before) + mark * max(1, columns(marked))
        number = self.style(str(span.line).rjust(len(self.gutter)), _BLUE)
        yield f"{self.gutter} {bar}"
        yield f"{number} {bar} {before}{marked}{after}"
        labeled = f"{underline} {one_line(text)}".rstrip()
        yield f"{self.gutter} {bar} {self.style(labeled, color)}"


def _cut(span: Span) -> tuple[str, str, str]:
    """The line of a span before, in and after it, safe to show; a long line is cut around it."""
    line = span.source.line(span.line).replace("\t", " ")
    start = min(span.column - 1, len(line))
    end = span.end_column - 1 if span.end_line == span.line else len(line)
    first = max(0, start - _WIDEST_LINE // 2) if len(line) > _WIDEST_LINE else 0
    last = first + _WIDEST_LINE
    end = max(start, min(end, last))
    return printable(line[first:start]), printable(line[start:end]), printable(line[end:last])


def render_all(diagnostics: Iterable[Diagnostic], *, color: bool = False) -> str:
    """Diagnostics in order, a blank line between them."""
    return "\n\n".join(render(diagnostic, color=color) for diagnostic in diagnostics)


def to_record(diagnostic: Diagnostic) -> dict[str, object]:
    """The JSON form of a diagnostic, as `check --json` prints it."""
    span = diagnostic.span
    return {
        "code": diagnostic.code,
        "severity": diagnostic.severity,
        "message": diagnostic.message,
        "file": diagnostic.file,
        "line": span.line if span else None,
        "column": span.column if span else None,
        "end_line": span.end_line if span else None,
        "end_column": span.end_column if span else None,
        "included_at": [
            {"file": place.source.path, "line": place.line, "column": place.column}
            for place in diagnostic.includes
        ],
        "help": list(diagnostic.help),
        "fixes": [
            {
                "line": fix.span.line,
                "column": fix.span.column,
                "end_line": fix.span.end_line,
                "end_column": fix.span.end_column,
                "replacement": fix.replacement,
            }
            for fix in diagnostic.fixes
        ],
    }


def render_json(diagnostics: Sequence[Diagnostic]) -> str:
    """A JSON list of all diagnostics."""
    import json

    return json.dumps([to_record(diagnostic) for diagnostic in diagnostics], indent=2)
