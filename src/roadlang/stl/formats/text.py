"""Formulas from text, in the formula grammar of scene files; bare numbers are welcome here."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from ...diagnostics import Diagnostic, DiagnosticError, Source
from ...syntax.parsing.parser import parse_formula
from ..formula import formulas as f
from .from_syntax_tree import FormulaReader

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
    source = Source(path, text)
    expression, diagnostics = parse_formula(source)
    errors = [diagnostic for diagnostic in diagnostics if diagnostic.is_error]
    if expression is None or errors:
        raise DiagnosticError(*_with_origin(text, errors))
    reader = FormulaReader()
    formula = reader.formula(expression)
    if reader.faults:
        raise DiagnosticError(*reader.faults)
    return formula


def _with_origin(text: str, errors: Sequence[Diagnostic]) -> Sequence[Diagnostic]:
    """For formulas of other tools, says how they can be read."""
    reader = next((hint for pattern, hint in _ORIGINS if pattern.search(text)), None)
    if not errors or reader is None:
        return errors
    return [replace(errors[0], help=(*errors[0].help, reader)), *errors[1:]]
