"""The names of columns of tables of results: those of users beside those of roadlang.

Users name params, values and expectations. Where a table has a column of its own with that name
(`param scene`, `expect verdict`), theirs says what it holds: `scene value`, `verdict robustness`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

OF_SCENES = frozenset({"scene"})
OF_DRIVES = frozenset({"run", "scene", "verdict", "worst"})
OF_SEARCH = frozenset({"evaluation", "random", "violated"})
OF_RUNS = frozenset({"run", "scenes", "candidates", "violated"})
"""Columns of tables that could be names in a scene file: they are single words."""
_VALUE, _ROBUSTNESS = " value", " robustness"


def value_columns(values: Mapping[str, Any], own: frozenset[str]) -> dict[str, Any]:
    """Params, values and draws by the names of their columns. `own`: those of the table."""
    return {f"{name}{_VALUE}" if name in own else name: found for name, found in values.items()}


def robustness_column(name: str, own: frozenset[str]) -> str:
    """The column of the robustness of an expectation."""
    return f"{name}{_ROBUSTNESS}" if name in own else name


def named_in(column: str) -> str:
    """The param, value, draw or expectation of a column."""
    return column.removesuffix(_VALUE).removesuffix(_ROBUSTNESS)
