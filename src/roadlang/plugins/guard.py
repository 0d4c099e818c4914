"""Code of plugins runs in here: a kind that fails is named, and breaks nothing else."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from dataclasses import replace
from types import TracebackType

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ..geometry.errors import GeometryError
from .kind_checks import KindFault
from .kinds import base_of
from .registry import KindEntry
from .termination import Terminated, raise_if_terminated


class PluginFault(Exception):
    """What code of a plugin raised; `__cause__` is that exception. `str()` is the reason in one
    line, with the file and line of the plugin where they are known."""


@contextmanager
def attributed() -> Iterator[None]:
    """Around code of plugins. Raises `PluginFault` for whatever it raises.

    Ctrl-C and SIGTERM pass: they are nobody's fault. What the code prints goes to standard
    error: standard output is for the results of commands.
    """
    try:
        with redirect_stdout(sys.stderr):
            yield
        raise_if_terminated()
    except (KeyboardInterrupt, Terminated):
        raise
    except BaseException as error:  # a plugin may even call sys.exit
        raise_if_terminated()
        raise PluginFault(reason_of(error)) from error


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


def reason_of(error: BaseException) -> str:
    """An exception in one line, with the place in the plugin that it comes from."""
    if isinstance(error, KindFault):
        return str(error)
    if isinstance(error, NotImplementedError) and not str(error):
        return f"it does not implement `{_raised_in(error.__traceback__)}`"
    text = " ".join(str(error).split())
    line = f"{type(error).__name__}: {text}" if text else type(error).__name__
    place = _place_of(error)
    return f"{line} ({place})" if place else line


def _raised_in(trace: TracebackType | None) -> str:
    """The function that raised."""
    name = ""
    while trace is not None:
        name, trace = trace.tb_frame.f_code.co_name, trace.tb_next
    return name


_NOT_PLUGINS = ("roadlang", "importlib", "pluggy", "contextlib")


def _place_of(error: BaseException) -> str:
    """`acme/kinds.py:12`: the last line of the plugin on the way to an error; empty if none.

    The plugin is the first package on that way that is neither roadlang nor what loads modules.
    """
    plugin, place, trace = "", "", error.__traceback__
    while trace is not None:
        module = str(trace.tb_frame.f_globals.get("__name__", ""))
        package = module.partition(".")[0]
        if not plugin and package not in _NOT_PLUGINS:
            plugin = package
        file = trace.tb_frame.f_code.co_filename
        if plugin and package == plugin and not file.startswith("<"):
            place = f"{_file_in_package(trace, module)}:{trace.tb_lineno}"
        trace = trace.tb_next
    return place


def _file_in_package(trace: TracebackType, module: str) -> str:
    """The file of a frame from its top-level package on: never a folder of this machine."""
    parts = trace.tb_frame.f_code.co_filename.replace("\\", "/").split("/")
    depth = module.count(".") + 1 + (parts[-1] == "__init__.py")
    return "/".join(parts[-depth:])


def _at(diagnostic: Diagnostic, span: Span | None) -> Diagnostic:
    return diagnostic if diagnostic.span is not None else replace(diagnostic, span=span)
