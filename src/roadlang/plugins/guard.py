"""Code of plugins runs in here: a kind that fails is named, and breaks nothing else."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ..geometry.errors import GeometryError
from .attribution import PluginFault, attributed
from .kinds import base_of
from .registry import KindEntry


@contextmanager
def plugin_guard(entry: KindEntry, span: Span | None) -> Iterator[None]:
    """Turn whatever a kind raises into RL470; its own diagnostics pass, at this place."""
    try:
        with attributed():
            yield
    except PluginFault as fault:
        cause = fault.__cause__
        if isinstance(cause, DiagnosticError):
            raise DiagnosticError(*(_at(d, span) for d in cause.diagnostics)) from cause
        if isinstance(cause, GeometryError) and base_of(entry.verb).geometry_is_user_input:
            raise DiagnosticError(_impossible(entry, span, cause)) from cause
        raise DiagnosticError(_failed(entry, span, fault)) from cause


def _impossible(entry: KindEntry, span: Span | None, error: GeometryError) -> Diagnostic:
    what = f"{entry.verb} {entry.name}"
    return diagnose(Code.IMPOSSIBLE_GEOMETRY, span, what=what, reason=str(error))


def _failed(entry: KindEntry, span: Span | None, fault: PluginFault) -> Diagnostic:
    help_ = f"this is a fault of the plugin; report it to the authors of {entry.origin}"
    if isinstance(fault.__cause__, MemoryError):
        help_ = "the machine has too little memory for this, or the plugin asks for too much"
    return diagnose(
        Code.PLUGIN_FAILED,
        span,
        kind=f"{entry.verb} {entry.qualified}",
        plugin=str(entry.origin),
        reason=str(fault),
        help=help_,
    )


def wrong_result(entry: KindEntry, span: Span | None, fault: str) -> DiagnosticError:
    """RL474: a kind "gave ..." what it must not; it is named with its plugin."""
    return DiagnosticError(
        diagnose(
            Code.WRONG_PLUGIN_RESULT,
            span,
            kind=f"{entry.verb} {entry.qualified}",
            plugin=str(entry.origin),
            fault=fault,
        )
    )


def _at(diagnostic: Diagnostic, span: Span | None) -> Diagnostic:
    return diagnostic if diagnostic.span is not None else replace(diagnostic, span=span)
