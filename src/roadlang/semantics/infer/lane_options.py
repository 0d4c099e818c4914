"""The options that roads and networks share: their lanes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Literal

from ...plugins.annotations import Flag, Integer, Length, Speed
from ...plugins.option_types import CallType, ListType
from ...plugins.options import option

LaneList = Annotated[tuple[Any, ...], ListType(CallType("lane"))]


@dataclass(frozen=True)
class CrossSectionOptions:
    """Options of `road` and `network`: which lanes there are."""

    lanes: Integer = option(
        2,
        minimum=1,
        maximum=32,
        help="number of driving lanes of equal width, both directions together",
    )
    left: LaneList = option(
        None,
        help="lanes to the left of the middle, from the middle outwards",
        example="[drive(3.25m), sidewalk(2m)]",
    )
    right: LaneList = option(
        None,
        help="lanes to the right of the middle, from the middle outwards",
        example="[drive(3.25m), parking(2.3m), sidewalk(2m)]",
    )
    oneway: Flag = option(False, help="whether all traffic runs in the direction of the road")
    sidewalks: Length = option(
        None,
        above=0,
        maximum=50,
        help="width of a sidewalk on either side, next to `lanes`",
        example="2m",
    )
    center_marking: Literal["solid", "broken", "double", "none"] = option(
        None,
        help="the line between the directions; by default broken, double from four lanes on",
        example="double",
    )
    speed_limit: Speed = option(
        None, above=0, help="speed limit of all lanes that say none", example="50km/h"
    )
