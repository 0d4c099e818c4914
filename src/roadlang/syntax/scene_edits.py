"""Writes what a human moved in a window back into the scene file's text."""

from __future__ import annotations

from .text_edits import (
    Place,
    declared,
    meters_of,
    place_of,
    replaced,
    statements_of,
    written_length,
    written_place,
)
from .tree.nodes import Actor, Expression, Geometry, ListValue

FEWEST_WAYPOINTS = 2
_LINE_END = "\n"


def thing_moved(text: str, name: str, to: Place) -> str | None:
    """The text with the agent or object `NAME ... at (x, y)` moved; None where it is not placed by
    a point."""
    found = declared(text, name)
    if not isinstance(found, Actor) or found.at is None or place_of(found.at) is None:
        return None
    return replaced(text, [(found.at.span, written_place(to))])


def thing_moved_along(text: str, name: str, start: float, sideways: float) -> str | None:
    """The text with an agent or object on a road that begins at `start`, meters along it.

    An `offset` that is written as a number grows by `sideways`, meters to the left. None where the
    thing is not placed by one position along a road.
    """
    found = declared(text, name)
    if not isinstance(found, Actor) or found.on is None or place_of(found.at) is not None:
        return None
    if found.at is None:
        end = found.on.span.end
        changes = [(found.on.span, f"{text[found.on.span.start : end]} at {written_length(start)}")]
    else:
        changes = [(found.at.span, written_length(start))]
    options = {} if found.block is None else {o.key.text: o.value for o in found.block.options}
    offset = meters_of(options.get("offset"))
    if offset is not None:
        side = getattr(options.get("side"), "text", "")
        offset += -sideways if side == "right" else sideways
        changes.append(
            (options["offset"].span, written_length(max(offset, 0.0) if side else offset))
        )
    return replaced(text, changes)


def offset_of(text: str, name: str) -> float | None:
    """The `offset` of an agent or object, meters, positive to the left; None where it is not
    written as a number."""
    found = declared(text, name)
    if not isinstance(found, Actor) or found.block is None:
        return None
    options = {option.key.text: option.value for option in found.block.options}
    offset = meters_of(options.get("offset"))
    if offset is None:
        return None
    return -offset if getattr(options.get("side"), "text", "") == "right" else offset


def waypoints_of(text: str, road: str) -> list[Place] | None:
    """The waypoints of a road; None where it is not drawn through points written as numbers."""
    found = [place_of(item) for item in _waypoint_items(text, road)]
    places = [place for place in found if place is not None]
    return places if places and len(places) == len(found) else None


def waypoint_moved(text: str, road: str, number: int, to: Place) -> str | None:
    """The text with one of the waypoints of a road elsewhere; None where there is none."""
    items = _waypoint_items(text, road)
    if number >= len(items) or place_of(items[number]) is None:
        return None
    return replaced(text, [(items[number].span, written_place(to))])


def waypoint_inserted(text: str, road: str, number: int, at: Place) -> str | None:
    """The text with one more waypoint, which becomes the one of this number."""
    items = _waypoint_items(text, road)
    if not 0 <= number <= len(items) or not items:
        return None
    if number < len(items):
        span = items[number].span
        words = f"{written_place(at)}, {text[span.start : span.end]}"
    else:
        span = items[-1].span
        words = f"{text[span.start : span.end]}, {written_place(at)}"
    return replaced(text, [(span, words)])


def waypoint_removed(text: str, road: str, number: int) -> str | None:
    """The text without one of the waypoints; None where as few would be left as no road has."""
    items = _waypoint_items(text, road)
    if number >= len(items) or len(items) <= FEWEST_WAYPOINTS:
        return None
    if number + 1 < len(items):
        start, end = items[number].span.start, items[number + 1].span.start
    else:
        start, end = items[number - 1].span.end, items[number].span.end
    return text[:start] + text[end:]


def thing_removed(text: str, name: str) -> str | None:
    """The text without the declaration of an agent or object, and without its line if that is then
    empty."""
    found = declared(text, name)
    if not isinstance(found, Actor):
        return None
    start, end = found.span.start, found.span.end
    first = text.rfind(_LINE_END, 0, start) + 1
    last = text.find(_LINE_END, end)
    last = len(text) if last < 0 else last + 1
    if not (text[first:start] + text[end:last]).strip():
        start, end = first, last
    return text[:start] + text[end:]


def _waypoint_items(text: str, road: str) -> list[Expression]:
    for statement in statements_of(text):
        if not isinstance(statement, Geometry) or statement.name.text != road:
            continue
        for drawing in statement.block.passes if statement.block is not None else ():
            if drawing.verb.text != "draw":
                continue
            for option in drawing.block.options if drawing.block is not None else ():
                if option.key.text == "points" and isinstance(option.value, ListValue):
                    return list(option.value.items)
    return []
