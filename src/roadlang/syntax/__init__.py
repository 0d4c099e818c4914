"""Scene files as text: to a syntax tree and back. Everything is imported when it is first used."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .parser import parse, parse_formula

__all__ = ["parse", "parse_formula"]


def __getattr__(name: str) -> Any:
    if name in __all__:
        from . import parser

        return getattr(parser, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
