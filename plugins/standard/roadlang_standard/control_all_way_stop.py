"""`control with all_way_stop`: stop signs at all arms."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import JunctionControl, RightOfWay

if TYPE_CHECKING:
    from roadlang.geometry import Junction


@dataclass(frozen=True)
class AllWayStop(JunctionControl):
    """All-way stop: vehicles go in the order in which they arrive."""

    name: ClassVar[str] = "all_way_stop"
    also_called: ClassVar[tuple[str, ...]] = ("four_way_stop",)

    def right_of_way(self, junction: Junction) -> RightOfWay:
        """The same at every junction."""
        return RightOfWay("all_way_stop")
