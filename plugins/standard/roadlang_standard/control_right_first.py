"""`control with right_first`: the default rule."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import JunctionControl, RightOfWay

if TYPE_CHECKING:
    from roadlang.geometry import Junction


@dataclass(frozen=True)
class RightFirst(JunctionControl):
    """Priority to the right; left turns yield to oncoming traffic."""

    name: ClassVar[str] = "right_first"
    also_called: ClassVar[tuple[str, ...]] = ("right_before_left",)

    def right_of_way(self, junction: Junction) -> RightOfWay:
        """The same at every junction."""
        return RightOfWay("right_first")
