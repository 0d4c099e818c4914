"""Changes of a scene file's text at places of its syntax tree; everything else stays."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from ..diagnostics import Source, Span
from .parsing.parser import parse
from .tree.nodes import (
    Actor,
    Block,
    Expression,
    Geometry,
    ListValue,
    NegateExpression,
    NumberLiteral,
    Point,
)

Place = tuple[float, float]

_METERS = {"": 1.0, "m": 1.0, "cm": 0.01, "km": 1000.0}


@lru_cache(maxsize=4)
def statements_of(text: str) -> tuple[Actor | Geometry, ...]:
    """The declarations that can be changed by hand."""
    statements = parse(Source("", text))[0].statements
    return tuple(found for found in statements if isinstance(found, Actor | Geometry))


def declared(text: str, name: str) -> Actor | Geometry | None:
    """The declaration of a name in this text; None where it is in another file."""
    return next((found for found in statements_of(text) if found.name.text == name), None)


def without_comments(text: str) -> str:
    """The text with blanks for its comments: all else is at the same offsets."""
    for comment in parse(Source("", text))[0].comments:
        start, end = comment.span.start, comment.span.end
        text = f"{text[:start]}{' ' * (end - start)}{text[end:]}"
    return text


def meters_of(value: Expression | None) -> float | None:
    """A length that is written as a number; None of anything else."""
    if isinstance(value, NegateExpression):
        inner = meters_of(value.operand)
        return None if inner is None else -inner
    if not isinstance(value, NumberLiteral) or value.unit not in _METERS:
        return None
    return value.value * _METERS[value.unit]


def place_of(value: Expression | None) -> Place | None:
    """A point that is written as two numbers; None of anything else."""
    if not isinstance(value, Point) or len(value.items) != 2:
        return None
    x, y = (meters_of(item) for item in value.items)
    return None if x is None or y is None else (x, y)


def places_of(value: Expression | None) -> tuple[Place, ...] | None:
    """Points of a list that are written as numbers; none where there is no list, None of anything
    else."""
    if value is None:
        return ()
    if not isinstance(value, ListValue):
        return None
    found = [place for item in value.items if (place := place_of(item)) is not None]
    return tuple(found) if len(found) == len(value.items) else None


def written_places(places: Iterable[Place]) -> str:
    """A list of points as it is written."""
    return f"[{', '.join(map(written_place, places))}]"


def options_of(block: Block | None) -> dict[str, Expression]:
    """What is written for each option; nothing without a block."""
    return {} if block is None else {option.key.text: option.value for option in block.options}


def written_length(meters: float) -> str:
    """A length to the centimeter, as it is written."""
    digits = f"{meters:.2f}".rstrip("0").rstrip(".")
    return "0m" if digits in ("-0", "") else f"{digits}m"


def written_place(place: Place) -> str:
    """A point to the centimeter, as it is written."""
    return f"({', '.join(map(written_length, place))})"


def replaced(text: str, changes: Iterable[tuple[Span, str]]) -> str:
    """The text with other words at some places, which do not overlap."""
    for span, words in sorted(changes, key=lambda change: change[0].start, reverse=True):
        text = f"{text[: span.start]}{words}{text[span.end :]}"
    return text


def with_item(text: str, statement: Geometry, words: str) -> str:
    """The text with one more item at the end of the block of a declaration."""
    block = statement.block
    if block is None:
        end = statement.span.end
        return f"{text[:end]} {{ {words} }}{text[end:]}"
    close = block.span.end - 1
    if not block.items:
        return f"{text[: block.span.start]}{{ {words} }}{text[block.span.end :]}"
    line = text.rfind("\n", 0, close) + 1
    if line > block.span.start and not text[line:close].strip():
        return f"{text[:line]}{_indent(text, block)}{words}{_line_end(text)}{text[line:]}"
    end = block.items[-1].span.end
    return f"{text[:end]}, {words}{text[end:]}"


def _indent(text: str, block: Block) -> str:
    """The blanks before the last item of a block."""
    start = block.items[-1].span.start
    line = text[text.rfind("\n", 0, start) + 1 : start]
    return line if not line.strip() else "  "


def _line_end(text: str) -> str:
    return "\r\n" if "\r\n" in text else "\n"
