"""What can go wrong with an engine, as diagnostics."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from roadlang.api import Code, DiagnosticError, diagnose

_NAMED = 8
"""Things that are named at most, of those that an engine has not built."""


class EngineError(DiagnosticError):
    """The engine, or the way to it, failed."""


def fault(code: str, help: str | Iterable[str] = (), **values: Any) -> EngineError:
    """The error to raise for a catalog page."""
    return EngineError(diagnose(code, help=help, **values))


def not_built(names: Sequence[str]) -> EngineError:
    """The error RL504 about things that an engine should have, or should not have."""
    shown = ", ".join(names[:_NAMED]) + (", ..." if len(names) > _NAMED else "")
    return fault(Code.SCENE_NOT_BUILT, count=len(names), names=shown)
