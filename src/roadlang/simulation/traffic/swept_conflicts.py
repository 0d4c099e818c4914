"""Where vehicles of given sizes meet on two connections of a junction: found once for each pair."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene_junctions import SceneJunction
from .junction_tables import CROSS, MERGE
from .swept_paths import SweptPath, VehicleSize

UNKNOWN = -1


@dataclass(frozen=True)
class Conflicts:
    """Of pairs of a crossing and another, arrays of any shape."""

    kind: Integers
    """`CROSS`, `MERGE` or 0"""
    begin: Floats
    """meters from the stop line to the front of the first as it comes to where the other passes"""
    end: Floats
    """and to its rear as it has left"""


class SweptConflicts:
    """Conflicts of J junctions. Those whose connections are the same share the results, which do
    not depend on which asks first."""

    def __init__(self, junctions: Sequence[SceneJunction], sizes: tuple[VehicleSize, ...]) -> None:
        known: dict[Any, int] = {}
        plans: list[SceneJunction] = []
        numbers = []
        for junction in junctions:
            key = _geometry(junction)
            if key not in known:
                known[key] = len(plans)
                plans.append(junction)
            numbers.append(known[key])
        self._sizes, self._plans = sizes, plans
        self._plan = np.array(numbers, dtype=np.int64)
        counts = np.array([len(plan.connections) for plan in plans], dtype=np.int64) * len(sizes)
        self._count = counts
        self._first = np.concatenate([[0], np.cumsum(counts * counts)])
        # Few of all pairs ever meet: those that were asked for are sorted by their number.
        self._pairs = np.array([UNKNOWN])
        self._places = np.array([0])
        """where each of these pairs is in the columns"""
        self._paths: dict[tuple[int, int], SweptPath] = {}
        self._planned = [_planned(plan) for plan in plans]
        self._found = Conflicts(np.zeros(1, dtype=np.int64), np.zeros(1), np.zeros(1))

    def of(
        self, junction: Integers, first: tuple[Integers, Integers],
        second: tuple[Integers, Integers], there: Booleans,
    ) -> Conflicts:  # fmt: skip
        """Of pairs at junctions: each the places of the connections and the sizes; none where a
        pair is not `there`."""
        plan = self._plan[junction]
        sizes, count = len(self._sizes), self._count[plan]
        one, two = (connection * sizes + size for connection, size in (first, second))
        pair = np.where(there, self._first[plan] + one * count + two, 0)
        place = self._place(pair)
        unknown = np.unique(pair[there & (place == UNKNOWN)])
        if len(unknown):
            self._look_up(unknown)
            place = self._place(pair)
        place = np.where(there, place, 0)
        found = self._found
        return Conflicts(found.kind[place], found.begin[place], found.end[place])

    def _place(self, pairs: Integers) -> Integers:
        """Where pairs are in the columns, or `UNKNOWN`."""
        at = np.minimum(np.searchsorted(self._pairs, pairs), len(self._pairs) - 1)
        place: Integers = np.where(self._pairs[at] == pairs, self._places[at], UNKNOWN)
        return place

    def _look_up(self, pairs: Integers) -> None:
        """Compute the conflicts of pairs that are not known yet, in both orders."""
        rows: list[tuple[int, float, float]] = []
        places: dict[int, int] = {}
        filled = len(self._found.kind)
        plans = np.searchsorted(self._first, pairs, side="right") - 1
        for pair, plan in zip(pairs.tolist(), plans.tolist(), strict=True):
            if pair in places:
                continue
            count, first = int(self._count[plan]), int(self._first[plan])
            one, two = divmod(pair - first, count)
            kind, intervals = self._between(plan, one, two)
            here = filled + len(rows)
            rows += [(kind, *interval) for interval in intervals]
            places[pair] = here if kind else 0
            places[first + two * count + one] = here + 1 if kind else 0
        self._remember(places)
        if rows:
            new = np.array(rows)
            old = self._found
            self._found = Conflicts(
                np.concatenate([old.kind, new[:, 0].astype(np.int64)]),
                np.concatenate([old.begin, new[:, 1]]),
                np.concatenate([old.end, new[:, 2]]),
            )

    def _remember(self, places: dict[int, int]) -> None:
        pairs = np.concatenate([self._pairs, np.array(list(places), dtype=np.int64)])
        order = np.argsort(pairs)
        self._pairs = pairs[order]
        self._places = np.concatenate([self._places, np.array(list(places.values()))])[order]

    def _between(
        self, plan: int, one: int, two: int
    ) -> tuple[int, tuple[tuple[float, float], ...]]:
        """Kind and intervals of a pair; 0 and none for no conflict."""
        sizes = len(self._sizes)
        connections = self._plans[plan].connections
        first, second = connections[one // sizes], connections[two // sizes]
        paths = self._path(plan, one), self._path(plan, two)
        # Out of one lane, who is behind follows who is ahead until their ways part.
        parts = first.source == second.source
        found = SweptPath.meets_again(*paths) if parts else SweptPath.meets(*paths)
        if found is None:
            return 0, ()
        kind = MERGE if first.target == second.target else CROSS
        return self._planned[plan].get((first.id, second.id), kind), found

    def _path(self, plan: int, one: int) -> SweptPath:
        key = plan, one
        if key not in self._paths:
            place, size = divmod(one, len(self._sizes))
            connection = self._plans[plan].connections[place]
            self._paths[key] = SweptPath.of(connection, self._sizes[size])
        return self._paths[key]


def _geometry(junction: SceneJunction) -> Any:
    """What conflicts depend on."""
    return tuple(
        (one.source, one.target, one.start, one.pieces, one.widths[0])
        for one in junction.connections
    ), tuple((one.a, one.b, one.kind) for one in junction.conflicts)


def _planned(junction: SceneJunction) -> dict[tuple[int, int], int]:
    """Of the pairs of ids of connections that the plan of the junction names."""
    kinds = {"cross": CROSS, "merge": MERGE}
    pairs = [(one.a, one.b, kinds[one.kind]) for one in junction.conflicts if one.kind in kinds]
    return {key: kind for a, b, kind in pairs for key in ((a, b), (b, a))}
