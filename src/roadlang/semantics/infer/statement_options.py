"""The options of statements, and those that every kind of a verb has in one.

Declared as kinds declare theirs, so that one reader checks them and one generator documents them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from ...plugins.option_types import (
    Angle,
    CallType,
    Duration,
    Flag,
    KindNameType,
    Length,
    MapType,
    Number,
    RecordType,
    Scale,
    Speed,
    Whole,
    Word,
)
from ...plugins.options import option

Legend = Annotated[dict[str, str], MapType(KindNameType("object"))]
Selection = Annotated[Any, CallType("select")]


@dataclass(frozen=True)
class ImageOptions:
    """A picture from above."""

    scale: Scale = option(
        None, above=0, maximum=1000, help="meters for each pixel; a world file may say it too"
    )
    legend: Legend = option(
        None,
        words=("road",),
        help="what a character, or a color such as `white` or `#2e7d32`, stands for",
    )


@dataclass(frozen=True)
class NetworkOptions:
    """Roads that meet at nodes."""


@dataclass(frozen=True)
class RoadOptions:
    """One curve."""

    select: Selection = option(
        "longest",
        words=("longest", "any"),
        help="which road of a network; `any` draws one for each scene",
    )
    width: Length = option(None, above=0, maximum=200, help="from edge to edge; the source's")
    lanes: Whole = option(2, minimum=1, maximum=32, help="how many, both ways together")
    closed: Flag = option(None, help="whether the end joins the start; the source's")


@dataclass(frozen=True)
class SunOptions:
    """Where the sun stands."""

    azimuth: Angle = option(None, minimum=-7, maximum=7, help="clockwise from north")
    elevation: Angle = option(None, minimum=-1.5708, maximum=1.5708, help="above the horizon")


Sun = Annotated[dict[str, float], RecordType(SunOptions)]


@dataclass(frozen=True)
class WorldOptions:
    """Light, weather and grip. A backend says which of them it cannot honor."""

    time_of_day: Duration = option(None, minimum=0, maximum=86400, help="since midnight: `14h`")
    weather: Word = option(
        None,
        words=("clear", "cloudy", "overcast", "rain", "fog", "snow"),
        help="what the sky does",
    )
    rain: Speed = option(None, minimum=0, help="how much, as in `5mm/h`")
    visibility: Length = option(None, above=0, help="how far one sees")
    friction: Number = option(None, above=0, maximum=2, help="of the road: 1 is dry, 0.1 is ice")
    sun: Sun = option(None, help="`{ azimuth: 90deg, elevation: 30deg }`")
