"""Formulas from text, in the formula grammar of scene files; bare numbers are welcome here."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from ...diagnostics import Code, Diagnostic, DiagnosticError, Source, arguments, diagnose
from ...syntax.operators import BY_WORD
from ...syntax.parsing.parser import parse_formula
from ...syntax.recovery.operator_spelling import meant_temporal
from ..formula import formulas as f
from .from_syntax_tree import FormulaReader
from .unit_factors import is_unit

_ASSIGNED = re.compile(r"\s*([A-Za-z_][\w.]*)\s*(=)(?!=)([^\n]+)")
_ORIGINS = (
    (
        re.compile(r"\[\s*\]|<\s*>|/\\|\\/"),
        "this looks like S-TaLiRo: `roadlang.stl.read_staliro` reads it",
    ),
    (
        re.compile(r"\b(?:alw|ev|until|once|hist)_\s*\[|\b\w+\s*\[\s*t\s*[-+\]]|\balw\b"),
        "this looks like Breach: `roadlang.stl.read_breach` reads it",
    ),
)


def parse(text: str, *, path: str = "<formula>") -> f.Formula:
    """The formula written in `text`; `path` is the name that diagnostics give the text.

    Numbers without a unit are in the units of the signals and positions that the formula will
    see; numbers with one are converted to SI. Raises DiagnosticError with all faults found:
    RL0xx where the text is no formula, RL305 and RL320 to RL326 where it makes no sense.
    """
    arguments.text("text", text)
    source = Source(path, text)
    expression, diagnostics = parse_formula(source)
    errors = [diagnostic for diagnostic in diagnostics if diagnostic.is_error]
    if expression is None or errors:
        raise DiagnosticError(*(_assigned(source) or _with_origin(text, errors)))
    reader = FormulaReader()
    formula = reader.formula(expression)
    if reader.faults:
        raise DiagnosticError(*reader.faults)
    return formula


def _assigned(source: Source) -> Sequence[Diagnostic]:
    """For `out = always (x > 0)`, as RTAMT has it: its name is no part of a formula."""
    found = _ASSIGNED.match(source.text)
    if found is None:
        return ()
    formula, sign = found[3].strip(), f"`{found[1]} =`"
    try:
        parse(formula)
    except DiagnosticError:
        return ()
    help = f"a formula has no name: write `{formula}`"
    span = source.span(found.start(1), found.end(2))
    return [diagnose(Code.UNEXPECTED_TOKEN, span, expected="a formula", found=sign, help=help)]


def _with_origin(text: str, errors: Sequence[Diagnostic]) -> Sequence[Diagnostic]:
    """Says how formulas of other tools can be read, and how names of columns are written."""
    hints = [hint for pattern, hint in _ORIGINS if pattern.search(text)][:1]
    name = _column(text, errors[0]) if errors and not hints else None
    first = name.partition(" ")[0] if name is not None else ""
    meant = meant_temporal(first) if name is not None else None
    if first in BY_WORD and BY_WORD[first].form == "step":
        pass  # the parser says what it lacks
    elif first in BY_WORD:  # of the words that may be names too
        hints.append(f"what follows `{first}` stands in parentheses: `{first} (x > 0)`")
    elif meant is not None:
        hints.append(f"did you mean `{meant}`?")
    elif name is not None:
        hints.append(f"the name of a column stands in back quotes: `` `{name}` ``")
    if not errors or not hints:
        return errors
    return [replace(errors[0], help=(*errors[0].help, *hints)), *errors[1:]]


def _column(text: str, error: Diagnostic) -> str | None:
    """What may be the name of a column: a word in another alphabet, or two words."""
    if error.span is None:
        return None
    start, end = error.span.start, error.span.end
    if error.code == Code.NON_ASCII_NAME:
        return text[start:end]
    for named in re.finditer(r"([A-Za-z_]\w*)\s*\[\s*([^\[\]]+?)\s*\]", text):
        if named.start() < start < named.end() and is_unit(named[2]) and named[1] not in BY_WORD:
            return named[0]
    before = re.search(r"([A-Za-z_]\w*) +$", text[:start])
    words = before is not None and re.fullmatch(r"[A-Za-z_]\w*", text[start:end])
    if error.code != Code.UNEXPECTED_TOKEN or before is None or not words:
        return None
    return f"{before[1]} {text[start:end]}"
