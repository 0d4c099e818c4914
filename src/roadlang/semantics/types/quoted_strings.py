"""A value where a string is wanted: how it is written as one, at the place where it stands."""

from __future__ import annotations

import shlex

from ...diagnostics import Fix, Span
from . import expression_types as ty
from .expression_types import TypedExpression

_SETTING = "--set "
"""What the label of a value from the command line begins with; its name follows."""
_ARGUMENT = "argument "
"""The same of an argument in Python."""


def as_string(typed: TypedExpression) -> tuple[tuple[str, ...], tuple[Fix, ...]]:
    """Help and fix for a number, `true` and `false`; nothing for all else."""
    if not isinstance(typed.type, ty.Quantity | ty.BooleanType):
        return (), ()
    return unquoted_string(typed.span)


def unquoted_string(span: Span) -> tuple[tuple[str, ...], tuple[Fix, ...]]:
    """Help and fix for text that is to be a string. On the command line the shell must not take
    the quotes, in Python a text is one of the language."""
    meant, label = f'"{span.text}"', span.source.path
    shown = meant
    if label.startswith(_SETTING):
        shown = f"--set {shlex.quote(f'{label.removeprefix(_SETTING)}={meant}')}"
    elif label.startswith(_ARGUMENT):
        shown = f"{label.removeprefix(_ARGUMENT)}={meant!r}"
    return (f"strings are written in double quotes: `{shown}`",), (Fix(span, meant),)
