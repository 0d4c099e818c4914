"""Methods of dataclasses are compiled when they are first called.

`dataclass` writes each method of a class as text and compiles it. That took two fifths of the time
of `roadlang check`, and most methods are never called: those that refuse to change a frozen
instance, that compare two, or show one to people.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

Method = Callable[..., Any]

_LATER = frozenset(("__setattr__", "__delattr__", "__repr__", "__eq__", "__hash__"))
"""Not `__init__`, of which others read the parameters."""


def compile_methods_when_called() -> None:
    """From now on, for all classes. Python 3.13 and later compile all methods of a class in one
    go: with them nothing changes."""
    now: Method | None = getattr(dataclasses, "_create_fn", None)
    if now is not None:
        dataclasses._create_fn = _postponing(now)  # type: ignore[attr-defined]


def _postponing(now: Method) -> Method:
    def created(name: str, *arguments: Any, **more: Any) -> Method:
        def compiled() -> Method:
            method: Method = now(name, *arguments, **more)
            return method

        return _later(name, compiled) if name in _LATER else compiled()

    return created


def _later(name: str, compiled: Callable[[], Method]) -> Method:
    """What stands for a method until it is called, and then gives its place to it."""
    method: Method | None = None

    def called(it: Any, *others: Any) -> Any:
        nonlocal method
        if method is None:
            method = compiled()
            method.__qualname__ = called.__qualname__
            for kind in type(it).__mro__:
                if vars(kind).get(name) is called:
                    setattr(kind, name, method)
        return method(it, *others)

    called.__name__ = name
    return called
