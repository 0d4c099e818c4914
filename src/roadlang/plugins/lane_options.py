"""Options that every kind of lane has without declaring them."""

from __future__ import annotations

from dataclasses import dataclass

from .annotations import Length, Speed
from .kinds.lanes import LaneMarking
from .options import option

SAME_WIDTH = 1e-3
"""Meters by which the lanes that are written may differ from the width of their road."""


@dataclass(init=False, repr=False, eq=False)
class LaneOptions:
    """Options of every kind of lane."""

    width: Length = option(
        None, above=0, maximum=100, help="width; by default that of the kind", example="3.25m"
    )
    speed_limit: Speed = option(
        None, above=0, help="speed limit; by default that of the road", example="30km/h"
    )
    marking: LaneMarking = option(
        None,
        help="the line toward the outer neighbor; by default one that fits the two",
        example="solid",
    )
