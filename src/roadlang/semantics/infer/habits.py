"""What people write who know Python or Scenic, and what the language has in its place."""

from __future__ import annotations

from collections.abc import Container
from typing import TYPE_CHECKING

from ...diagnostics import Fix, nearest
from ...plugins.common_options import common_options
from ...syntax.contact_words import CONTACT_MEMBERS, CONTACT_VERBS, no_contact_help
from ...syntax.tree import nodes as ast
from ...syntax.words import PASS_VERBS
from ..checker import ResolvedKind
from ..types.expression_types import DeclaredType, KindCallType, SignalType, TypedExpression
from .kinds import loaded

if TYPE_CHECKING:
    from ..checker import Checker
    from ..context import Context

_TTC = "write `time_to_collision(ego, lead) > 2s`"
_HEADWAY = "write `time_headway(ego, lead) > 1s`"
_FUNCTIONS = {
    "Range": "a uniform draw is written `low..high`",
    "VerifaiRange": "a uniform draw is written `low..high`",
    "random": "a uniform draw is written `low..high`",
    "rand": "a uniform draw is written `low..high`",
    "range": "a uniform draw is written `low..high`; `count` makes copies",
    "Uniform": "Scenic's `Uniform(a, b)` is `choice(a, b)`; a uniform draw between two numbers is "
    "`a..b`",
    "Discrete": "write `choice(a, b, weights: [3, 1])`",
    "Options": "write `choice(a, b, weights: [3, 1])`",
    "DiscreteRange": "write `integer(low, high)`",
    "randint": "write `integer(low, high)`",
    "TruncatedNormal": "write `normal(mean, sd, within: [low, high])`",
    "gauss": "write `normal(mean, sd)`",
    "can_see": "formulas do not test what is seen: write a distance, `distance(ego, lead) < 50m`",
    "sees": "formulas do not test what is seen: write a distance, `distance(ego, lead) < 50m`",
    "visible": "formulas do not test what is seen: write a distance, `distance(ego, lead) < 50m`",
    "sqrt": "a square root is written `x ^ 0.5`",
    "pow": "a power is written `x ^ y`",
    "len": "the length of a road is `length(main)`",
    "sin": "the functions of numbers are `abs`, `min` and `max`",
    "cos": "the functions of numbers are `abs`, `min` and `max`",
    "tan": "the functions of numbers are `abs`, `min` and `max`",
    "exp": "the functions of numbers are `abs`, `min` and `max`",
    "log": "the functions of numbers are `abs`, `min` and `max`",
    "right_of": "write `beside(ego, right)`",
    "left_of": "write `beside(ego, left)`",
    "in_front_of": "write `ahead_of(ego, 10m)`",
    "file": 'write the name of the file in quotes: `network town from "town.osm"`',
    "localPath": 'write the name of the file in quotes: `network town from "town.osm"`',
    "ttc": _TTC,
    "thw": _HEADWAY,
    "pet": "write `post_encroachment_time(ego, lead) > 1s`",
    "dist": "write `distance(ego, lead) > 5m`",
    "norm": "write `distance(ego, lead) > 5m`",
}
_RANGES = ("Range", "VerifaiRange", "random", "rand", "range", "Uniform")
_WEIGHTED = ("Discrete", "Options")
_COUNTERS = ("index", "i", "j", "k", "n", "idx")
_NAMES = {
    "pi": "an angle has a unit: `180deg`",
    "None": "leave the option out",
    "end": "the end of a road is `100%`",
}
_POSITION = (
    "write `x` and `y`, or `station` for the arc length along the road; "
    "`distance(ego, lead)` takes agents as they are"
)
_MEMBERS = {
    "position": _POSITION,
    "position.x": "write `x`",
    "position.y": "write `y`",
    "velocity": "write `speed`",
    "v": "write `speed`",
    "s": "write `station`",
    "width": "dimensions are options, not signals",
    "length": "dimensions are options, not signals",
}
_READINGS = "readings of sensors go to controllers; in a formula, measure: `gap(ego, lead) > 2m`"
_MEMBERS |= dict.fromkeys(CONTACT_MEMBERS, no_contact_help())
_MEMBERS |= {"ttc": _TTC, "thw": _HEADWAY, "headway": _HEADWAY}
_MEMBERS |= {"lidar": _READINGS, "radar": _READINGS}
_SENSOR = "a sensor is written in the block of the agent: `sense with KIND { ... }`"
_CROSSWALK = "write `object zebra is crosswalk on ROAD at 150m`"
_SPEED = "it is an option of the controller: `drive with pure_pursuit { speed: 10m/s }`"
_OPTIONS = {
    "speed": _SPEED,
    "velocity": _SPEED,
    "behavior": "write `drive with KIND { ... }`",
    "position": "the position is written before the block: `at 20m`",
    "at": "the position is written before the block: `at 20m`",
    "on": "the road is written before the block: `on main at 20m`",
    "crosswalks": _CROSSWALK,
    "crossings": _CROSSWALK,
    "zebra": _CROSSWALK,
    "lidar": _SENSOR,
    "radar": _SENSOR,
    "sensor": _SENSOR,
    "sensors": _SENSOR,
}
_SETTINGS = {
    ("falsify", "budget"): "evaluations",
    ("falsify", "iterations"): "evaluations",
    ("falsify", "samples"): "evaluations",
    ("falsify", "timeout"): "seconds",
    ("simulate", "time"): "duration",
    ("simulate", "timestep"): "step",
    ("simulate", "dt"): "step",
    ("sample", "budget"): "attempts",
    ("sample", "iterations"): "attempts",
    ("world", "fog"): "visibility",
    ("world", "time"): "time_of_day",
    ("world", "grip"): "friction",
    ("world", "mu"): "friction",
    ("perturb", "period"): "wavelength",
    ("perturb", "frequency"): "wavelength",
    ("perturb", "amp"): "amplitude",
    ("drive", "at"): "station",
    ("drive", "position"): "station",
    ("drive", "time_gap"): "headway",
}
"""Other tools' names of options, by verb."""
_MOMENT = "a condition says when it takes over: `when: time > 5s`"
_DRIVE_OPTIONS = dict.fromkeys(("after", "begin", "delay", "start", "trigger"), _MOMENT)
_ENDS = "`while: time < 20s` limits it; after that the previous controller takes over again"
_DRIVE_OPTIONS |= dict.fromkeys(("duration", "until", "hold", "wait", "end", "dwell"), _ENDS)
_PLACES = ("position", "at", "on")
_NETWORK_WIDTH = (
    "the width of roads from a picture is an option of the extractor: "
    "`extract with auto { width: 7m }`"
)
_LANE_WIDTH = (
    "to set the width of lanes, list them: `right: [drive(3.5m), drive(3.5m)]`; `width` is the "
    "total width of the drivable lanes"
)
_ROUTE = (
    "a `route` sets which way it goes: `route: left` at the first junction, "
    "`route: [(10m, 45m), (85m, 15m)]` through points"
)
_ROUTES = frozenset(("turn", "turns", "then", "direction", "path", "goal", "destination", "to"))
_ROAD_LENGTH = (
    "the length of a road follows from how it is drawn: "
    "`draw with segments { pieces: [straight(100m)] }`"
)
_LANE_LISTS = "lanes are listed from the middle of the road: `right: [drive, {}]`"
_SELECT = "to use one of its roads, declare it: `road NAME from NETWORK { select: longest }`"
_SIDES = {"right": "-1", "left": "1"}


def function_help(call: ast.CallExpression, name: str) -> tuple[str, tuple[Fix, ...]] | None:
    """Help and fix for a function of another language; None if it is not known."""
    if name in (*CONTACT_VERBS, "collision"):
        agents = [a.value.text for a in call.arguments if isinstance(a.value, ast.Name)]
        return no_contact_help(*(agents if len(agents) == 2 else ())), ()
    if name not in _FUNCTIONS:
        return None
    fixes: tuple[Fix, ...] = ()
    plain = [argument for argument in call.arguments if argument.key is None]
    numbers = all(isinstance(argument.value, ast.NumberLiteral) for argument in plain)
    if name in _RANGES and len(plain) == len(call.arguments) == 2 and numbers:
        low, high = (argument.value.span.text for argument in plain)
        return f"write `{low}..{high}`", (Fix(call.span, f"{low}..{high}"),)
    if name in _RANGES and len(call.arguments) == 1:
        (argument,) = call.arguments
        if isinstance(argument.value, ast.Draw):
            low_to_high = argument.value.span.text
            return f"write `{low_to_high}`", (Fix(call.span, low_to_high),)
    weights = [a.value for a in call.arguments if a.key is not None and a.key.text == "weights"]
    if name in _WEIGHTED and plain and weights and isinstance(weights[0], ast.ListValue):
        values = ", ".join(argument.value.span.text for argument in plain)
        counts = ", ".join(item.span.text for item in weights[0].items)
        meant = f"choice({values}, weights: [{counts}])"
        return f"write `{meant}`", (Fix(call.span, meant),)
    if name in ("DiscreteRange", "randint"):
        fixes = (Fix(call.function.span, "integer"),)
    return _FUNCTIONS[name], fixes


def is_side_as_lane(name: ast.Name, context: Context) -> bool:
    """Whether `left` or `right` stands where the id of a lane does."""
    return context.place.rpartition("/")[2] == "lane" and name.text in _SIDES


def name_help(
    checker: Checker, name: ast.Name, context: Context
) -> tuple[str, tuple[Fix, ...]] | None:
    """Help and fix for a name that is not declared, by its place in the file; None if there is no
    help."""
    if is_side_as_lane(name, context):
        lane = _SIDES[name.text]
        help = (
            "lanes have ids as in OpenDRIVE: -1 is the first to the right, 1 the first to the left"
        )
        return help, (Fix(name.span, lane),)
    if name.text in _COUNTERS and context.per == "copy":
        return ("copies have no index: `at 0%..100%` draws a position for each of them"), ()
    if name.text in _NAMES:
        return _NAMES[name.text], ()
    if context.takes_text and name.text not in checker.program.declarations:
        quoted = f'"{name.text}"'
        return f"a string stands in quotes: `{quoted}`", (Fix(name.span, quoted),)
    if context.example and not nearest(name.text, checker.program.declarations):
        return f"write a value such as `{context.example}`", ()
    return None


def member_help(name: str) -> tuple[str, ...]:
    """Help for a member that agents do not have."""
    return (_MEMBERS[name],) if name in _MEMBERS else ()


def monitor_help(name: str) -> str:
    """Help where a monitor stands for a formula."""
    return f"`{name}` is a monitor: write `require NAME with {name} {{ ... }}`"


def number_of_entity_help(typed: TypedExpression) -> tuple[str, ...]:
    """Help where an agent stands for its position: `at ego + 10m`."""
    if isinstance(typed.type, DeclaredType) and typed.type.role in ("agent", "object"):
        return (f"its position along its road is `{typed.span.text}.start`",)
    return ()


def position_help(typed: TypedExpression) -> tuple[str, ...]:
    """Help where a signal of an agent stands for the position of another."""
    if isinstance(typed.type, SignalType):
        return ("`ego.start` is where an agent starts on its road: write `at ego.start + 20m`",)
    return ()


def chosen_road_help(typed: TypedExpression) -> tuple[str, ...]:
    """Help for `on road(3)`: a road of a network is declared before something is on it."""
    if isinstance(typed.type, KindCallType) and typed.type.verb == "select":
        return (f"declare it: `road NAME from NETWORK {{ select: {typed.span.text} }}`",)
    return ()


def option_help(checker: Checker, name: str, owner: str, known: Container[str]) -> tuple[str, ...]:
    """Help for an option that a statement or kind, the `owner`, does not have; it has those that
    are `known`."""
    if (owner, name) == ("`network`", "width"):
        return (_NETWORK_WIDTH,)
    if (owner, name) == ("`network`", "select"):
        return (_SELECT,)
    if name in (*PASS_VERBS, "sample", "simulate", "falsify"):
        return (f"write `{name} with KIND {{ ... }}`",)
    verb = owner.strip("`").split(" ")[0]
    if (verb, name) == ("road", "length"):
        return (_ROAD_LENGTH,)
    if name == "lane_width" and verb in ("road", "network"):
        return (_LANE_WIDTH,)
    if verb == "drive" and name in _DRIVE_OPTIONS and "when" in known:
        return (_DRIVE_OPTIONS[name],)
    if verb == "drive" and name in {option.name for option in common_options("agent")}:
        return (f"`{name}` is an option of the agent: write it beside `drive with`",)
    if verb == "agent" and name in {option.name for option in common_options("drive")}:
        return (f"`{name}` is an option of a controller: write it in the block of `drive with`",)
    if _SETTINGS.get((verb, name)) in known:
        return (f"it is called `{_SETTINGS[verb, name]}`",)
    if verb == "read" and name in ("file", "path", "map"):
        return (_FUNCTIONS["file"],)
    positions = tuple(checker.registry.of("position")) if verb in ("agent", "object") else ()
    if any(entry.name == name for entry in positions):
        return (f"the position is written before the block: `at {name}(...)`",)
    for kind in map(loaded, positions):
        if isinstance(kind, ResolvedKind) and any(option.name == name for option in kind.schema):
            where = f"{kind.entry.name}(..., {name}: VALUE)"
            return (f"`{name}` is an option of the position: write it in `at {where}`",)
    if verb in ("road", "network") and checker.registry.has("object", name):
        return (f"`{name}` is a kind of object: write `object NAME is {name} on ROAD at 20m`",)
    lane = name.removesuffix("_lane")
    if verb == "road" and checker.registry.has("lane", lane) and f"{name}s" not in known:
        return (_LANE_LISTS.format(lane),)
    if verb == "agent" and name in _ROUTES:
        return (_ROUTE,)
    if name in _PLACES and verb not in ("agent", "object"):
        return ()
    return (_OPTIONS[name],) if name in _OPTIONS else ()
