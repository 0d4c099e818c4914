"""Turn restrictions of an extract of OpenStreetMap, by the ends of roads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, TypeAlias

from .records import OsmRestriction

StreetEnds: TypeAlias = Mapping[int, tuple[str, str, str, str]]
End: TypeAlias = Literal["start", "end"]
Arm: TypeAlias = tuple[int, End]


def no_turns(
    restrictions: Sequence[OsmRestriction], streets: StreetEnds
) -> dict[int, tuple[tuple[End, int, End], ...]]:
    """By the numbers of edges, the turns that nobody may make from their ends.

    `streets`: by those numbers the first and the last node, and the ways at both ends. A
    restriction counts only where each of its ways has one end at its node, as it should have.
    """
    at: dict[str, list[tuple[Arm, str]]] = {}
    for edge, (first, last, way, last_way) in streets.items():
        at.setdefault(first, []).append(((edge, "start"), way))
        at.setdefault(last, []).append(((edge, "end"), last_way))
    found: dict[int, dict[tuple[End, int, End], None]] = {}
    for each in restrictions:
        arms = at.get(each.node, [])
        sources = [arm for arm, way in arms if way == each.source]
        targets = [arm for arm, way in arms if way == each.target]
        if len(sources) != 1 or len(targets) != 1:
            continue
        (edge, end), target = sources[0], targets[0]
        for arm, _ in arms:
            if (arm == target) != each.only and arm != (edge, end):
                found.setdefault(edge, {})[(end, *arm)] = None
    return {edge: tuple(turns) for edge, turns in found.items()}
