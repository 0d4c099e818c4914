"""The categories of handmade agents and objects: those of the standard kinds."""

from __future__ import annotations

from roadlang.api import ObjectKind
from roadlang_standard import kinds_of

_CATEGORIES: dict[str, str] = {kind.name: kind.category for kind in kinds_of("agent", "object")}


def category_of_kind(kind: str) -> str:
    """By the name of a kind, with or without its plugin; of others that of a plain object."""
    return _CATEGORIES.get(kind.rpartition(".")[2], ObjectKind.category)
