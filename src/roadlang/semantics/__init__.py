"""Meaning of scene files: names, dimensions, types, signal domains, options; the scenario."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .check import check_text

__all__ = ["check_text"]


def __getattr__(name: str) -> Any:
    if name in __all__:
        from . import check

        return getattr(check, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
