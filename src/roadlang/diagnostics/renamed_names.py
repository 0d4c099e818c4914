"""Names of public Python modules that were replaced: they work for one more minor version."""

from __future__ import annotations

import warnings
from collections.abc import Mapping


def current_name(module: str, name: str, renamed: Mapping[str, str]) -> str:
    """The name that replaced `name` in a module, or `name` itself.

    Call it in `__getattr__` of the module; the warning then points at the line that uses the name.
    """
    if name not in renamed:
        return name
    new = renamed[name]
    text = f"{module}.{name} is now {module}.{new}; the old name goes with the next minor version"
    warnings.warn(text, DeprecationWarning, stacklevel=3)
    return new
