"""The grammar file, inside the wheel or at the root of a checkout, and its few special names."""

from __future__ import annotations

import hashlib
from pathlib import Path

STARTS = ("file", "formula", "value")
"""The rules that a parse may begin with."""
END = "$END"
"""The kind of the token after the last one."""
LIST = "_"
"""Stands for the method of a rule that only gathers the items of a repetition."""

_PACKAGE = Path(__file__).parents[2]


def grammar_path() -> Path:
    """`grammar/roadlang.lark`; the same call serves a checkout and an installed wheel."""
    shipped = _PACKAGE / "_shipped" / "grammar"
    room = shipped if shipped.is_dir() else _PACKAGE.parents[1] / "grammar"
    return room / "roadlang.lark"


def grammar_text() -> str:
    """The grammar as lark reads it."""
    return grammar_path().read_text(encoding="utf-8")


def digest(grammar: str) -> str:
    """What tells whether parse tables were made from this grammar, whatever its line ends."""
    return hashlib.sha256("\n".join(grammar.splitlines()).encode()).hexdigest()
