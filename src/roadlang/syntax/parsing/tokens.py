"""What the lexer hands to the parser."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

from ...diagnostics import Diagnostic
from ..tree.nodes import Comment

Token: TypeAlias = tuple[str, str, int, int]
"""kind, text, start, end: offsets in the source."""


@dataclass(slots=True)
class Lexed:
    """The tokens of a source, the last one `$END`; comments are returned separately."""

    tokens: list[Token] = field(default_factory=list)
    comments: list[Comment] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    names: set[str] = field(default_factory=set)
    """Names with letters that are not ASCII, each reported once."""
