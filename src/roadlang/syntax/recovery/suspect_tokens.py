"""Tokens that the scanner can read, but that may be a mistake: `unlexable` explains them."""

from __future__ import annotations

import re
from collections.abc import Callable

from ..parsing.tokens import Lexed
from ..tree.strings import ESCAPE, ESCAPES

COLOR = re.compile(r"#(?:[0-9a-fA-F]{8}|[0-9a-fA-F]{6}|[0-9a-fA-F]{3})(?![^\s,:)\]}])")
_KEY = re.compile(r"\s*:")


def is_unknown_escape(match: re.Match[str]) -> bool:
    """Whether a backslash and the character behind it mean nothing."""
    return match[1] not in ESCAPES


def _looks_like_color(lexed: Lexed, text: str, start: int, end: int) -> bool:
    match = COLOR.match(text, start)
    if match is None or not lexed.tokens:
        return False
    before = lexed.tokens[-1][0]
    if before in ("COLON", "EQUAL") or _KEY.match(text, match.end()):
        return True
    digits = match[0][1:]
    return len(digits) >= 6 and not digits.isalpha() and before in ("LPAR", "LSQB", "COMMA")


def _faulty_string(lexed: Lexed, text: str, start: int, end: int) -> bool:
    """`\"\"\"` that no other one closes is read as an empty string before a quote."""
    if end - start == 2:
        return text.startswith('"', end)
    return "\\" in text[start:end] and any(
        map(is_unknown_escape, ESCAPE.finditer(text, start, end))
    )


def _foreign_comment(lexed: Lexed, text: str, start: int, end: int) -> bool:
    return text.startswith(("/", "*"), end)


SUSPECTS: dict[str, Callable[[Lexed, str, int, int], bool]] = {
    "BAD": lambda lexed, text, start, end: True,
    "COMMENT": _looks_like_color,
    "STRING": _faulty_string,
    "DIVIDE": _foreign_comment,
}
"""Kinds of token that may be a mistake, and when they are."""
