"""Options that kinds have without declaring them: all of a verb have the same.

The classes are tables of options, read by `schema_of`. None is ever an object, so they need none of
the methods of a dataclass, whose making is what costs time when they are imported.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .annotations import (
    Angle,
    Condition,
    Duration,
    ExpectationNames,
    Flag,
    Integer,
    Length,
    LengthInterval,
    Number,
    Speed,
    Word,
)
from .common_types import JunctionNumbers, LaneChoice, Points, RoadNumbers, RoutePoints
from .lane_options import LaneOptions
from .options import OptionSchema, option, schema_of

MOST_COPIES = 10_000
"""Of an agent or object, also of a `count` that is drawn."""


@dataclass(init=False, repr=False, eq=False)
class PlacementOptions:
    """Options of `agent` and `object`: where it is, relative to `on` and `at`."""

    offset: Length = option(
        None,
        minimum=-1000,
        maximum=1000,
        help="lateral offset, positive to the left, from the center line or from the center of "
        "`lane`; with `side`, outward from the road edge. An agent that drives in a lane steers "
        "to its center from there; with `lane: none` it keeps its offset",
        example="0.5m",
    )
    lane: LaneChoice = option(
        None,
        words=("none", "outer"),
        minimum=-32,
        maximum=32,
        help="lane id as in OpenDRIVE: -1 is the first lane to the right of the center line, 1 the "
        "first to the left; or `outer`, a kind of lane, or `none`; by default an agent is in the "
        "first lane of its direction, an object in none",
        example="-1",
    )
    side: Word = option(
        None,
        words=("left", "right"),
        help="places it beside the road, on this side; with a kind of lane, selects the lane on "
        "this side",
        example="right",
    )
    facing: Word = option(
        None,
        words=("forward", "back"),
        help="along the road or against it; by default the direction of the lane; in a parking "
        "lane, that of the adjacent driving lanes",
        example="back",
    )
    heading: Angle = option(
        None,
        help="heading, counter-clockwise from the direction of the road; without a road, from east",
        example="30deg",
    )
    count: Integer = option(
        1,
        minimum=0,
        maximum=MOST_COPIES,
        help="number of copies; each draws its own random values",
        example="integer(0, 3)",
    )
    spacing: Length = option(
        None,
        minimum=-10_000,
        maximum=10_000,
        help="puts the copies of a `count` in a row, this far apart from center to center; the "
        "first is at `at`, the others ahead of it, or behind it if the spacing is negative; with "
        "`at behind(...)` the row extends backward",
        example="5m..9m",
    )
    apart: Length = option(
        None,
        minimum=0,
        maximum=1000,
        help="minimum distance to all other agents and objects, between outlines; of two, the "
        "larger counts, and at least 0.5m",
        example="2m",
    )
    overlap: Flag = option(False, help="whether it may overlap other agents and objects")


@dataclass(init=False, repr=False, eq=False)
class AgentOptions(PlacementOptions):
    """Options of `agent`."""

    start_speed: Speed = option(
        None,
        minimum=0,
        maximum=150,
        help="speed at the start; by default the target speed of its first controller if the "
        "agent is in a lane, else 0",
        example="40km/h",
    )
    route: RoutePoints = option(
        None,
        words=("random", "left", "straight", "right", "turn_around"),
        help="in a network: the points to pass, in order, along lanes by the shortest way, and the "
        "turns to take at the junctions on it (`left`, `straight`, `right`, `turn_around`); or "
        "`random`, turn by turn, the default of an agent that drives; without `at` it begins at "
        "the first point, or anywhere",
        example="[(0m, 0m), (120m, 80m)]",
    )
    route_length: Length = option(
        None,
        above=0,
        maximum=100_000,
        help="length of a random route; by default 2km, or to where the roads end",
        example="300m",
    )


@dataclass(init=False, repr=False, eq=False)
class IntervalOptions:
    """Options of what may be on a part of a road only."""

    over: LengthInterval = option(
        None,
        minimum=0,
        help="interval of arc length of the root road; by default the whole road",
        example="[50m, 120m]",
    )


@dataclass(init=False, repr=False, eq=False)
class PerturbOptions(IntervalOptions):
    """Options of every `perturb with`."""

    taper: Length = option(
        None, minimum=0, help="length of the transition at both ends of `over`", example="15m"
    )


@dataclass(init=False, repr=False, eq=False)
class NetworkPerturbOptions(PerturbOptions):
    """Options of every `perturb with` in a network."""

    roads: RoadNumbers = option(
        None, minimum=0, help="ids of the roads to perturb; by default all", example="[1, 4]"
    )


@dataclass(init=False, repr=False, eq=False)
class ControlOptions:
    """Options of every `control with`."""

    junctions: JunctionNumbers = option(
        None,
        minimum=0,
        help="ids of the junctions; by default all but roundabouts",
        example="[3, 7]",
    )
    near: Points = option(
        None,
        help="or points: the junctions that are nearest to them",
        example="[(120m, 75m)]",
    )


@dataclass(init=False, repr=False, eq=False)
class DriveOptions:
    """Options of every `drive with`."""

    when: Condition = option(
        None,
        help="the controller takes over when this becomes true; the last one to do so is active",
        example="distance(ego, lead) < 15m",
    )
    while_: Condition = option(
        None,
        help="the controller is active only as long as this is true; then the one before it is "
        "active again",
        example="gap(ego, lead) < 10m",
    )


@dataclass(init=False, repr=False, eq=False)
class SenseOptions:
    """Options of every `sense with`. Times are rounded to decisions of the controllers."""

    every: Duration = option(
        None,
        above=0,
        maximum=3600,
        help="time between two readings; each is held until the next one. By default the time "
        "between two decisions of the controllers",
        example="100ms",
    )
    delay: Duration = option(
        0.0, minimum=0, maximum=60, help="time from a measurement to its arrival", example="100ms"
    )
    dropout: Number = option(
        0.0,
        minimum=0,
        maximum=1,
        help="share of the readings that do not arrive; the last one that did is held",
        example="2%",
    )


@dataclass(init=False, repr=False, eq=False)
class FalsifyOptions:
    """Options of every `falsify with`."""

    expects: ExpectationNames = option(
        (),
        help="the expectations to violate, the most important first; by default all, in the order "
        "of the file",
        example="[in_lane, arrives]",
    )
    evaluations: Integer = option(
        1_000, minimum=1, maximum=100_000_000, help="stop after this many candidates"
    )
    failures: Integer = option(
        None,
        minimum=1,
        help="stop after this many distinct failures: of different expectations, "
        "against different agents, on roads whose curvature differs by more than 0.008/m "
        "(root mean square), or with first violations 10 m/s or 100 m apart",
        example="20",
    )
    seconds: Duration = option(
        None,
        above=0,
        help="stop after this time; what is found then depends on the machine",
        example="600s",
    )
    batch: Integer = option(
        500,
        minimum=1,
        maximum=100_000,
        help="greatest number of candidates that are evaluated together",
    )
    islands: Integer = option(
        1, minimum=1, maximum=10_000, help="number of independent searches side by side"
    )
    random: Number = option(
        0.05,
        minimum=0,
        maximum=1,
        help="share of candidates that are drawn at random, to estimate the failure rate",
    )
    after_violation: Duration = option(
        2.0,
        minimum=0,
        help="how long a drive goes on after every `expect always` about it is violated, where the "
        "simulator can tell, as the embedded engine can; no verdict depends on it, but robustness "
        "may fall further in a longer drive",
        example="1h",
    )


_OF_VERB = {
    "lane": LaneOptions,
    "perturb": NetworkPerturbOptions,
    "control": ControlOptions,
    "drive": DriveOptions,
    "sense": SenseOptions,
    "agent": AgentOptions,
    "object": PlacementOptions,
    "falsify": FalsifyOptions,
}


def common_options(verb: str) -> tuple[OptionSchema, ...]:
    """All options that kinds of a verb can have in some statement without declaring them."""
    return schema_of_common(_OF_VERB[verb]) if verb in _OF_VERB else ()


def schema_of_common(options: type) -> tuple[OptionSchema, ...]:
    """The options of one of the classes here. A field whose name is a word of Python has `_` at its
    end (`while_`)."""
    return tuple(
        replace(option_schema, name=option_schema.name.removesuffix("_"))
        for option_schema in schema_of(options)
    )
