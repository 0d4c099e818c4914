"""A kind that fails is named, with its plugin and version, and breaks nothing else."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from ..diagnostics import Diagnostic, DiagnosticError, Span, diagnose
from ..plugins.registry import KindEntry


@contextmanager
def blaming(entry: KindEntry, span: Span | None) -> Iterator[None]:
    """Turn whatever a kind raises into RL470; its own diagnostics pass, at this place."""
    try:
        yield
    except DiagnosticError as error:
        raise DiagnosticError(*(_at(d, span) for d in error.diagnostics)) from error
    except (KeyboardInterrupt, MemoryError):
        raise
    except BaseException as error:
        # A wrong option that geometry refuses is the user's affair, anything else the plugin's.
        if type(error).__name__ == "GeometryError":
            raise DiagnosticError(
                diagnose("RL472", span, what=f"{entry.verb} {entry.name}", reason=str(error))
            ) from error
        reason = " ".join(str(error).split()) or "no reason given"
        raise DiagnosticError(
            diagnose(
                "RL470",
                span,
                kind=f"{entry.verb} {entry.qualified}",
                plugin=str(entry.origin),
                reason=f"{type(error).__name__}: {reason}",
                help=f"this is a fault of the plugin; report it to the authors of {entry.origin}",
            )
        ) from error


def _at(diagnostic: Diagnostic, span: Span | None) -> Diagnostic:
    return diagnostic if diagnostic.span is not None else replace(diagnostic, span=span)
