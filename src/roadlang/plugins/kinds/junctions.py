"""Kinds that say who goes first at a junction: `control`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from ... import geometry
    from ...ir.scene_junctions import ControlRule, SignalPhase


@dataclass(frozen=True)
class RightOfWay:
    """Who goes first at one junction.

    `rule` is one of `right_first`, `yield`, `stop`, `all_way_stop`, `signals`. Traffic of the
    `minor` roads (ids in the network) yields or stops; `phases` are those of signals, and `offset`
    the seconds of the first that have passed when a drive begins.
    """

    rule: ControlRule
    minor: tuple[int, ...] = ()
    phases: tuple[SignalPhase, ...] = ()
    offset: float = 0.0


class JunctionControl(Kind):
    """`control with`: the right of way at the junctions of a network."""

    verb: ClassVar[str] = "control"
    required_methods: ClassVar[tuple[str, ...]] = ("right_of_way",)

    def right_of_way(self, junction: geometry.Junction) -> RightOfWay:
        """The rule at a junction. Options are plain values, drawn anew for each junction.

        `geometry.signal_phases(junction)` and `geometry.minor_roads(junction)` say which
        connections may have a green light together, and which roads are minor roads. Anything but a
        `RightOfWay` about roads and connections of this junction is RL474.
        """
        raise NotImplementedError
