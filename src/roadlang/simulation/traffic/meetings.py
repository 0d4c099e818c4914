"""Agents that meet at a junction, as padded groups, with how their connections conflict."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..surroundings.sorted_groups import sorted_groups
from .junction_tables import CROSS, MERGE, JunctionTables
from .swept_conflicts import SweptConflicts


@dataclass(frozen=True)
class Meetings:
    """G groups of at most P crossings at one junction of one scene: arrays (G, P).

    A crossing is that of an agent, `row`, at its place `slot` among the crossings of the agent.
    Of pairs, arrays (G, P, P), the first is who looks at the second.
    """

    key: Integers
    """(G,) scene and junction"""
    row: Integers
    slot: Integers
    is_there: Booleans
    """else it is padding"""
    conflict: Integers
    """(G, P, P), 0 for none"""
    begin: Floats
    """(G, P, P) meters from the stop line to the front of the first as it comes to the ground that
    the second covers, ..."""
    end: Floats
    """... and to its rear as it has left that"""
    yields: Booleans
    """(G, P, P) the first to the second"""
    target: Integers
    """number in its junction of the lane that the connection enters"""

    @classmethod
    def of(
        cls, crossing: Booleans, junction: Integers, place: Integers, scene: Integers,
        size: Integers, tables: JunctionTables, conflicts: SweptConflicts,
    ) -> Meetings:  # fmt: skip
        """Of the crossings (N, X) that are true; `junction` and connection `place` of each, and the
        scene and the number of the size (N,) of each agent."""
        row, slot = np.nonzero(crossing)
        key = scene[row] * len(tables.first) + junction[row, slot]
        sort = np.argsort(key, kind="stable")
        row, slot = row[sort], slot[sort]
        keys, start, group = sorted_groups(key[sort])
        count = np.diff(start, append=len(group))
        shape = len(keys), int(count.max(initial=1))
        at = group, np.arange(len(row)) - start[group]
        is_there = np.zeros(shape, dtype=bool)
        rows, slots, target = (np.zeros(shape, dtype=np.int64) for _ in range(3))
        is_there[at], rows[at], slots[at] = True, row, slot
        number, connection = junction[rows, slots], place[rows, slots]
        number = np.where(is_there, number, 0)
        connection = np.where(is_there, connection, 0)
        target = tables.target[tables.first[number] + connection]
        pair = (
            tables.pair[number][:, :, None]
            + connection[:, :, None] * (tables.count[number][:, :, None])
        )
        pair = pair + connection[:, None, :]
        both = is_there[:, :, None] & is_there[:, None, :]
        both &= ~np.eye(shape[1], dtype=bool)
        pair = np.where(both, pair, 0)
        sizes = size[rows]
        one = connection[:, :, None], sizes[:, :, None]
        found = conflicts.of(number[:, :, None], one, (connection[:, None], sizes[:, None]), both)
        return cls(
            keys, rows, slots, is_there, found.kind, found.begin, found.end,
            tables.yields[pair] & both, target,
        )  # fmt: skip

    @cached_property
    def share_exit(self) -> Booleans:
        """(G, P, P) who enter the same lane."""
        both = self.is_there[:, :, None] & self.is_there[:, None, :]
        both &= ~np.eye(self.row.shape[1], dtype=bool)
        return np.asarray(both & (self.target[:, :, None] == self.target[:, None, :]))

    @cached_property
    def shares_any(self) -> bool:
        """Whether anybody enters the lane of another."""
        return bool(self.share_exit.any())

    @cached_property
    def crosses(self) -> Booleans:
        """(G, P, P) whose ways cross."""
        return np.asarray(self.conflict == CROSS)

    @cached_property
    def merges(self) -> Booleans:
        """(G, P, P) whose ways merge."""
        return np.asarray(self.conflict == MERGE)

    @cached_property
    def has_conflicts(self) -> bool:
        """Whether anybody meets another on its way."""
        return bool(self.conflict.any())

    @cached_property
    def has_merges(self) -> bool:
        """Whether the ways of any two merge."""
        return bool(self.merges.any())

    @cached_property
    def there(self) -> tuple[Integers, Integers]:
        """(K,) agents and slots of the crossings, without padding."""
        return self.row[self.is_there], self.slot[self.is_there]

    def of_crossings(self, values: np.ndarray) -> np.ndarray:
        """(G, P) of an array (N, X)."""
        return np.asarray(values[self.row, self.slot])

    def of_agents(self, values: np.ndarray) -> np.ndarray:
        """(G, P) of an array (N,)."""
        return np.asarray(values[self.row])
