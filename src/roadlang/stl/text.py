"""Formulas from text, in the formula grammar of scene files; bare numbers are welcome here."""

from __future__ import annotations

from ..diagnostics import DiagnosticError, Source
from . import formulas as f
from .reading import Reader


def parse(text: str, *, path: str = "<formula>") -> f.Formula:
    """The formula written in `text`; `path` is the name that diagnostics give the text.

    Numbers without a unit are in the units of the signals and positions that the formula will
    see; numbers with one are converted to SI. Raises DiagnosticError with all faults found:
    RL0xx where the text is no formula, RL305 and RL320 to RL326 where it makes no sense.
    """
    from ..syntax import parse_formula

    source = Source(path, text)
    expression, diagnostics = parse_formula(source)
    errors = [diagnostic for diagnostic in diagnostics if diagnostic.is_error]
    if expression is None or errors:
        raise DiagnosticError(*errors)
    reader = Reader()
    formula = reader.formula(expression)
    if reader.faults:
        raise DiagnosticError(*reader.faults)
    return formula
