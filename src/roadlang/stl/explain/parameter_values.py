"""A formula with values in the place of its parameters."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from ...diagnostics import Diagnostic, DiagnosticError, Source
from ..formats.text import parse
from ..formula import formulas as f
from ..formula.terms import number_text
from .parameters import word_pattern


def with_values(text: str, values: Mapping[str, float]) -> f.Formula:
    """The formula that `text` is where its parameters have these values.

    Raises DiagnosticError as `parse` does, at the places of `text` as it was written.
    """
    pattern = re.compile("|".join(word_pattern(name).pattern for name in values))
    found = list(pattern.finditer(text))
    shown = [_shown(values[match[0]]) for match in found]
    numbers = iter(shown)
    try:
        return parse(pattern.sub(lambda _: next(numbers), text))
    except DiagnosticError as error:
        written = [(match.start(), match.end()) for match in found]
        source = Source("<formula>", text)
        moved = (_moved(each, source, written, shown) for each in error.diagnostics)
        raise DiagnosticError(*moved) from None


def _shown(value: float) -> str:
    return f"({number_text(value)})" if value < 0 else number_text(value)


def _moved(
    diagnostic: Diagnostic, source: Source, written: list[tuple[int, int]], shown: list[str]
) -> Diagnostic:
    """Without fixes, which are about the text with values."""
    span = diagnostic.span
    if span is None:
        return diagnostic

    def place(offset: int, at_end: bool) -> int:
        moved = 0
        for (start, end), number in zip(written, shown, strict=True):
            first = start + moved
            last = first + len(number)
            if offset < first or (offset == first and not at_end):
                break
            if offset < last or (offset == last and at_end):
                return end if at_end else start
            moved += len(number) - (end - start)
        return offset - moved

    span = source.span(place(span.start, False), place(span.end, True))
    return replace(diagnostic, span=span, labels=(), fixes=())
