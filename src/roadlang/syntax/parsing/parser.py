"""Source to syntax tree and diagnostics. Always returns what could be read."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from ...diagnostics import Code, Diagnostic, Source
from ..recovery.operator_spelling import misspelled_temporal
from ..tree import nodes as ast
from .builder import Builder
from .engine import Build, ParseError, run
from .lexer import lex
from .structure_checks import check, check_nodes
from .tables import Tables, tables
from .tokens import Lexed

_MOST_REPORTED = 100


def parse(source: Source) -> tuple[ast.File, list[Diagnostic]]:
    """The tree of a scene file, as far as it can be read, and what is wrong with it."""
    grammar = tables()
    lexed = lex(source, grammar)
    builder = Builder(source)
    builds = _builds(grammar, builder)
    value = _parse_all(grammar, "file", lexed, builds)
    found = list(lexed.diagnostics)
    spoiled: list[ast.Word] = []
    if isinstance(value, ParseError):
        from ..recovery.recover import Recovery

        recovery = Recovery(source, grammar, builds, _lines(found))
        value = builder.file(0, 0, *recovery.file(lexed))
        found.extend(recovery.diagnostics)
        spoiled = recovery.spoiled
    checked = check(value)
    reported_lines = _lines(lexed.diagnostics)
    found.extend(each for each in checked.diagnostics if not _is_consequence(each, reported_lines))
    tree = replace(
        value,
        statements=tuple(checked.accepted),
        comments=tuple(lexed.comments),
        spoiled=(*spoiled, *checked.spoiled),
    )
    return tree, _reported(found)


def parse_formula(source: Source) -> tuple[ast.Expression | None, list[Diagnostic]]:
    """One formula, as the library reads it: the expression, or None and why not."""
    return _parse_part("formula", source)


def parse_value(source: Source) -> tuple[ast.Expression | None, list[Diagnostic]]:
    """One value, as it stands in an option or after `param x =`: also a text, list or map."""
    return _parse_part("value", source)


def _parse_part(start: str, source: Source) -> tuple[ast.Expression | None, list[Diagnostic]]:
    grammar = tables()
    lexed = lex(source, grammar)
    builds = _builds(grammar, Builder(source))
    value = _parse_all(grammar, start, lexed, builds)
    found = list(lexed.diagnostics)
    if isinstance(value, ParseError):
        from ..recovery.recover import Recovery

        recovery = Recovery(source, grammar, builds, _lines(found))
        value = recovery.piece(start, lexed.tokens)
        found.extend(recovery.diagnostics)
    if value is None:
        return None, _reported(found)
    refused, fit = check_nodes(value)
    found.extend(refused)
    return (value if fit else None), _reported(found)


def _builds(grammar: Tables, builder: Builder) -> list[Build]:
    return [builder.method(rule.build) for rule in grammar.rules]


def _parse_all(grammar: Tables, start: str, lexed: Lexed, builds: list[Build]) -> Any:
    """The value of all tokens, or where they do not fit."""
    slip = misspelled_temporal(lexed.tokens)
    if slip is not None:
        return ParseError(slip)
    return run(grammar, start, lexed.tokens, builds)


def _lines(diagnostics: list[Diagnostic]) -> frozenset[int]:
    return frozenset(found.span.line for found in diagnostics if found.span is not None)


def _is_consequence(found: Diagnostic, reported_lines: frozenset[int]) -> bool:
    """A missing comma or line end where a foreign character has been left out."""
    return (
        found.code in (Code.STATEMENT_NOT_AT_LINE_START, Code.MISSING_COMMA)
        and found.span is not None
        and found.span.line in reported_lines
    )


def _reported(diagnostics: list[Diagnostic]) -> list[Diagnostic]:
    """In order of place; a hopeless file gets the first of them."""
    ordered = sorted(diagnostics, key=lambda found: found.span.start if found.span else -1)
    return ordered[:_MOST_REPORTED]
