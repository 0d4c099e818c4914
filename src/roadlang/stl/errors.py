"""Refusals of the STL room as coded diagnostics."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ..diagnostics import Code, DiagnosticError, Span, diagnose


def stl_error(
    code: str, span: Span | None = None, *, help: str | tuple[str, ...] = (), **values: Any
) -> DiagnosticError:
    """An exception to raise, with one diagnostic of the catalog page `code`."""
    return DiagnosticError(diagnose(code, span, help=help, **values))


def check_word(name: str, value: str, words: Sequence[str]) -> None:
    """Raises DiagnosticError RL342 for an argument that is none of these words."""
    if value not in words:
        known = ", ".join(f"`{word}`" for word in words)
        problem = f"it is {value!r}, which is none of {known}"
        raise stl_error(Code.INVALID_PARAMETER, name=name, problem=problem)


def check_positive(**numbers: float) -> None:
    """Raises DiagnosticError RL342 for an argument that is not a finite number above 0."""
    for name, number in numbers.items():
        if not 0.0 < number < math.inf:
            problem = f"it is {number}, not a positive number"
            raise stl_error(Code.INVALID_PARAMETER, name=name, problem=problem)
