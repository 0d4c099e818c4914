"""Runs code of plugins: what it raises or prints is attributed to the plugin, and to nothing
else."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from types import TracebackType
from typing import ParamSpec, TypeVar

from .redirection import begin_redirection, end_redirection
from .termination import Terminated, raise_if_terminated

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")


class PluginFault(Exception):
    """What code of a plugin raised; `__cause__` is that exception. `str()` is the reason in one
    line, with the file and line of the plugin where they are known."""


class Reason(TypeError):
    """Why something of a plugin cannot be used; its text needs no class or place in addition."""


class PassingFault(BaseException):
    """What roadlang raised where code of a plugin called it; `__cause__` is that exception. No
    `except Exception` of the plugin stops it."""


def called_by_plugins(function: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """A function of roadlang that plugins are given to call: what it raises passes through
    `attributed` as it is. It has to check what plugins call it with."""

    @wraps(function)
    def call(*values: Parameters.args, **options: Parameters.kwargs) -> Result:
        try:
            return function(*values, **options)
        except Exception as error:
            raise PassingFault from error

    return call


class attributed:
    """Around code of plugins. Raises `PluginFault` for whatever it raises.

    Ctrl-C, SIGTERM and what roadlang raised where the code called it pass through. What the code
    prints goes to standard error: standard output is for the results of commands.
    """

    __slots__ = ()

    def __enter__(self) -> None:
        begin_redirection()

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        end_redirection()
        if isinstance(error, KeyboardInterrupt | Terminated):
            return
        raise_if_terminated()
        if isinstance(error, PassingFault):
            assert error.__cause__ is not None
            raise error.__cause__
        if error is not None:  # a plugin may even call sys.exit
            raise PluginFault(reason_of(error)) from error


def reason_of(error: BaseException) -> str:
    """An exception in one line, with the place in the plugin that it comes from."""
    if isinstance(error, Reason):
        return str(error)
    if isinstance(error, NotImplementedError) and not _text_of(error):
        return f"it does not implement `{_raised_in(error.__traceback__)}`"
    text = " ".join(_text_of(error).split())
    line = f"{type(error).__name__}: {text}" if text else type(error).__name__
    place = _place_of(error)
    return f"{line} ({place})" if place else line


def _text_of(error: BaseException) -> str:
    """`str()`, which is code of the plugin too where the class is."""
    try:
        return str(error)
    except Exception as fault:  # noqa: BLE001 - it is code of the plugin
        return f"its message cannot be read: {type(fault).__name__}"


def _raised_in(trace: TracebackType | None) -> str:
    """The function that raised."""
    name = ""
    while trace is not None:
        name, trace = trace.tb_frame.f_code.co_name, trace.tb_next
    return name


_NOT_PLUGINS = ("roadlang", "importlib", "pkgutil", "pluggy", "contextlib", "click")


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
