"""A kind that fails is named, with its plugin and version, and breaks nothing else."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from dataclasses import replace
from types import TracebackType

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from .registry import KindEntry


@contextmanager
def plugin_guard(entry: KindEntry, span: Span | None) -> Iterator[None]:
    """Turn whatever a kind raises into RL470; its own diagnostics pass, at this place.

    What it prints goes to standard error: standard output is for the JSON of commands.
    """
    try:
        with redirect_stdout(sys.stderr):
            yield
    except DiagnosticError as error:
        raise DiagnosticError(*(_at(d, span) for d in error.diagnostics)) from error
    except (KeyboardInterrupt, MemoryError):
        raise
    except BaseException as error:
        # A wrong option that geometry refuses is the user's affair, anything else the plugin's.
        if type(error).__name__ == "GeometryError":
            raise DiagnosticError(
                diagnose(
                    Code.IMPOSSIBLE_GEOMETRY,
                    span,
                    what=f"{entry.verb} {entry.name}",
                    reason=str(error),
                )
            ) from error
        raise DiagnosticError(
            diagnose(
                Code.PLUGIN_FAILED,
                span,
                kind=f"{entry.verb} {entry.qualified}",
                plugin=str(entry.origin),
                reason=_reason(error),
                help=f"this is a fault of the plugin; report it to the authors of {entry.origin}",
            )
        ) from error


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


def _reason(error: BaseException) -> str:
    text = " ".join(str(error).split())
    if isinstance(error, NotImplementedError) and not text:
        return f"it does not implement `{_raised_in(error.__traceback__)}`"
    return f"{type(error).__name__}: {text or 'no reason given'}"


def _raised_in(trace: TracebackType | None) -> str:
    """The function that raised."""
    name = ""
    while trace is not None:
        name, trace = trace.tb_frame.f_code.co_name, trace.tb_next
    return name


def _at(diagnostic: Diagnostic, span: Span | None) -> Diagnostic:
    return diagnostic if diagnostic.span is not None else replace(diagnostic, span=span)
