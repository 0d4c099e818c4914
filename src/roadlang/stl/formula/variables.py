"""The signals that a formula reads, of what a program hands over as one."""

from __future__ import annotations

from collections.abc import Set
from typing import Any

from ...diagnostics.arguments import wrong_type


def variables_of(formula: Any) -> Set[str]:
    """The names of its signals. Raises `TypeError` for what is no formula, such as its text."""
    found = getattr(formula, "variables", None)
    if not isinstance(found, Set):
        raise wrong_type("formula", "a formula, which `roadlang.stl.parse` makes of text", formula)
    return found
