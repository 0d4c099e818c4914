"""What is known of junctions in advance: their connections and rules."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene_junctions import SceneJunction

CROSS, MERGE = 1, 2
RIGHT_FIRST, YIELD, STOP, ALL_WAY_STOP, SIGNALS = range(5)
_RULES = ("right_first", "yield", "stop", "all_way_stop", "signals")


@dataclass(frozen=True)
class JunctionTables:
    """Tables of J junctions with C connections in all.

    Connection c of junction j has the number `first[j] + c`; the pair of a and b the place
    `pair[j] + a * count[j] + b` in `yields`.
    """

    first: Integers
    count: Integers
    pair: Integers
    rule: Integers
    """(J,) one of the constants above"""
    must_stop: Booleans
    """(C,) at a stop sign"""
    yields_any: Booleans
    """(C,) to traffic of another connection"""
    turns: Booleans
    """(C,) to the left or right, or around"""
    target: Integers
    """(C,) number in its junction of the lane that it enters"""
    length: Floats
    """(C,)"""
    yields: Booleans
    """over pairs: a yields to b"""

    @classmethod
    def of(cls, junctions: Sequence[SceneJunction]) -> JunctionTables:
        """The tables of some junctions."""
        counts = np.array([len(junction.connections) for junction in junctions], dtype=np.int64)
        first = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
        pair = np.concatenate([[0], np.cumsum(counts * counts)]).astype(np.int64)
        yields = np.zeros(pair[-1], dtype=bool)
        for number, junction in enumerate(junctions):
            count = counts[number]
            places = _numbers(junction)
            for yielding, passing in junction.yields:
                yields[pair[number] + places[yielding] * count + places[passing]] = True
        every = [connection for junction in junctions for connection in junction.connections]
        rules = [_RULES.index(junction.control.kind) for junction in junctions]
        return cls(
            first[:-1], counts, pair[:-1], np.array(rules, dtype=np.int64),
            np.array([stop for junction in junctions for stop in _stops(junction)], dtype=bool),
            np.array([flag for junction in junctions for flag in _yielding(junction)], dtype=bool),
            np.array([connection.turn != "straight" for connection in every], dtype=bool),
            np.array([goal for junction in junctions for goal in _targets(junction)], np.int64),
            np.array([connection.length for connection in every], dtype=np.float64),
            yields,
        )  # fmt: skip


def _numbers(junction: SceneJunction) -> dict[int, int]:
    return {connection.id: place for place, connection in enumerate(junction.connections)}


def _stops(junction: SceneJunction) -> list[bool]:
    control = junction.control
    if control.kind == "all_way_stop":
        return [True] * len(junction.connections)
    minor = control.minor if control.kind == "stop" else ()
    return [connection.source.road in minor for connection in junction.connections]


def _yielding(junction: SceneJunction) -> list[bool]:
    yielding = {connection for connection, _ in junction.yields}
    return [connection.id in yielding for connection in junction.connections]


def _targets(junction: SceneJunction) -> list[int]:
    known: dict[tuple[str, str, int], int] = {}
    lanes = [(c.target.road, c.target.end, c.target.lane) for c in junction.connections]
    return [known.setdefault(lane, len(known)) for lane in lanes]
