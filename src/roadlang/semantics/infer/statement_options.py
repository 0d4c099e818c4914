"""The options of statements, and those that every kind of a verb has in one.

Declared as kinds declare theirs, so that one reader checks them and one generator documents them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from ...ir.dimension import ANGLE, LENGTH, PIXELS, PURE
from ...plugins.annotations import Flag, Length, Scale, Word
from ...plugins.option_types import (
    CallType,
    EntityType,
    KindNameType,
    ListType,
    MapType,
    PointType,
    QuantityType,
    UnionType,
)
from ...plugins.options import option
from .lane_options import CrossSectionOptions, SurfaceOptions

Legend = Annotated[dict[str, str], MapType(KindNameType("object"))]
Selection = Annotated[Any, CallType("select")]
_ROAD = EntityType(("road",))
Within = Annotated[Any, CallType("region")]
Places = Annotated[Any, ListType(PointType(LENGTH), at_least=1)]
Pixels = Annotated[Any, ListType(PointType(PIXELS), at_least=1)]
Strokes = Annotated[Any, ListType(ListType(PointType(PIXELS), at_least=2), at_least=1)]
Stretches = Annotated[Any, ListType(ListType(PointType(PIXELS), at_least=1), at_least=1)]
JoinedRoads = Annotated[Any, UnionType((_ROAD, ListType(_ROAD, at_least=1)))]


_STATION_SPACING = (
    "greatest distance between stations, also of roads derived from this one; by default 1m, or "
    "a 2,000th of the length of a road longer than 2 km"
)


LatitudeLongitude = Annotated[tuple[float, float], PointType(ANGLE, ANGLE)]


@dataclass(init=False, repr=False, eq=False)
class ImageOptions:
    """Options of `image`."""

    scale: Scale = option(
        None,
        above=0,
        maximum=1000,
        help="meters per pixel; by default from GeoTIFF tags or a world file",
        example="0.35m/px",
    )
    origin: LatitudeLongitude = option(
        None,
        help="latitude and longitude of the lower left corner of a picture with north at the top; "
        "by default from GeoTIFF tags or a world file",
        example="(48.137deg, 11.575deg)",
    )
    legend: Legend = option(
        None,
        words=("road", "eastbound", "westbound", "northbound", "southbound"),
        help="meaning of each character of a text image, or of each color of a drawing; "
        "`eastbound` is a one-way road in the direction of the road that is nearest to east",
        example='{ "#": road, "T": tree }',
    )


Weights = Annotated[dict[str, float], MapType(QuantityType(PURE))]


@dataclass(init=False, repr=False, eq=False)
class FormulaOptions:
    """Options of `require` and `expect` with a formula. None of the measures of robustness changes
    what satisfies the formula."""

    robustness: Word = option(
        "space",
        words=("space", "time", "time_left", "average"),
        help="what robustness measures: how much signals may change before the verdict does "
        "(`space`), how far they may be shifted to later or to earlier times or places (`time`, "
        "`time_left`), or the change averaged over windows (`average`)",
        example="average",
    )
    weights: Weights = option(
        None,
        above=0,
        help="how much operands of `and` and `or` count, by the names that `let` gives them; the "
        "others count 1",
        example="{ centered: 3 }",
    )
    semantics: Word = option(
        "sampled",
        words=("sampled", "held", "linear"),
        help="value of signals between two samples: none, that of the earlier sample, or on the "
        "line between both",
        example="linear",
    )
    strict: Flag = option(
        False,
        help="whether a vacuous verdict, which depends on windows without samples, counts as "
        "violated",
        example="true",
    )


@dataclass(init=False, repr=False, eq=False)
class NetworkOptions(SurfaceOptions, CrossSectionOptions):
    """Options of `network`."""

    within: Within = option(
        None,
        help="the part of the map or picture that is kept; roads end where they leave it",
        example="box((-100m, -50m), (200m, 150m))",
    )
    u_turns: Flag = option(
        None,
        help="whether vehicles may turn around at junctions that have room for it; by default "
        "they turn around only at dead ends of maps and at roundabouts",
        example="true",
    )
    drawn: Strokes = option(
        None,
        help="roads of the picture that were not found, each through some of its pixels; they join "
        "the roads near which they end, and those that they cross",
        example="[[(20px, 40px), (90px, 60px)]]",
    )
    dismissed: Stretches = option(
        None,
        help="roads that were found but do not exist: one pixel of a road removes it from junction "
        "to junction, two remove the part between them",
        example="[[(50px, 70px)]]",
    )
    confirmed: Pixels = option(
        None,
        help="pixels of roads that are right; their confidence is 1",
        example="[(30px, 70px)]",
    )
    moved_at: Places = option(
        None,
        help="places of the network, such as junctions, that are moved before any other pass; "
        "`watch` writes this option when a network is dragged",
        example="[(40m, 32m)]",
    )
    moved_by: Places = option(
        None, help="how far each is moved, east and north", example="[(3m, -2m)]"
    )
    moved_radius: Length = option(
        None,
        above=0,
        maximum=10000,
        help="everything within this distance of a place moves with it; by default 80m",
        example="60m",
    )
    station_spacing: Length = option(
        None, minimum=0.01, maximum=100, help=_STATION_SPACING, example="0.5m"
    )


@dataclass(init=False, repr=False, eq=False)
class RoadOptions(SurfaceOptions, CrossSectionOptions):
    """Options of `road`."""

    select: Selection = option(
        "longest",
        words=("longest", "any"),
        help="the longest road of the network, a random one (`any`), `route(p, q)` or `road(id)`",
        example="route((0m, 0m), (80m, 40m))",
    )
    width: Length = option(
        None,
        above=0,
        maximum=200,
        help="width of the drivable lanes, from edge to edge; by default that of the source, or of "
        "the lanes",
        example="7m",
    )
    closed: Flag = option(None, help="whether the road is a loop; by default as in the source")
    then: JoinedRoads = option(
        None,
        help="the road, or a list of roads, that follow the one after `from`, end to end",
        example="[school, avenue]",
    )
    taper: Length = option(
        None,
        above=0,
        maximum=10000,
        help="where roads are joined: the length over which lanes begin, end and change their "
        "width; by default 30m",
        example="60m",
    )
    station_spacing: Length = option(
        None, minimum=0.01, maximum=100, help=_STATION_SPACING, example="0.5m"
    )
