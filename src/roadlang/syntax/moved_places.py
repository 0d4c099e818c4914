"""What a human moved of a road that is not drawn through points: a pass that perturbs it, with the
options `at`, places along the road, and `by`, how far each is moved."""

from __future__ import annotations

from dataclasses import dataclass, replace

from .text_edits import (
    Place,
    declared,
    meters_of,
    options_of,
    places_of,
    replaced,
    with_item,
    without_comments,
    written_length,
    written_places,
)
from .tree.nodes import Geometry, ListValue, Pass

LENGTH = 80.0
"""Meters of road that move with a place, from end to end, where nothing is said."""


@dataclass(frozen=True)
class MovedPlaces:
    """Places along a road, by how much each is moved, and what length of road moves with it."""

    at: tuple[float, ...] = ()
    by: tuple[Place, ...] = ()
    length: float = LENGTH

    def moved(self, station: float, by: Place) -> MovedPlaces:
        """With the place at a station moved on by some meters; a new one where there is none."""
        if station in self.at:
            number = self.at.index(station)
            x, y = self.by[number]
            total = (x + by[0], y + by[1])
            return replace(self, by=(*self.by[:number], total, *self.by[number + 1 :]))
        return replace(self, at=(*self.at, station), by=(*self.by, by))

    def without(self, station: float) -> MovedPlaces:
        """Without the place at a station."""
        left = [pair for pair in zip(self.at, self.by, strict=True) if pair[0] != station]
        return replace(self, at=tuple(at for at, _ in left), by=tuple(by for _, by in left))


def moved_places_of(text: str, road: str) -> MovedPlaces:
    """Those of the last `perturb` of a road, where they are written as numbers; else none."""
    found = _read(_last_pass(declared(text, road)))
    return MovedPlaces() if found is None else found


def with_moved_places(text: str, road: str, places: MovedPlaces, kind: str) -> str | None:
    """The text with these places of a road moved, by a `perturb with` a kind if there is none yet.

    None where the road is not declared here.
    """
    statement = declared(text, road)
    if not isinstance(statement, Geometry):
        return None
    last = _last_pass(statement)
    if last is None or _read(last) is None:
        return _with_pass(text, statement, places, kind) if places.at else text
    if not places.at:
        return _without_pass(text, last)
    at, by = _at(places), written_places(places.by)
    options = options_of(last.block)
    return replaced(text, [(options["at"].span, at), (options["by"].span, by)])


def _last_pass(statement: object) -> Pass | None:
    if not isinstance(statement, Geometry) or statement.block is None:
        return None
    perturbing = [item for item in statement.block.passes if item.verb.text == "perturb"]
    return perturbing[-1] if perturbing else None


def _read(found: Pass | None) -> MovedPlaces | None:
    if found is None:
        return None
    options = options_of(found.block)
    at, moves = options.get("at"), places_of(options.get("by"))
    if not isinstance(at, ListValue) or moves is None:
        return None
    stations = [number for item in at.items if (number := meters_of(item)) is not None]
    length = meters_of(options["length"]) if "length" in options else LENGTH
    if not len(stations) == len(moves) == len(at.items) or length is None:
        return None
    return MovedPlaces(tuple(stations), moves, length)


def _at(places: MovedPlaces) -> str:
    return f"[{', '.join(map(written_length, places.at))}]"


def _with_pass(text: str, statement: Geometry, places: MovedPlaces, kind: str) -> str:
    length = written_length(places.length)
    by = written_places(places.by)
    words = f"perturb with {kind} {{ at: {_at(places)}, by: {by}, length: {length} }}"
    return with_item(text, statement, words)


def _without_pass(text: str, found: Pass) -> str:
    """Without the pass and one comma beside it; comments stay on their lines."""
    start, end = found.span.start, found.span.end
    code = without_comments(text)
    comma = code[end:].lstrip().startswith(",")
    after = code.index(",", end) + 1 if comma else end
    first, last = text.rfind("\n", 0, start) + 1, text.find("\n", after)
    if last >= 0 and not (text[first:start] + text[end : after - comma] + text[after:last]).strip():
        return text[:first] + text[last + 1 :]
    if comma:
        return text[:start] + text[end : after - 1] + text[after:].lstrip(" \t")
    before = code[:start].rstrip()
    kept = len(before.removesuffix(","))
    between = text[len(before) : start]
    return text[:kept] + (between if between.strip() else "") + text[end:]
