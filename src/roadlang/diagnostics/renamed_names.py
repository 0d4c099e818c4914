"""Names in public Python modules that were replaced: they work for one more minor version."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import Any


class OldName:
    """The old name of a member of a class: `of_one: ClassVar = OldName("of_single")`.

    Reading it gives the member under its new name, and a warning that points at the line.
    """

    def __init__(self, new: str) -> None:
        self._new = new

    def __set_name__(self, owner: type, name: str) -> None:
        self._old = name

    def __get__(self, instance: object, owner: type) -> Any:
        text = _text(owner.__name__, self._old, self._new)
        warnings.warn(text, DeprecationWarning, stacklevel=2)
        return getattr(owner if instance is None else instance, self._new)


def current_name(module: str, name: str, renamed: Mapping[str, str]) -> str:
    """The name that replaced `name` in a module, or `name` itself.

    Call it in `__getattr__` of the module; the warning then points at the line that uses the name.
    """
    if name not in renamed:
        return name
    new = renamed[name]
    warnings.warn(_text(module, name, new), DeprecationWarning, stacklevel=3)
    return new


def _text(owner: str, old: str, new: str) -> str:
    return f"{owner}.{old} is now {owner}.{new}; the next minor version removes the old name"
