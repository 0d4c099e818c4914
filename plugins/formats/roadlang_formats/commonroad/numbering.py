"""Ids: CommonRoad counts all elements of a file together."""

from __future__ import annotations


class Numbering:
    """From 1 on."""

    def __init__(self) -> None:
        self._last = 0

    def next(self) -> int:
        """One that no other element has."""
        self._last += 1
        return self._last
