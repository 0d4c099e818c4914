"""Fixes of diagnostics, carried out on the text that they are about."""

from __future__ import annotations

from collections.abc import Iterable

from .diagnostic import Diagnostic, Fix
from .source import Source


def apply_fixes(source: Source, diagnostics: Iterable[Diagnostic]) -> tuple[str, int]:
    """The text with every fix that is the only one of its diagnostic, and how many these are.

    Of several fixes a person has to choose. Where two overlap, the later one is left for another
    round, when the text has been checked again.
    """
    text, limit, count = source.text, len(source.text), 0
    for fix in sorted(_certain(source, diagnostics), key=_place, reverse=True):
        if fix.span.end <= limit:
            text = text[: fix.span.start] + fix.replacement + text[fix.span.end :]
            limit, count = fix.span.start, count + 1
    return text, count


def _certain(source: Source, diagnostics: Iterable[Diagnostic]) -> set[Fix]:
    return {
        diagnostic.fixes[0]
        for diagnostic in diagnostics
        if len(diagnostic.fixes) == 1 and diagnostic.fixes[0].span.source == source
    }


def _place(fix: Fix) -> tuple[int, int]:
    return fix.span.start, fix.span.end
