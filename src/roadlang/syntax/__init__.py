"""Scene files as text: to a syntax tree and back. Everything is imported when it is first used."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .parsing.parser import parse, parse_formula, parse_value
    from .printing.format import format_file, format_source

__all__ = ["format_file", "format_source", "parse", "parse_formula", "parse_value"]


def __getattr__(name: str) -> Any:
    if name in ("parse", "parse_formula", "parse_value"):
        from .parsing import parser

        return getattr(parser, name)
    if name in ("format_file", "format_source"):
        from .printing import format

        return getattr(format, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
