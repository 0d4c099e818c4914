"""Options that kinds have without declaring them: all of a verb have the same."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from ..ir.dimension import PURE
from .option_types import (
    Angle,
    Condition,
    Length,
    ListType,
    QuantityType,
    Stretch,
    Whole,
    Word,
)
from .options import OptionSchema, option, schema_of

RoadNumbers = Annotated[tuple[int, ...], ListType(QuantityType(PURE, whole=True))]


@dataclass(frozen=True)
class PlacementOptions:
    """Where an agent or object stands, beside `on` and `at`."""

    offset: Length = option(
        None,
        minimum=-1000,
        maximum=1000,
        help="left positive, from the center line, or from the lane's; outward with `side`",
    )
    lane: Whole = option(
        None,
        minimum=-32,
        maximum=32,
        help="OpenDRIVE's id: -1 is the first to the right of the center line, 1 to the left",
    )
    side: Word = option(None, words=("left", "right"), help="beside the road, from its edge")
    facing: Word = option(
        None, words=("forward", "back"), help="along the road or against it; the lane's way"
    )
    heading: Angle = option(None, help="counter-clockwise from the road's, or from east")
    count: Whole = option(1, minimum=0, maximum=100_000, help="how many such")


@dataclass(frozen=True)
class PerturbOptions:
    """Options that every kind of `perturb` has."""

    over: Stretch = option(None, minimum=0, help="only on this stretch of the road")
    taper: Length = option(None, minimum=0, help="how long it takes to fade at the stretch's ends")


@dataclass(frozen=True)
class NetworkPerturbOptions(PerturbOptions):
    """In a network, these roads only."""

    roads: RoadNumbers = option(None, minimum=0, help="numbers of the roads; all of them")


@dataclass(frozen=True)
class DriveOptions:
    """Options that every kind of `drive` has."""

    when: Condition = option(
        None, help="takes over once this has come true; the last such is in charge"
    )


_OF_VERB = {
    "perturb": NetworkPerturbOptions,
    "drive": DriveOptions,
    "agent": PlacementOptions,
    "object": PlacementOptions,
}


def common_options(verb: str) -> tuple[OptionSchema, ...]:
    """All options that kinds of a verb can have in some statement without declaring them."""
    return schema_of(_OF_VERB[verb]) if verb in _OF_VERB else ()
