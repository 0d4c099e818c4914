"""Refusals of the STL room as coded diagnostics."""

from __future__ import annotations

from typing import Any

from ..diagnostics import DiagnosticError, Span, diagnose


def stl_error(
    code: str, span: Span | None = None, *, help: str | tuple[str, ...] = (), **values: Any
) -> DiagnosticError:
    """An exception to raise, with one diagnostic of the catalog page `code`."""
    return DiagnosticError(diagnose(code, span, help=help, **values))
