"""Roads with the same lanes, such as those that are one road bent in many ways: what follows from
their lanes alone is found once."""

from __future__ import annotations

from typing import Any

from ...ir.scene import SceneRoad


class RoadForms:
    """Numbers of the lanes that roads have."""

    def __init__(self) -> None:
        self._known: dict[Any, int] = {}
        """by identity: the hash of lanes takes as long as all else"""
        self._equal: dict[Any, int] = {}
        self._kept: list[Any] = []
        """whose identities are known"""

    def number(self, road: SceneRoad) -> int | None:
        """The same of all roads with equal lanes and an equal line between lanes 1 and -1; None of
        a road that lists no lanes."""
        lanes, offset = road.lane_list, road.center_offset
        if not lanes:
            return None
        key = id(lanes), id(offset), road.center_marking
        found = self._known.get(key)
        if found is None:
            self._kept.append((lanes, offset))
            found = self._equal.setdefault((lanes, offset, key[2]), len(self._equal))
            self._known[key] = found
        return found
