"""Forms of other languages inside statements: conditionals, functions, Scenic's specifiers."""

from __future__ import annotations

from ...diagnostics import Code, Fix, diagnose
from ..words import RESERVED_KINDS
from .error_position import Edit, ErrorPosition, Mistake
from .statement_habits import OPENSCENARIO
from .token_names import finding
from .unexpected import unexpected

CONDITIONAL = (
    "there are no conditional expressions: `choice(a, b)` draws one of several values, and "
    "`p implies q` is a conditional formula"
)


def conditional(place: ErrorPosition) -> Mistake | None:
    """`if p then a else b` and `a if p else b`."""
    words = {place.word(-1), place.word()}
    if not words & {"if", "then", "else", "elif"} or place.kind(-1) in ("COLON", "COMMA"):
        return None
    return unexpected(place, CONDITIONAL, hopeless=True)


def membership(place: ErrorPosition) -> Mistake | None:
    """`ego.acceleration in [-3m/s^2, 3m/s^2]`, and `ego at 100m` in a formula."""
    if place.first_kind not in ("REQUIRE", "EXPECT", "LET") or place.kind(-1) != "NAME":
        return None
    if place.word() == "in":
        return unexpected(place, "a value within limits is written `low <= x <= high`")
    if place.word() == "at":
        return unexpected(place, f"a place is a comparison: `{place.word(-1)}.station > 100m`")
    return None


def function_definition(place: ErrorPosition) -> Mistake | None:
    """`let f(x) = ...`: nothing in the statement can be checked."""
    if place.first_kind not in ("LET", "PARAM") or place.index != 2 or place.kind() != "LPAR":
        return None
    help = f"there are no functions with arguments: write `{place.word(-2)} {place.word(-1)} = ...`"
    return unexpected(place, help, hopeless=True)


def position_range(place: ErrorPosition) -> Mistake | None:
    """`at [5m, 20m]`: a list where a random position is meant."""
    if place.kind() != "LSQB" or place.kind(-1) != "AT":
        return None
    kinds = [place.kind(offset) for offset in range(1, 5)]
    if kinds != ["NUMBER", "COMMA", "NUMBER", "RSQB"]:
        return None
    span = place.span(0, 4)
    meant = f"{place.word(1)}..{place.word(3)}"
    found = diagnose(
        Code.LIST_AS_OPERAND,
        span,
        help=f"to draw a position between the two, write `{meant}`",
        fixes=[Fix(span, meant)],
    )
    comma = place.token(2)
    tokens = (place.token(1), ("RANGE", "..", comma[2], comma[3]), place.token(3))
    return Mistake(found, Edit(place.index, place.index + 5, tokens))


def range_word(place: ErrorPosition) -> Mistake | None:
    """`0.4 to 0.9`: a range in words."""
    if place.kind() != "NUMBER" or place.word(-1) != "to" or place.kind(-2) != "NUMBER":
        return None
    span = place.span(-2, 0)
    meant = f"{place.word(-2)}..{place.word()}"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(-1, -1),
        expected="`..`",
        found="`to`",
        help=f"write `{meant}`",
        fixes=[Fix(span, meant)],
    )
    to = place.token(-1)
    return Mistake(found, Edit(place.index - 1, place.index, (("RANGE", "..", to[2], to[3]),)))


def emit_target(place: ErrorPosition) -> Mistake | None:
    """`emit json to "x"` and `emit "json"`."""
    if place.first_kind != "EMIT":
        return None
    if place.index == 1 and place.kind() == "STRING":
        span, meant = place.span(), place.word().strip('"')
        if not meant.isidentifier():
            return None
        found = diagnose(
            Code.UNEXPECTED_TOKEN,
            span,
            expected="a name",
            found=finding(place),
            help=f"write `emit {meant}`",
            fixes=[Fix(span, meant)],
        )
        return Mistake(found, Edit(1, 2, (("NAME", meant, span.start, span.end),)))
    if place.kind() == "COMMA":
        return unexpected(place, "write an `emit` of its own for each output", hopeless=True)
    if place.kind() not in ("NAME", "STRING") or place.kind(-1) != "NAME":
        return None
    help = "the command line names the output folder: `roadlang compile scene.rl -o DIR`"
    return unexpected(place, help, hopeless=True)


def specifier(place: ErrorPosition) -> Mistake | None:
    """`agent ego is car on main at 5m with speed 10m/s`, `..., facing 30deg`: as in Scenic."""
    if place.first_kind not in ("AGENT", "OBJECT") or place.kind() not in ("WITH", "COMMA"):
        return None
    before = [token[0] for token in place.tokens[: place.index]]
    if "AT" not in before or "LBRACE" in before:
        return None
    around = [place.kind(offset) for offset in (-2, -1, 0, 1)]
    if around == ["AT", "NUMBER", "COMMA", "NUMBER"]:
        return _point_without_parentheses(place)
    help = "options are written in braces: `at 5m { heading: 30deg, drive with pure_pursuit }`"
    return unexpected(place, help, hopeless=True)


def _point_without_parentheses(place: ErrorPosition) -> Mistake:
    """`at 40m, 32m`."""
    span = place.span(-1, 1)
    meant = f"({place.word(-1)}, {place.word(1)})"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected="a position",
        found=f"`{span.text}`",
        help=f"write `{meant}`",
        fixes=[Fix(span, meant)],
    )
    ends = ("LPAR", "(", span.start, span.start), ("RPAR", ")", span.end, span.end)
    inside = (place.token(-1), place.token(), place.token(1))
    return Mistake(found, Edit(place.index - 1, place.index + 2, (ends[0], *inside, ends[1])))


_SIDES = {
    ("ahead", "of"): "ahead_of",
    ("ahead_of",): "ahead_of",
    ("in", "front", "of"): "ahead_of",
    ("behind",): "behind",
    ("beside",): "beside",
    ("next", "to"): "beside",
    ("near",): "beside",
}
"""Words for where one thing is from another, and the function that says it."""


def relative_position(place: ErrorPosition) -> Mistake | None:
    """`at 20m ahead of ego`, `is car behind ego by 5m`, `at behind ego`: Scenic's specifiers."""
    for first in (0, -1):
        for words, function in _SIDES.items():
            other = first + len(words)
            said = tuple(place.word(offset) for offset in range(first, other))
            if said == words and place.kind(other) == "NAME":
                return _relative(place, first, other, function)
    return None


def _relative(place: ErrorPosition, first: int, other: int, function: str) -> Mistake | None:
    """The words begin at offset `first`; the other thing is named at `other`."""
    before, is_placed = place.kind(first - 1), place.first_kind in ("AGENT", "OBJECT")
    if before == "NUMBER":
        gap = place.word(first - 1)
    elif is_placed and before == ("NAME" if first == 0 else "AT"):
        gap = place.word(other + 2) if place.word(other + 1) == "by" else "10m"
    else:
        return None
    meant = f"at {function}({place.word(other)}, {'right' if function == 'beside' else gap})"
    return unexpected(place, f"a position relative to another is written `{meant}`", hopeless=True)


def typed_value(place: ErrorPosition) -> Mistake | None:
    """`param float reach = 8m`: a type before the name."""
    named = place.kind() == "NAME" and place.kind(1) == "EQUAL" and place.index == 2
    if place.first_kind not in ("PARAM", "LET") or not named:
        return None
    statement = f"{place.word(-2)} {place.word()} = ..."
    found = unexpected(place, f"values are declared without a type: write `{statement}`").diagnostic
    return Mistake(found, Edit(1, 2))


def source_in_parentheses(place: ErrorPosition) -> Mistake | None:
    """`road bent(main) { ... }`: what a road is made from, as an argument."""
    if place.kind() != "LPAR" or place.index != 2 or not place.expects("FROM"):
        return None
    if (place.kind(1), place.kind(2)) != ("NAME", "RPAR"):
        return None
    span, meant = place.span(0, 2), f" from {place.word(1)}"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected="`from`",
        found=finding(place),
        help=f"write `{place.word(-2)} {place.word(-1)}{meant}`",
        fixes=[Fix(span, meant)],
    )
    word = ("FROM", "from", span.start, span.start)
    return Mistake(found, Edit(2, 5, (word, place.token(1))))


def options_in_parentheses(place: ErrorPosition) -> Mistake | None:
    """`emit svg(size: 800px)`, `perturb with sine(amplitude: 2m)`, `drive with choice(a, b)`."""
    if place.kind() != "LPAR" or not place.expects("LBRACE") or place.kind(-1) != "NAME":
        return None
    kind = place.word(-1)
    has_names = (place.kind(1), place.kind(2)) == ("NAME", "COMMA")
    if has_names and place.kind(-2) == "WITH":
        return unexpected(
            place,
            "the kind after `with` is not drawn at random: write one, and draw its options, as in "
            "`speed: choice(8m/s, 12m/s)`",
        )
    return unexpected(place, f"options are written in braces: `{kind} {{ option: value }}`")


def options_in_list(place: ErrorPosition) -> Mistake | None:
    """`left: [drive { width: 3m }]`: a call with its options in braces."""
    if place.kind() != "LBRACE" or place.kind(-1) != "NAME" or place.kind(1) != "NAME":
        return None
    if place.in_block or place.kind(-2) not in ("LSQB", "COMMA") or place.kind(2) != "COLON":
        return None
    meant = f"{place.word(-1)}({place.word(1)}: {place.word(3)})"
    return unexpected(place, f"in a list, options are written in parentheses: `{meant}`")


def method_call(place: ErrorPosition) -> Mistake | None:
    """`x.abs()`: a function as a member."""
    name = place.word(-1)
    if place.kind() != "LPAR" or place.kind(-2) != "DOT" or name not in ("abs", "min", "max"):
        return None
    return unexpected(place, f"a function is written before its argument: `{name}(x)`")


def title_of_scenario(place: ErrorPosition) -> Mistake | None:
    """`scenario "A bend"` and `scenario hairpin A bend`; `scenario sut.cut_in:` of OpenSCENARIO."""
    if place.first_kind != "SCENARIO" or place.index not in (1, 2):
        return None
    if place.index == 1 and place.kind() in RESERVED_KINDS:
        return None  # a name that is taken
    if place.index == 2 and place.word() in (".", ":", "(", "inherits"):
        return unexpected(place, OPENSCENARIO, hopeless=True)
    return unexpected(place, 'a scenario has a name and a title: `scenario hairpin "A bend"`')


def absolute_value(place: ErrorPosition) -> Mistake | None:
    """`|x|`, read as `or`."""
    if place.word() != "|" or not place.wants_value:
        return None
    return unexpected(place, "the absolute value of x is written `abs(x)`")
