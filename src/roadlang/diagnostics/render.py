"""Diagnostics as text for people and as JSON for machines."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence

from .diagnostic import Diagnostic
from .source import Span

_COLORS = {"error": "31", "warning": "33", "note": "36"}
_WIDEST_LINE = 160


def render(diagnostic: Diagnostic, *, color: bool = False) -> str:
    """A diagnostic with its source line, the place underlined, and what to do."""

    def paint(text: str, code: str) -> str:
        return f"\x1b[{code}m{text}\x1b[0m" if color else text

    hue = _COLORS[diagnostic.severity]
    head = paint(f"{diagnostic.severity}[{diagnostic.code}]", f"1;{hue}")
    lines = [f"{head}: {paint(diagnostic.message, '1')}"]
    margin = _margin(diagnostic)
    bar = paint("|", "34")
    if diagnostic.span is not None:
        lines.append(f"{' ' * margin}{paint('-->', '34')} {diagnostic.span}")
        lines.extend(_excerpt(diagnostic.span, "", "^", margin, bar, hue, paint))
    elif diagnostic.path is not None:
        lines.append(f"{' ' * margin}{paint('-->', '34')} {diagnostic.path}")
    for label in diagnostic.labels:
        if diagnostic.span is None or label.span.source is not diagnostic.span.source:
            lines.append(f"{' ' * margin}{paint('-->', '34')} {label.span}")
        lines.extend(_excerpt(label.span, label.text, "-", margin, bar, "34", paint))
    for text in diagnostic.help:
        lines.append(f"{' ' * margin} {paint('=', '34')} {paint('help', '1')}: {text}")
    return "\n".join(lines)


def _margin(diagnostic: Diagnostic) -> int:
    spans = [label.span for label in diagnostic.labels]
    if diagnostic.span is not None:
        spans.append(diagnostic.span)
    return max((len(str(span.line)) for span in spans), default=1)


def _excerpt(
    span: Span, text: str, mark: str, margin: int, bar: str, hue: str, paint: object
) -> list[str]:
    assert callable(paint)
    line = span.source.line(span.line)
    start = span.column - 1
    end = span.end_column - 1 if span.end_line == span.line else len(line)
    # A very long line is cut around the place, so that the underline stays in view.
    cut = max(0, start - _WIDEST_LINE // 2) if len(line) > _WIDEST_LINE else 0
    shown = line[cut : cut + _WIDEST_LINE].expandtabs(1)
    start, end = start - cut, min(end - cut, len(shown))
    underline = " " * start + mark * max(1, end - start)
    gutter = " " * margin
    return [
        f"{gutter} {bar}",
        f"{paint(str(span.line).rjust(margin), '34')} {bar} {shown}",
        f"{gutter} {bar} {paint((underline + ' ' + text).rstrip(), hue)}",
    ]


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
    return json.dumps([to_record(diagnostic) for diagnostic in diagnostics], indent=2)


def in_order(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Sorted by place, each said once."""
    unique = list(dict.fromkeys(diagnostics))
    return sorted(
        unique,
        key=lambda d: (d.file or "", d.span.start if d.span else -1, d.code),
    )
