"""The options of `world`: light, weather and friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from ..ir.times_of_day import TIMES_OF_DAY
from .annotations import Angle, Duration, Length, Number, Speed, Word
from .option_types import RecordType
from .options import option


@dataclass(init=False, repr=False, eq=False)
class SunOptions:
    """Position of the sun."""

    azimuth: Angle = option(
        None, minimum=-7, maximum=7, help="azimuth, clockwise from north", example="90deg"
    )
    elevation: Angle = option(
        None,
        minimum=-1.5708,
        maximum=1.5708,
        help="elevation above the horizon",
        example="30deg",
    )


Sun = Annotated[dict[str, float], RecordType(SunOptions)]


@dataclass(init=False, repr=False, eq=False)
class WorldOptions:
    """Options of `world`: light, weather and friction. A backend warns of those it ignores."""

    time_of_day: Duration = option(
        None,
        words=tuple(TIMES_OF_DAY),
        minimum=0,
        maximum=86400,
        help="time since midnight, or a part of the day; `night` is midnight",
        example="14h",
    )
    weather: Word = option(
        None,
        words=("clear", "cloudy", "overcast", "rain", "fog", "snow"),
        help="weather preset",
        example="rain",
    )
    rain: Speed = option(None, minimum=0, help="rainfall rate", example="5mm/h")
    visibility: Length = option(None, above=0, help="visibility", example="300m")
    friction: Number = option(
        None,
        above=0,
        maximum=2,
        help="friction coefficient of the road: about 1 if dry, 0.5 if wet, 0.1 on ice; by default "
        "that of asphalt in this `weather`",
        example="0.7",
    )
    traffic: Word = option(
        None,
        words=("right", "left"),
        help="the side on which vehicles drive; by default the right",
        example="left",
    )
    sun: Sun = option(
        None, help="position of the sun", example="{ azimuth: 90deg, elevation: 30deg }"
    )
