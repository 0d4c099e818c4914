"""Writes what a human moved in a window back into the scene file's text."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from ..diagnostics import Source
from .parsing.parser import parse
from .tree.nodes import (
    Actor,
    Expression,
    Geometry,
    ListValue,
    NegateExpression,
    NumberLiteral,
    Point,
)

Place = tuple[float, float]


def object_moved(text: str, name: str, to: Place) -> str | None:
    """The text with `object NAME ... at (x, y)` moved; None where it is not placed by a point."""
    for statement in parse(Source("", text))[0].statements:
        if isinstance(statement, Actor) and statement.name.text == name:
            if _place(statement.at) is None:
                return None
            assert statement.at is not None
            return _replaced(text, statement.at, to)
    return None


def waypoint_moved(text: str, road: str, grabbed: Place, to: Place) -> str | None:
    """The text with the waypoint of `road` nearest to where it was grabbed moved as the hand was.

    None where the road is not drawn through waypoints that are written as numbers.
    """
    found = [(point, _place(point)) for point in _waypoints(text, road)]
    placed = [(point, place) for point, place in found if place is not None]
    if not placed:
        return None
    point, (x, y) = min(
        placed,
        key=lambda candidate: hypot(candidate[1][0] - grabbed[0], candidate[1][1] - grabbed[1]),
    )
    return _replaced(text, point, (x + to[0] - grabbed[0], y + to[1] - grabbed[1]))


def _waypoints(text: str, road: str) -> Iterator[Expression]:
    for statement in parse(Source("", text))[0].statements:
        if not isinstance(statement, Geometry) or statement.name.text != road:
            continue
        for drawing in statement.block.passes if statement.block is not None else ():
            options = drawing.block.options if drawing.block is not None else ()
            for option in options:
                if option.key.text == "points" and isinstance(option.value, ListValue):
                    yield from option.value.items


def _place(value: Expression | None) -> Place | None:
    if not isinstance(value, Point) or len(value.items) != 2:
        return None
    x, y = (_meters(item) for item in value.items)
    return None if x is None or y is None else (x, y)


def _meters(value: Expression) -> float | None:
    if isinstance(value, NegateExpression):
        inner = _meters(value.operand)
        return None if inner is None else -inner
    if not isinstance(value, NumberLiteral) or value.unit not in ("m", "cm", "km", ""):
        return None
    return value.value * {"cm": 0.01, "km": 1000.0}.get(value.unit, 1.0)


def _replaced(text: str, value: Expression, place: Place) -> str:
    span = value.span
    written = ", ".join(f"{round(number, 2) + 0.0:g}m" for number in place)
    return f"{text[: span.start]}({written}){text[span.end :]}"
