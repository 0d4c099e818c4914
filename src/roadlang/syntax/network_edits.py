"""The places of a network that a human has moved: its options `moved_at` and `moved_by`."""

from __future__ import annotations

from dataclasses import dataclass

from .text_edits import (
    Place,
    declared,
    meters_of,
    options_of,
    places_of,
    replaced,
    with_item,
    written_places,
)
from .tree.nodes import Expression, Geometry, Name


@dataclass(frozen=True)
class NetworkMoves:
    """Places of the network as it was found, by how much each is moved, and the distance in meters
    within which everything moves with it, None where the text does not say it."""

    at: tuple[Place, ...] = ()
    by: tuple[Place, ...] = ()
    radius: float | None = None


def found_network(text: str, name: str) -> str | None:
    """The network, of those that a network is derived from, that was found in a picture or a file;
    None where it is not declared in this text."""
    seen: set[str] = set()  # a text that is wrong may derive a network from itself
    while name not in seen:
        seen.add(name)
        statement = declared(text, name)
        if not isinstance(statement, Geometry) or statement.word != "network":
            return None
        source = statement.source
        below = declared(text, source.text) if isinstance(source, Name) else None
        if not isinstance(below, Geometry) or below.word != "network":
            return name
        name = below.name.text
    return None


def network_moves_of(text: str, name: str) -> NetworkMoves | None:
    """The moves of a network; None where they are not written as numbers."""
    options = _options(text, name)
    if options is None:
        return None
    at, by = places_of(options.get("moved_at")), places_of(options.get("moved_by"))
    written = options.get("moved_radius")
    radius = None if written is None else meters_of(written)
    if at is None or by is None or len(at) != len(by) or (written and radius is None):
        return None
    return NetworkMoves(at, by, radius)


def with_network_moves(text: str, name: str, moves: NetworkMoves) -> str | None:
    """The text with these moves of a network, at least one."""
    statement, options = declared(text, name), _options(text, name)
    if options is None or not isinstance(statement, Geometry) or not moves.at:
        return None
    at, by = written_places(moves.at), written_places(moves.by)
    if "moved_at" in options and "moved_by" in options:
        return replaced(text, [(options["moved_at"].span, at), (options["moved_by"].span, by)])
    return with_item(text, statement, f"moved_at: {at}, moved_by: {by}")


def _options(text: str, name: str) -> dict[str, Expression] | None:
    statement = declared(text, name)
    if not isinstance(statement, Geometry):
        return None
    return options_of(statement.block)
