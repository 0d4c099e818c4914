"""The numbers, words and tables that modules state, and the defaults of what they define, in lines.

Most were tuned or measured, or repeat what a standard says: a change should be meant.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import pkgutil
import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from tests.golden.summaries import array

PACKAGES = ("roadlang", "roadlang_standard", "roadlang_godot", "roadlang_formats")
_LEFT_OUT = re.compile(
    r"__main__|\.version$|_template|syntax\.parsing\.generated|envs\.stable_baselines$"
)
"""The last needs a package that few have, and states no numbers."""
_DEEPEST = 5


def constant_lines(package: str) -> Iterator[str]:
    """Of every module of a package, its constants and defaults."""
    for name in sorted(_modules(package)):
        if _LEFT_OUT.search(name):
            continue
        module = importlib.import_module(name)
        lines = [*_constants(module), *_defaults(module)]
        if lines:
            yield name
            yield from lines


def _modules(package: str) -> Iterator[str]:
    root = importlib.import_module(package)
    yield package
    for found in pkgutil.walk_packages(root.__path__, f"{package}."):
        yield found.name


def _constants(module: Any) -> Iterator[str]:
    """What is assigned in the module itself, but for state that begins empty."""
    tree = ast.parse(Path(module.__file__).read_text(encoding="utf-8"))
    for statement in tree.body:
        if not isinstance(statement, ast.Assign | ast.AnnAssign) or _is_empty(statement.value):
            continue
        targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
        for target in targets:
            for one in target.elts if isinstance(target, ast.Tuple) else [target]:
                if isinstance(one, ast.Name) and one.id.strip("_").isupper():
                    yield from _described(f"  {one.id}", getattr(module, one.id))


def _is_empty(value: ast.expr | None) -> bool:
    """State that code fills: an empty container, what a call makes without arguments, nothing."""
    if value is None:
        return True
    if isinstance(value, ast.Call):
        return not value.args and not value.keywords
    elements = getattr(value, "elts", getattr(value, "keys", None))
    return elements == []


def _described(name: str, value: Any, depth: int = 0) -> Iterator[str]:
    """A line for a value; a line for each item of a table."""
    if isinstance(value, Mapping) and value and depth < 2:
        for key, item in value.items():
            yield from _described(f"{name}[{_shown(key)}]", item, depth + 1)
    else:
        shown = _shown(value)
        if shown:
            yield f"{name} = {shown}"


def _shown(value: Any, depth: int = 0) -> str:
    """A value in words; nothing for what is no value, or too deep."""
    if depth > _DEEPEST:
        return ""
    if isinstance(value, Enum):
        return f"{type(value).__name__}.{value.name}"
    if isinstance(value, bool | int | float | str | bytes | complex | None):
        return repr(value)
    if isinstance(value, re.Pattern):
        return f"{value.pattern!r} {value.flags}"
    if isinstance(value, np.ndarray):
        return array(value.astype(float).ravel().tolist(), value.shape)
    if isinstance(value, Mapping):
        items = (f"{_shown(k, depth + 1)}: {_shown(v, depth + 1)}" for k, v in value.items())
        return f"{{{', '.join(items)}}}"
    if isinstance(value, frozenset | set):
        return f"{{{', '.join(sorted(_shown(one, depth + 1) for one in value))}}}"
    if isinstance(value, tuple | list):
        return f"({', '.join(_shown(one, depth + 1) for one in value)})"
    if is_dataclass(value) and not isinstance(value, type):
        parts = (
            f"{one.name}={_shown(getattr(value, one.name), depth + 1)}" for one in fields(value)
        )
        return f"{type(value).__name__}({', '.join(parts)})"
    return "" if isinstance(value, TypeVar) else getattr(value, "__name__", "")


def _defaults(module: Any) -> Iterator[str]:
    """Of functions, methods and fields that are defined in the module."""
    for name, value in vars(module).items():
        if getattr(value, "__module__", "") != module.__name__:
            continue
        if inspect.isfunction(value):
            yield from _parameters(name, value)
        elif inspect.isclass(value):
            if is_dataclass(value) and any(_has_default(one) for one in fields(value)):
                stated = [one for one in fields(value) if _has_default(one)]
                parts = (f"{one.name}={_shown(one.default)}" for one in stated)
                yield f"  {name}: {', '.join(parts)}"
            hidden = "_" if issubclass(value, Enum) else "__"  # an enum's own depend on Python
            for member, found in vars(value).items():
                found = found.__func__ if isinstance(found, classmethod | staticmethod) else found
                if inspect.isfunction(found) and member != "__init__":
                    yield from _parameters(f"{name}.{member}", found)
                elif isinstance(found, bool | int | float | str | tuple) and not member.startswith(
                    hidden
                ):
                    yield f"  {name}.{member} = {_shown(found)}"


def _has_default(field: Any) -> bool:
    return bool(_shown(field.default)) and not isinstance(field.default, type)


def _parameters(name: str, function: Any) -> Iterator[str]:
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return
    said = [(one.name, _shown(one.default)) for one in parameters if one.default is not one.empty]
    if any(shown for _, shown in said):
        yield f"  {name}({', '.join(f'{key}={shown}' for key, shown in said)})"
