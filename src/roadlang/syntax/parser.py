"""Source to syntax tree and diagnostics. Always returns what could be read."""

from __future__ import annotations

from dataclasses import replace

from ..diagnostics import Diagnostic, Source, diagnose
from . import ast
from .builder import Builder
from .engine import Stuck, run
from .lexer import lex
from .tables import tables


def parse(source: Source) -> tuple[ast.File, list[Diagnostic]]:
    """The tree of a scene file, as far as it can be read, and what is wrong with it."""
    grammar = tables()
    lexed = lex(source, grammar)
    builder = Builder(source)
    builds = [getattr(builder, rule.build, None) for rule in grammar.rules]
    value = run(grammar, "file", lexed.tokens, builds)
    if isinstance(value, Stuck):
        token = lexed.tokens[value.index]
        found = diagnose("RL001", source.span(token[2], token[3]), found=token[1], expected="?")
        return builder.file(0, 0), [found]
    return replace(value, comments=tuple(lexed.comments)), lexed.diagnostics


def parse_formula(source: Source) -> tuple[ast.Expression | None, list[Diagnostic]]:
    """One formula, as the library reads it: the expression, or None and why not."""
    grammar = tables()
    lexed = lex(source, grammar)
    builder = Builder(source)
    builds = [getattr(builder, rule.build, None) for rule in grammar.rules]
    value = run(grammar, "formula", lexed.tokens, builds)
    if isinstance(value, Stuck):
        token = lexed.tokens[value.index]
        found = diagnose("RL001", source.span(token[2], token[3]), found=token[1], expected="?")
        return None, [found]
    return value, lexed.diagnostics
