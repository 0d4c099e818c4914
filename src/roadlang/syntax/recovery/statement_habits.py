"""Help for a line that starts as a statement of Python, Scenic or OpenSCENARIO."""

from __future__ import annotations

from collections.abc import Sequence

from ...diagnostics import Code, Fix, Source, diagnose
from ..parsing.grammar import END
from ..parsing.tokens import Token
from .error_position import Edit, ErrorPosition, Mistake
from .token_names import finding

_LOOP = "there are no loops: `count: 5` in the block of an agent or object makes five copies"
_CONDITION = (
    "there are no conditional statements: `choice(a, b)` draws one of several values, and "
    "`p implies q` is a conditional formula"
)
_INCLUDE = 'write `include "street.rl"` to add the declarations of another scene file'
_FUNCTION = (
    "there are no functions: `let NAME = value` names a value or formula, and an included file "
    "can be given params"
)
_CONTROLLERS = (
    "what an agent does is a list of controllers in its block: `drive with lane_follow`, then "
    "`drive with brake { when: time > 4s }`"
)
_DRIVE_ENDS = "the length of a drive is set by `simulate { duration: 20s }`"
_JUNCTION = "junctions are made where roads of a network meet: `network NAME from ...`"
_VALUE = "write `param NAME = value`, which can be set from outside, or `let NAME = value`"

_JSON = (
    "a scene file has statements such as `road main { ... }`; `roadlang run scene.json` drives a "
    "scene that roadlang wrote as JSON"
)
OPENSCENARIO = (
    "roadlang does not read OpenSCENARIO DSL: an actor is an `agent NAME is car on ROAD at 20m` "
    "with `drive with KIND` in its block, and `keep` is `require NAME: formula`; "
    "`roadlang init scene.rl` writes a file to start with"
)
_AGENT = "agents and objects are written `agent NAME is KIND on ROAD at POSITION { ... }`"

_HELP = {
    "for": _LOOP, "while": _LOOP, "repeat": _LOOP,
    "if": _CONDITION, "elif": _CONDITION, "else": _CONDITION, "match": _CONDITION,
    "import": _INCLUDE, "from": _INCLUDE, "use": _INCLUDE, "using": _INCLUDE, "model": _INCLUDE,
    "def": _FUNCTION, "fun": _FUNCTION, "function": _FUNCTION, "class": _FUNCTION,
    "behavior": "write `drive with KIND { ... }` in the block of the agent",
    "monitor": "write `expect NAME: formula`, or `expect NAME with KIND { ... }`",
    "do": _CONTROLLERS, "take": _CONTROLLERS, "wait": _CONTROLLERS, "try": _CONTROLLERS,
    "interrupt": _CONTROLLERS, "actor": _AGENT, "vehicle": _AGENT,
    "terminate": _DRIVE_ENDS, "record": "`roadlang run` records every drive: traces, verdicts",
    **dict.fromkeys(("action", "modifier", "struct", "enum", "type", "unit", "extend", "global",
                     "keep", "event", "cover"), OPENSCENARIO),
    "mutate": "write a range where a value is to vary: `at 20m..30m`",
    "var": _VALUE, "const": _VALUE, "val": _VALUE, "set": _VALUE,
    "assert": "write `require NAME: formula`, or `expect NAME: formula`",
    "seed": "the seed is an option of the command: `roadlang compile scene.rl --seed 7`",
    "map": 'write `network NAME from "town.xodr"`',
    "intersection": _JUNCTION, "junction": _JUNCTION, "crossing": _JUNCTION,
    "title": 'write `scenario NAME "title"`',
    "print": "there is nothing to print: `emit json` writes every value of a scene",
    "adjust": "write it in a block: `image dark from photo { adjust with brightness { ... } }`",
    "extract": "write it in a block: `network town from photo { extract with auto }`",
    "read": "write it in a block: `road track from \"track.csv\" { read with csv }`",
    "draw": "write it in a block: `road main { draw with waypoints { ... } }`",
    "perturb": "write it in a block: `road bent from main { perturb with sine { ... } }`",
    "drive": "write it in a block: `agent ego is car on main at 5m { drive with pure_pursuit }`",
}  # fmt: skip


def statement_help(tokens: Sequence[Token]) -> tuple[str, ...]:
    """A line of help for a piece whose first word is no statement word; empty if none is known."""
    word, second = tokens[0][1], tokens[1][0] if len(tokens) > 1 else END
    if word in _HELP:
        return (_HELP[word],)
    if second == "EQUAL":
        agent = len(tokens) > 2 and tokens[2][1] in ("new", "Car", "Object", "Pedestrian", "Truck")
        return (_AGENT,) if agent else (_VALUE.replace("NAME", word),)
    words = {text for kind, text, *_ in tokens[1:6]}
    if second in ("IS", "NAME", "AT", "ON") and words & {"is", "on", "at"}:
        return (_AGENT,)
    return ()


def foreign_pass_help(word: str) -> str:
    """Help for a word of another language in front of a kind in a block; empty if none is known."""
    return _HELP[word] if word in ("behavior", "monitor", "model") else ""


def override_with_role(place: ErrorPosition) -> Mistake | None:
    """`override agent ego { ... }`: what it is was said where it is declared."""
    if place.first_kind != "OVERRIDE" or place.index != 2 or place.kind() != "NAME":
        return None
    if place.word(-1) not in ("image", "network", "road", "agent", "object", "param"):
        return None
    span = place.span(-1)
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected="a declared name",
        found=f"`{span.text}`",
        help=f"write `override {place.word()}`",
        fixes=[Fix(place.source.span(span.start, place.token()[2]), "")],
    )
    return Mistake(found, Edit(1, 2))


def bare_number(place: ErrorPosition) -> Mistake | None:
    """`simulate 30s`, `sample 10`: what the number is has to be said."""
    if place.index != 1 or place.kind() != "NUMBER" or place.first_kind not in _NUMBERS:
        return None
    help_ = _NUMBERS[place.first_kind].format(place.word())
    found = finding(place)
    return Mistake(
        diagnose(
            Code.UNEXPECTED_TOKEN, place.span(), expected="`with` or `{`", found=found, help=help_
        ),
        hopeless=True,
    )


_NUMBERS = {
    "SIMULATE": "write `simulate {{ duration: {} }}`",
    "FALSIFY": "write `falsify {{ evaluations: {} }}`",
    "SAMPLE": "the number of scenes is an option of the command: `roadlang compile scene.rl -n {}`",
}


def json_document(place: ErrorPosition) -> Mistake | None:
    """A scene that `emit json` wrote, in place of the scene file."""
    if place.index or place.word() not in ("{", "[") or place.span().start:
        return None
    return Mistake(
        diagnose(
            Code.UNEXPECTED_TOKEN,
            place.span(),
            expected="a statement",
            found=f"`{place.word()}`",
            help=_JSON,
        )
    )


def as_include(source: Source, tokens: Sequence[Token]) -> tuple[Fix, list[Token]] | None:
    """`import "street.rl"`: the fix, and the tokens of the `include` that is meant."""
    _, text, start, end = tokens[0]
    if text not in ("import", "use", "using") or len(tokens) < 2 or tokens[1][0] != "STRING":
        return None
    include = ("INCLUDE", "include", start, end)
    return Fix(source.span(start, end), "include"), [include, *tokens[1:]]
