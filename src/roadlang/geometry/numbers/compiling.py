"""Loops that numba compiles where it is installed (`pip install roadlang[fast]`)."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from types import ModuleType
from typing import Any

OPTIONS: Any = {"error_model": "numpy"}  # never `fastmath`: it changes bits


@cache
def is_installed() -> bool:
    """Whether there is a numba."""
    return importlib.util.find_spec("numba") is not None


@cache
def loaded() -> Any:
    """numba, with its part `extending`."""
    with _without_coverage():
        import numba.extending

    return numba


@contextmanager
def _without_coverage() -> Iterator[None]:
    """numba loads the package `coverage` where it is installed, which takes a quarter of its own
    import, and asks it for nothing but whether it is measuring: then it is loaded already."""
    name = "coverage"
    hidden = name not in sys.modules
    if hidden:
        sys.modules[name] = None  # type: ignore[assignment]  # an import of it fails
    try:
        yield
    finally:
        if hidden:
            del sys.modules[name]


def compiled(loop: Callable[..., Any], digest: str) -> Any:
    """The compiled loop; `digest`: of the text of everything that is compiled with it. numba keeps
    what it has compiled on disk, until that changes."""
    numba = loaded()
    keyed = _keyed(loop, digest)
    try:
        return numba.njit(cache=True, nogil=True, **OPTIONS)(keyed)
    except RuntimeError:  # neither the installation nor a folder of the user can be written
        return numba.njit(nogil=True, **OPTIONS)(keyed)


def digest_of(*modules: ModuleType) -> str:
    """Of the text of modules."""
    import hashlib
    import inspect

    text = "".join(inspect.getsource(module) for module in modules)
    return hashlib.sha256(text.encode()).hexdigest()


def _keyed(loop: Callable[..., Any], digest: str) -> Callable[..., Any]:
    """The loop as a function that holds a digest: numba's cache looks at the file of a function
    and at what the function holds, but not at the files of those that it calls."""

    def keyed(*arguments: Any) -> Any:
        if digest:
            return loop(*arguments)
        return None

    keyed.__name__ = keyed.__qualname__ = loop.__name__
    return keyed
