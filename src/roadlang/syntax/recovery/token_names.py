"""What people call tokens: `expected a value or `,`, found the end of the file`."""

from __future__ import annotations

from ..parsing.grammar import END
from ..words import LOGIC_KINDS, OPERATOR_KINDS, SIGNS, STATEMENT_KINDS
from .error_position import ErrorPosition

_SHOWN = 30


def expectation(place: ErrorPosition) -> str:
    """The kinds of token that would fit, in words."""
    kinds = place.expected()
    parts: list[str] = []
    if kinds == {"NUMBER"}:
        parts.append("the number of a copy, such as `0`")
    elif "NUMBER" in kinds:
        parts.append("a formula" if _after_logic(place) else "a value")
    elif _names_an_item(place, kinds):
        parts.append("an option" if "RBRACE" in kinds else "a name")
    elif "NAME" in kinds and "RBRACE" in kinds:
        parts.append("an option")
    elif "NAME" in kinds:
        parts.append("a name")
    if "STRING" in kinds and "NUMBER" not in kinds:
        parts.append("a string in double quotes")
    parts.extend(_signs(kinds, parts))
    if not parts or (END in kinds and len(parts) < 3):
        parts.append("the end of the statement" if place.index else "a statement")
    return parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} or {parts[-1]}"


def _names_an_item(place: ErrorPosition, kinds: set[str]) -> bool:
    """A key, a member or an argument: any word will do."""
    return "NAME" in kinds and kinds >= STATEMENT_KINDS and END not in kinds


def _after_logic(place: ErrorPosition) -> bool:
    if place.kind(-1) in LOGIC_KINDS:
        return True
    return place.first_kind in ("REQUIRE", "EXPECT") and place.index == 3


def _signs(kinds: set[str], parts: list[str]) -> list[str]:
    signs = [f"`{SIGNS[kind]}`" for kind in SIGNS if kind in kinds and kind not in OPERATOR_KINDS]
    if "DOT" in kinds:  # after a name; that one copy of a group may be meant goes without saying
        signs = [sign for sign in signs if sign != "`[`"]
    if parts and ("value" in parts[0] or "formula" in parts[0]):
        signs = [sign for sign in signs if sign in ("`)`", "`]`", "`}`")]
    words = [f"`{kind.lower()}`" for kind in ("WITH", "FROM", "IS", "ON", "AT") if kind in kinds]
    if parts and parts[0] in ("an option", "a name") and "`from`" in words:
        words = []
    if "PLUS" in kinds and "AND" in kinds:
        words.append("an operator")
        signs = [sign for sign in signs if sign not in ("`.`", "`(`")]
    return words + signs


def finding(place: ErrorPosition) -> str:
    """The token that stands there, in words."""
    kind, text = place.kind(), place.word()
    if kind == END:
        at_end = place.source.end.start <= place.token()[3]
        return "the end of the file" if at_end else "the end of the statement"
    if kind == "TEXT":
        return 'a text in `"""`'
    shown = text if len(text) <= _SHOWN else text[: _SHOWN - 3] + "..."
    printable = "".join(char if char.isprintable() else "?" for char in shown)
    return f"`{printable}`" if "`" not in printable else printable
