"""The other agents of a scene, as a controller sees them that decides for one agent."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..ir.control import Observation
from ..ir.read_only import ReadOnlyMapping
from .observing import View


class OthersSeen(ReadOnlyMapping[str, Observation]):
    """What all agents of one scene see, by name; few controllers look at it."""

    __slots__ = ("_known", "_rows", "_view")

    def __init__(self, view: View, rows: Mapping[str, int]) -> None:
        """`rows`: of the agents, in the columns of the world."""
        self._view = view
        self._rows = rows
        self._known: dict[str, Observation] = {}

    def __getitem__(self, name: str) -> Observation:
        if name not in self._known:
            self._known[name] = self._view.single(self._rows[name])
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)
