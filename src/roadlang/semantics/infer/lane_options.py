"""The options that roads and networks share: their lanes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Literal

from ...ir.scene_surface import SURFACE_NAMES
from ...plugins.annotations import Flag, Integer, Length, Speed, Word
from ...plugins.common_options import IntervalOptions
from ...plugins.option_types import CallType, ListType, RecordType
from ...plugins.options import option

LaneList = Annotated[tuple[Any, ...], ListType(CallType("lane"))]


@dataclass(init=False, repr=False, eq=False)
class PatchOptions(IntervalOptions):
    """A stretch of a road of another surface."""

    surface: Word = option(words=SURFACE_NAMES, help="what it is covered by", example="wet")
    side: Word = option(
        None, words=("left", "right"), help="only the lanes to this side of the center line"
    )
    lane: Integer = option(None, help="only the lane with this number", example="-1")
    road: Integer = option(
        None, minimum=0, help="in a network: only the road with this number", example="3"
    )


Patches = Annotated[tuple[Any, ...], ListType(RecordType(PatchOptions))]


@dataclass(init=False, repr=False, eq=False)
class SurfaceOptions:
    """Options of `road` and `network`: what they are made of or covered by."""

    surface: Word = option(
        None,
        words=SURFACE_NAMES,
        help="what it is made of or covered by; by default asphalt, wet or snowy by the weather",
        example="gravel",
    )
    surface_patches: Patches = option(
        None,
        help="stretches of other surfaces, of some lanes or all; where some overlap the last one "
        "counts",
        example="[{ surface: wet, over: [40m, 60m], side: right }]",
    )


@dataclass(init=False, repr=False, eq=False)
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
        help="lanes to the left of the middle, from the middle outward",
        example="[drive(3.25m), sidewalk(2m)]",
    )
    right: LaneList = option(
        None,
        help="lanes to the right of the middle, from the middle outward",
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
        None, above=0, help="speed limit of all lanes without one of their own", example="50km/h"
    )
