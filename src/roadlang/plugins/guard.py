"""Code of plugins runs in here: a kind that fails is named, and breaks nothing else."""

from __future__ import annotations

from collections.abc import Mapping
from types import TracebackType

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ..geometry.errors import GeometryError
from ..ir.values import NO_SPANS
from .attribution import PluginFault, attributed
from .kinds import base_of
from .option_error import OptionError
from .registry import KindEntry
from .tracebacks import help_of_fault, show_traceback


class plugin_guard(attributed):
    """Turn whatever a kind raises into RL470; its own diagnostics pass, at this place.

    `option_spans`: where the values of options are written.
    """

    __slots__ = ("_entry", "_option_spans", "_span")

    def __init__(
        self,
        entry: KindEntry,
        span: Span | None,
        option_spans: Mapping[str, Span] = NO_SPANS,
    ) -> None:
        self._entry = entry
        self._span = span
        self._option_spans = option_spans

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            super().__exit__(kind, error, trace)
        except PluginFault as fault:
            raise self._diagnosed(fault) from fault.__cause__

    def _diagnosed(self, fault: PluginFault) -> DiagnosticError:
        entry, cause = self._entry, fault.__cause__
        if isinstance(cause, DiagnosticError):
            return cause.at(self._span)
        if isinstance(cause, OptionError) and cause.option in _names_of_options(entry):
            span = self._option_spans.get(cause.option, self._span)
            return DiagnosticError(_invalid_option(entry, span, cause))
        if isinstance(cause, GeometryError) and base_of(entry.verb).geometry_is_user_input:
            return DiagnosticError(_impossible(entry, self._span, cause))
        if cause is not None:
            show_traceback(cause)
        return DiagnosticError(_failed(entry, self._span, fault))


def _names_of_options(entry: KindEntry) -> list[str]:
    return [option.name for option in entry.options]


def _impossible(entry: KindEntry, span: Span | None, error: GeometryError) -> Diagnostic:
    what = f"{entry.verb} {entry.name}"
    return diagnose(Code.IMPOSSIBLE_GEOMETRY, span, what=what, reason=str(error))


def _invalid_option(entry: KindEntry, span: Span | None, error: OptionError) -> Diagnostic:
    return diagnose(
        Code.INVALID_OPTION,
        span,
        option=error.option,
        kind=f"{entry.verb} {entry.name}",
        reason=error.reason,
        help=error.help or (),
    )


def _failed(entry: KindEntry, span: Span | None, fault: PluginFault) -> Diagnostic:
    help_, reason = help_of_fault(entry.origin), str(fault)
    if isinstance(fault.__cause__, OptionError):
        raised = f"it raised an OptionError of `{fault.__cause__.option}`"
        reason = f"{raised}, which is not one of its options"
        known = ", ".join(_names_of_options(entry)) or "none"
        help_ = (f"its options are {known}", *help_)
    if isinstance(fault.__cause__, MemoryError):
        help_ = ("the machine has too little memory for this, or the plugin asks for too much",)
    return diagnose(
        Code.PLUGIN_FAILED,
        span,
        kind=f"{entry.verb} {entry.qualified}",
        plugin=str(entry.origin),
        reason=reason,
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
