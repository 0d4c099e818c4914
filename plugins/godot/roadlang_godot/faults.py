"""What can go wrong with an engine, as diagnostics."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from roadlang.api import DiagnosticError, diagnose

EXIT_CODE = 5
"""Of a command that failed because an outside part did."""


class EngineError(DiagnosticError):
    """The engine, or the way to it, failed."""


def fault(code: str, help: str | Iterable[str] = (), **values: Any) -> EngineError:
    """The error to raise for a catalog page."""
    return EngineError(diagnose(code, help=help, **values))
