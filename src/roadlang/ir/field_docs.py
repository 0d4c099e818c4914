"""What the source says of a dataclass: its docstring, and the texts below its fields."""

from __future__ import annotations

import ast
import dataclasses
import inspect
import sys
from functools import cache
from itertools import pairwise
from typing import Any


def class_doc(kind: Any) -> str:
    """The docstring as one line for each paragraph; empty where Python has made one up."""
    documented = inspect.getdoc(kind) or ""
    if documented.startswith(f"{kind.__name__}("):
        return ""
    return "\n".join(" ".join(part.split()) for part in documented.split("\n\n"))


@cache
def field_docs(kind: Any) -> dict[str, str]:
    """The string below each field, by the name of the field, base classes included.

    Empty where there is no source, as in a program that was frozen into one file.
    """
    found: dict[str, str] = {}
    for base in reversed(kind.__mro__):
        if dataclasses.is_dataclass(base):
            found |= _documented(base)
    return found


def _documented(kind: Any) -> dict[str, str]:
    try:
        tree = ast.parse(inspect.getsource(sys.modules[kind.__module__]))
    except (OSError, TypeError):
        return {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef) and node.name == kind.__name__:
            return dict(_texts_below(node.body))
    return {}


def _texts_below(body: list[ast.stmt]) -> list[tuple[str, str]]:
    texts = []
    for member, below in pairwise(body):
        if isinstance(member, ast.AnnAssign) and isinstance(member.target, ast.Name):
            match below:
                case ast.Expr(ast.Constant(str() as text)):
                    texts.append((member.target.id, " ".join(text.split())))
    return texts
