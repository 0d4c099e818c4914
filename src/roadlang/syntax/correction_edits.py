"""The roads of a network that a human has drawn, dismissed or confirmed: options of its block."""

from __future__ import annotations

from dataclasses import dataclass

from .text_edits import Place, declared, options_of, replaced, with_item
from .tree.nodes import (
    Expression,
    Geometry,
    ListValue,
    NegateExpression,
    NumberLiteral,
    Option,
    Point,
)

Line = tuple[Place, ...]


@dataclass(frozen=True)
class WrittenCorrections:
    """Pixels of the picture, as the options of the same names list them."""

    drawn: tuple[Line, ...] = ()
    dismissed: tuple[Line, ...] = ()
    confirmed: Line = ()


def corrections_of(text: str, name: str) -> WrittenCorrections | None:
    """Those of a network; None where they are not written as numbers of pixels."""
    statement = declared(text, name)
    if not isinstance(statement, Geometry):
        return None
    options = options_of(statement.block)
    drawn, dismissed = (_lines(options.get(key)) for key in ("drawn", "dismissed"))
    confirmed = () if "confirmed" not in options else _line(options["confirmed"])
    if drawn is None or dismissed is None or confirmed is None:
        return None
    return WrittenCorrections(drawn, dismissed, confirmed)


def with_corrections(text: str, name: str, corrections: WrittenCorrections) -> str | None:
    """The text with these corrections of a network instead of those it has; None where the network
    is not declared in it."""
    written = {
        "drawn": _written_lines(corrections.drawn),
        "dismissed": _written_lines(corrections.dismissed),
        "confirmed": _written_line(corrections.confirmed) if corrections.confirmed else "",
    }
    for key, value in written.items():
        statement = declared(text, name)
        if not isinstance(statement, Geometry):
            return None
        found = {option.key.text: option for option in _options(statement)}
        if key in found:
            text = _changed(text, found[key], value)
        elif value:
            text = with_item(text, statement, f"{key}: {value}")
    return text


def _options(statement: Geometry) -> tuple[Option, ...]:
    return () if statement.block is None else tuple(statement.block.options)


def _changed(text: str, option: Option, value: str) -> str:
    """The text with another value of an option, or without it."""
    if value:
        return replaced(text, [(option.value.span, value)])
    start, end = option.span.start, option.span.end
    before, after = text[:start].rstrip(" \t"), text[end:].lstrip(" \t")
    if after.startswith(","):
        after = after[1:].lstrip(" \t")
    elif before.endswith(","):
        before = before[:-1]
    if before.endswith("\n") and after.startswith(("\n", "\r\n")):
        after = after.partition("\n")[2]
        return before + after
    return f"{before} {after}" if before[-1:] not in "{ \n" or after[:1] == "}" else before + after


def _lines(value: Expression | None) -> tuple[Line, ...] | None:
    if value is None:
        return ()
    if not isinstance(value, ListValue):
        return None
    found = [line for item in value.items if (line := _line(item)) is not None]
    return tuple(found) if len(found) == len(value.items) else None


def _line(value: Expression) -> Line | None:
    if not isinstance(value, ListValue):
        return None
    found = [place for item in value.items if (place := _place(item)) is not None]
    return tuple(found) if len(found) == len(value.items) else None


def _place(value: Expression) -> Place | None:
    if not isinstance(value, Point) or len(value.items) != 2:
        return None
    x, y = (_pixels(item) for item in value.items)
    return None if x is None or y is None else (x, y)


def _pixels(value: Expression) -> float | None:
    if isinstance(value, NegateExpression):
        inner = _pixels(value.operand)
        return None if inner is None else -inner
    is_number = isinstance(value, NumberLiteral) and value.unit in ("", "px")
    return value.value if is_number and isinstance(value, NumberLiteral) else None


def _written_lines(lines: tuple[Line, ...]) -> str:
    return f"[{', '.join(map(_written_line, lines))}]" if lines else ""


def _written_line(line: Line) -> str:
    return f"[{', '.join(f'({_written(x)}, {_written(y)})' for x, y in line)}]"


def _written(pixels: float) -> str:
    """To a tenth of a pixel."""
    return f"{round(pixels, 1) + 0.0:g}px" if abs(pixels) < 1e5 else f"{pixels:.0f}px"
