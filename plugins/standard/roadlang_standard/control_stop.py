"""`control with stop`: stop signs at minor roads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import JunctionControl, RightOfWay, option
from roadlang.geometry import minor_roads

if TYPE_CHECKING:
    from roadlang.geometry import Junction


@dataclass(frozen=True)
class Stop(JunctionControl):
    """Minor roads stop, then yield to the main road."""

    name: ClassVar[str] = "stop"
    roads: tuple[int, ...] | None = option(
        None,
        minimum=0,
        help="ids of the roads whose traffic stops; by default all but the widest, "
        "straightest road",
        example="[12]",
    )

    def right_of_way(self, junction: Junction) -> RightOfWay:
        """The given roads that end here, else those beside the road that goes on."""
        edges = {arm.edge for arm in junction.arms}
        chosen = minor_roads(junction, clearly=False) if self.roads is None else self.roads
        return RightOfWay("stop", tuple(road for road in chosen if road in edges))
