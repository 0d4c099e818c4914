"""A number where a string is wanted: how it is written as one."""

from __future__ import annotations

from ...diagnostics import Fix
from . import expression_types as ty
from .expression_types import TypedExpression

_SETTING = "--set "
"""What the label of a value from the command line begins with; its name follows."""


def as_string(typed: TypedExpression) -> tuple[tuple[str, ...], tuple[Fix, ...]]:
    """Help and fix for a number; nothing for all else. On the command line the shell must not take
    the quotes."""
    if not isinstance(typed.type, ty.Quantity):
        return (), ()
    meant, label = f'"{typed.span.text}"', typed.span.source.path
    is_setting = label.startswith(_SETTING)
    shown = f"--set '{label.removeprefix(_SETTING)}={meant}'" if is_setting else meant
    return (f"strings are written in double quotes: `{shown}`",), (Fix(typed.span, meant),)
