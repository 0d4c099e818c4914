"""The base class of positions: where an agent or object is, by another one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...geometry.arrays import Booleans, Floats, Integers
    from ...geometry.routes.lane_graph import LaneGraph
    from ...geometry.routes.legs import RoutePlace


@dataclass(frozen=True, eq=False)
class Standing:
    """Where copies stand on the road of another: arrays (R, 1)."""

    start: Floats
    """arc length, meters"""
    lane: Integers
    """as in OpenDRIVE; 0 for none"""
    offset: Floats
    """left of the center line, meters, of those in no lane"""
    backward: Booleans
    """whether it faces against the road"""


class Position(Kind):
    """A position, written as a call after `at`: by another (`place`), such as `ahead_of(ego, 20m)`,
    or in a network (`lane_places`), such as `junction(3)`, which is also a point of a `route`.

    A field that names an agent or object holds a `PlacedBatch` of arrays (R, 1): where it is in the
    scene of each of R copies that are placed; of a group, the copy with the same number.
    """

    verb: ClassVar[str] = "position"
    required_methods: ClassVar[tuple[str, ...]] = ("place", "lane_places")
    geometry_is_user_input: ClassVar[bool] = True

    def place(self, length: Floats, width: Floats) -> Standing:
        """Where the copies are placed, on the road of the other agent or object; `length` and
        `width` (R, 1) are their own, in meters. In a network arc length goes on beyond the ends of
        a road along the lanes. A lane that the road does not have is RL613."""
        raise NotImplementedError

    def lane_places(self, lanes: LaneGraph) -> Sequence[RoutePlace]:
        """The places in the lanes of a network that it stands for, of which the one is chosen that
        makes the route the shortest, or, without route, the first with the least penalty. Raises
        GeometryError where the network has none."""
        raise NotImplementedError
