"""What is public, in lines: names, parameters, and fields with their defaults."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Iterator
from dataclasses import MISSING, fields, is_dataclass
from typing import Any

_MODULES = (
    *("roadlang", "roadlang.api", "roadlang.envs", "roadlang.geometry", "roadlang.stl"),
    *("roadlang.testing", "roadlang_standard.metrics"),
)


def interface_lines() -> Iterator[str]:
    """Every public name of the packages that others import."""
    seen: set[int] = set()
    for module_name in _MODULES:
        module = importlib.import_module(module_name)
        listed = getattr(module, "__all__", None) or _own_names(module)
        yield f"{module_name}: {' '.join(sorted(listed))}"
        for name in sorted(listed):
            value = getattr(module, name)
            if id(value) in seen or inspect.ismodule(value) or name == "__version__":
                continue
            seen.add(id(value))
            yield from _described(f"{module_name}.{name}", value)


def _own_names(module: Any) -> list[str]:
    return [
        name
        for name, value in vars(module).items()
        if name[0] != "_" and getattr(value, "__module__", "") == module.__name__
    ]


def _described(name: str, value: Any) -> Iterator[str]:
    if inspect.isclass(value):
        yield f"  {name}: class of {', '.join(base.__name__ for base in value.__mro__[1:-1])}"
        if is_dataclass(value):
            for field in fields(value):
                yield f"    {field.name}{_default(field)}"
        for member, found in sorted(vars(value).items()):
            found = found.__func__ if isinstance(found, classmethod | staticmethod) else found
            if member[0] != "_" and isinstance(found, bool | int | float | str | tuple):
                yield f"    {member} = {found!r}"
            elif member[0] != "_" and inspect.isfunction(found):
                yield f"    {member}{_parameters(found)}"
    elif callable(value) and getattr(value, "__module__", "").startswith("roadlang"):
        yield f"  {name}{_parameters(value)}"
    elif isinstance(value, bool | int | float | str | tuple):
        yield f"  {name} = {value!r}"


def _default(field: Any) -> str:
    if field.default is not MISSING:
        return f" = {_shown(field.default)}"
    return " = ..." if field.default_factory is not MISSING else ""


def _parameters(function: Any) -> str:
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return ""
    said = (
        one.name if one.default is one.empty else f"{one.name}={_shown(one.default)}"
        for one in parameters
    )
    return f"({', '.join(said)})"


def _shown(default: Any) -> str:
    return repr(default) if isinstance(default, bool | int | float | str | tuple | None) else "..."
