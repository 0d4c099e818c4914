"""Mistakes that are known: what stands there, what was meant, and how reading goes on.

Each function looks at the place where the parser is stuck and answers None when it knows nothing
about it. The first answer counts (`explain`).
"""

from __future__ import annotations

import re
from collections.abc import Callable

from ..diagnostics import Fix, diagnose
from .naming import expectation, finding
from .place import Edit, Mistake, Place
from .tables import END
from .words import (
    BINDING_KINDS,
    CLOSERS,
    CONNECTIVES,
    OPENERS,
    RESERVED,
    RESERVED_KINDS,
    STATEMENT_KINDS,
    TEMPORAL_KINDS,
    UNITS,
    misspelt,
)

_UNIT = re.compile(rf"[ \t]+((?:{'|'.join(UNITS)})(?:\^-?\d+)?(?:/[A-Za-z]+(?:\^-?\d+)?)*)\b")
_LETTERS = {"G": "always", "F": "eventually", "H": "historically", "O": "once"}


def explain(place: Place) -> Mistake:
    """The mistake at a place where the parser is stuck."""
    for known in _KNOWN:
        mistake = known(place)
        if mistake is not None:
            return mistake
    return unexpected(place)


def unexpected(place: Place) -> Mistake:
    """Anything else is here than may be; a sign that is plainly missing is put in."""
    edit, expected = None, place.expected()
    for kind, sign in _MISSING:
        if kind in expected and place.goes_on(kind) and _closes_later(place, kind):
            edit = Edit(place.index, place.index, (_token(place, kind, sign),))
            break
    wanted = f"`{edit.tokens[0][1]}`" if edit else expectation(place)
    found = diagnose("RL001", place.span(), expected=wanted, found=finding(place))
    return Mistake(found, edit)


_MISSING = (
    ("COLON", ":"),
    ("EQUAL", "="),
    ("WITH", "with"),
    ("IS", "is"),
    ("AT", "at"),
    ("FROM", "from"),
    ("LBRACE", "{"),
    ("LPAR", "("),
    ("LSQB", "["),
)


def _closes_later(place: Place, opener: str) -> bool:
    """An opening bracket is put in only where a closing one waits for it."""
    if opener not in OPENERS:
        return True
    closer = place.unmatched_closer()
    return closer is not None and CLOSERS[closer] == opener


def _token(place: Place, kind: str, text: str) -> tuple[str, str, int, int]:
    start = place.token()[2]
    return (kind, text, start, start)


# --- numbers -------------------------------------------------------------------------------------


def loose_unit(place: Place) -> Mistake | None:
    """`5 m`: the unit is read as a name, and the parser stumbles over it or behind it."""
    for offset in (0, -1):
        number = place.token(offset - 1)
        if number[0] != "NUMBER" or place.kind(offset) not in ("NAME",):
            continue
        match = _UNIT.match(place.source.text, number[3])
        if match is None or not number[1][-1].isdigit():
            continue
        last = place.index + offset
        while place.tokens[last][3] < match.end():
            last += 1
        span = place.source.span(number[2], match.end())
        fixed = number[1] + match[1]
        found = diagnose(
            "RL009", span, number=number[1], unit=match[1], help=f"write `{fixed}`",
            fixes=[Fix(span, fixed)],
        )  # fmt: skip
        meant = ("NUMBER", fixed, span.start, span.end)
        return Mistake(found, Edit(place.index + offset - 1, last + 1, (meant,)))
    return None


def decimal_point(place: Place) -> Mistake | None:
    """`.5`, `5.` and `5.m`: a digit is needed on both sides of the point."""
    if place.kind() != "DOT":
        return None
    first, last, fixed = 0, 0, ""
    if place.wants_value and place.kind(1) == "NUMBER" and place.glued(1):
        last, fixed = 1, "0." + place.word(1)
    elif place.kind(-1) == "NUMBER" and place.glued(0) and place.word(-1).isdigit():
        glued_name = place.kind(1) == "NAME" and place.glued(1)
        first, last = -1, int(glued_name)
        fixed = f"{place.word(-1)}.0{place.word(1) if glued_name else ''}"
    if not fixed:
        return None
    span = place.span(first, last)
    help = f"write `{fixed}`"
    found = diagnose("RL008", span, number=span.text, help=help, fixes=[Fix(span, fixed)])
    meant = ("NUMBER", fixed, span.start, span.end)
    return Mistake(found, Edit(place.index + first, place.index + last + 1, (meant,)))


def decimal_comma(place: Place) -> Mistake | None:
    """`1,5m`: a comma where the decimal point belongs."""
    if place.kind() != "NUMBER" or place.kind(-1) != "COMMA" or place.kind(-2) != "NUMBER":
        return None
    if not (place.glued(0) and place.glued(-1) and place.word(-2).isdigit()):
        return None
    span = place.span(-2, 0)
    fixed = f"{place.word(-2)}.{place.word()}"
    help = f"write `{fixed}`"
    found = diagnose("RL008", span, number=span.text, help=help, fixes=[Fix(span, fixed)])
    meant = ("NUMBER", fixed, span.start, span.end)
    return Mistake(found, Edit(place.index - 2, place.index + 1, (meant,)))


# --- signs ---------------------------------------------------------------------------------------


def wrong_sign(place: Place) -> Mistake | None:
    """`=` for `:`, `:` for `=`, `=` for `==`."""
    kind = place.kind()
    if kind not in ("EQUAL", "COLON"):
        return None
    for meant, sign in (("COLON", ":"), ("EQUAL", "="), ("COMPARISON", "==")):
        if meant != kind and place.expects(meant) and (kind == "EQUAL" or meant == "EQUAL"):
            span = place.span()
            last = 1
            if place.kind(1) == "EQUAL" and place.glued(1):
                last = 2
            found = diagnose(
                "RL010", span, right=sign, wrong=place.word(), help=f"write `{sign}`",
                fixes=[Fix(span, sign)],
            )  # fmt: skip
            token = (meant, sign, span.start, span.end)
            return Mistake(found, Edit(place.index, place.index + last, (token,)))
    return None


def stray_closer(place: Place) -> Mistake | None:
    """A closing bracket that nothing opens."""
    if place.kind() not in CLOSERS:
        return None
    depth = 0
    for token in place.tokens[: place.index]:
        depth += (token[0] == CLOSERS[place.kind()]) - (token[0] == place.kind())
    if depth > 0:
        return None
    help = "leave it out, or open it where it belongs"
    found = diagnose("RL004", place.span(), what=place.word(), help=help)
    return Mistake(found, Edit(place.index, place.index + 1))


def one_too_many(place: Place) -> Mistake | None:
    """A comma or a `with` that can be left out."""
    if place.kind() not in ("COMMA", "WITH") or not place.goes_on(skip=1):
        return None
    found = diagnose("RL001", place.span(), expected=expectation(place), found=finding(place))
    return Mistake(found, Edit(place.index, place.index + 1))


def power_of_python(place: Place) -> Mistake | None:
    if place.kind() != "TIMES" or place.kind(-1) != "TIMES" or not place.glued(0):
        return None
    span = place.span(-1, 0)
    found = diagnose(
        "RL006", span, what="**", help="a power is written with `^`", fixes=[Fix(span, "^")]
    )
    meant = ("POWER", "^", span.start, span.end)
    return Mistake(found, Edit(place.index - 1, place.index + 1, (meant,)))


def turned_comparison(place: Place) -> Mistake | None:
    """`=<` for `<=`."""
    if place.kind() != "EQUAL" or place.word(1) != "<" or not place.glued(1):
        return None
    span = place.span(0, 1)
    found = diagnose("RL006", span, what="=<", help="write `<=`", fixes=[Fix(span, "<=")])
    meant = ("COMPARISON", "<=", span.start, span.end)
    return Mistake(found, Edit(place.index, place.index + 2, (meant,)))


# --- words ---------------------------------------------------------------------------------------


def next_item(place: Place) -> Mistake | None:
    """A value is missing, and the next line's `key:` or `verb with` was read as the value."""
    if place.kind() not in ("COLON", "WITH") or not place.starts_line(-1):
        return None
    before = place.back(-1)
    if before is None or not before.wants_value:
        return None
    end = before.token(-1)[3]
    span = place.source.span(end, end)
    found = diagnose(
        "RL001", span, expected=expectation(before), found=f"the next line, `{place.word(-1)}`"
    )
    return Mistake(found, culprit=place.index - 2)


def next_statement(place: Place) -> Mistake | None:
    """A value is missing, and the next line's statement word was read as the value."""
    if place.kind(-1) not in STATEMENT_KINDS or not place.starts_line(-1):
        return None
    before = place.back(-1)
    if before is None or not before.wants_value:
        return None
    end = before.token(-1)[3]
    span = place.source.span(end, end)
    found = diagnose(
        "RL001", span, expected=expectation(before), found=f"the next line, `{place.word(-1)}`"
    )
    return Mistake(found, culprit=place.index - 2)


def misspelt_word(place: Place) -> Mistake | None:
    """A word of the language with a slip in it, here or just before."""
    for offset in (0, -1):
        at = place if offset == 0 else place.back(-1)
        if at is None or at.kind() != "NAME":
            continue
        words = [word for word in (*CONNECTIVES, *RESERVED) if at.expects(word.upper())]
        meant = misspelt(at.word(), words)
        if meant is None or not at.goes_on(meant.upper(), skip=1, over=1):
            continue
        span = at.span()
        help = f"did you mean `{meant}`?"
        found = diagnose("RL021", span, word=at.word(), help=help, fixes=[Fix(span, meant)])
        token = (meant.upper(), meant, span.start, span.end)
        return Mistake(found, Edit(at.index, at.index + 1, (token,)))
    return None


def reserved_name(place: Place) -> Mistake | None:
    """A reserved word where a name is declared or a key stands."""
    if place.kind() not in RESERVED_KINDS or not place.expects("NAME") or place.wants_value:
        return None
    if place.first_kind in ("REQUIRE", "EXPECT") and place.kind(1) not in ("COLON", "WITH"):
        return None
    if not place.goes_on("NAME", skip=1, over=1):
        return None
    help = "choose another name"
    found = diagnose("RL011", place.span(), word=place.word(), help=help)
    token = ("NAME", *place.token()[1:])
    return Mistake(found, Edit(place.index, place.index + 1, (token,)))


def missing_name(place: Place) -> Mistake | None:
    """`require always (p)`: the name and its colon are missing."""
    if place.first_kind not in ("REQUIRE", "EXPECT") or place.index not in (1, 2):
        return None
    if place.kind() in ("EQUAL", "WITH", "NAME", END):
        return None
    if place.index == 2 and (place.kind() in ("COLON", "STRING", "NUMBER") or _word_then(place)):
        return None
    statement = place.tokens[0]
    named = place.index == 1 and place.kind() == "COLON"
    start = place.tokens[1][2]
    span = place.source.span(statement[2], statement[3])
    colon = () if named else (("COLON", ":", start, start),)
    name = ("NAME", "unnamed", start, start)
    example = f"{statement[1]} NAME:"
    found = diagnose("RL023", span, word=statement[1], help=f"write `{example} ...`")
    return Mistake(found, Edit(1, 1, (name, *colon)))


def _word_then(place: Place) -> bool:
    """`require phi1 always ...`: there is a name, the colon is missing."""
    return place.kind() in RESERVED_KINDS and place.kind() not in ("AND", "OR", "IMPLIES", "IFF")


def bare_letter(place: Place) -> Mistake | None:
    """`G e1 < 10m`: the letters are temporal words only before brackets."""
    letter = place.word(-1)
    if letter not in _LETTERS or place.kind(-1) != "NAME":
        return None
    before = place.back(-1)
    if before is None or not before.expects("ALWAYS") or not before.goes_on("ALWAYS", skip=1):
        return None
    span = before.span()
    word = _LETTERS[letter]
    found = diagnose(
        "RL027", span, letter=letter, word=word, help=f"write `{word}`", fixes=[Fix(span, word)]
    )
    token = (word.upper(), word, span.start, span.end)
    return Mistake(found, Edit(before.index, before.index + 1, (token,)))


def subscript(place: Place) -> Mistake | None:
    """`G_{[0, 10]}` or `G_[0, 10]`: LaTeX without a backslash."""
    letter = place.word(-1).rstrip("_")
    meant = {**_LETTERS, "U": "until", "S": "since"}.get(letter)
    if meant is None or not place.word(-1).endswith("_") or place.kind() not in ("LBRACE", "LSQB"):
        return None
    return Mistake(diagnose("RL019", place.span(-1, 0), help=f"write `{meant}[a, b]`"))


def bare_file_name(place: Place) -> Mistake | None:
    """`include street.rl`: a file name without quotes."""
    if place.kind() != "NAME" or place.expected() != {"STRING"}:
        return None
    last = 0
    while place.kind(last + 1) in ("DOT", "NAME", "DIVIDE") and place.glued(last + 1):
        last += 1
    span = place.span(0, last)
    meant = f'"{span.text}"'
    found = diagnose(
        "RL001", span, expected="a string in double quotes", found=f"`{span.text}`",
        help=f"write `{meant}`", fixes=[Fix(span, meant)],
    )  # fmt: skip
    token = ("STRING", meant, span.start, span.end)
    return Mistake(found, Edit(place.index, place.index + last + 1, (token,)))


# --- forms ---------------------------------------------------------------------------------------


def interval_form(place: Place) -> Mistake | None:
    """`always[0s..5s]`, `always[5s]`, `always(0s, 5s) (p)`."""
    if place.kind() == "LPAR" and place.kind(-1) == "RPAR":
        return _round_interval(place)
    if place.kind() != "RSQB" or not place.expects("COMMA") or place.expects("RSQB"):
        return None
    opener = _opener(place, place.index, "LSQB", "RSQB")
    if opener is None or place.tokens[opener - 1][0] not in TEMPORAL_KINDS | BINDING_KINDS:
        return None
    inside = range(opener + 1, place.index)
    dots = [index for index in inside if place.tokens[index][0] == "RANGE"]
    span = place.source.span(place.tokens[opener][2], place.token()[3])
    if dots:
        fixed = span.text.replace("..", ", ", 1)
        found = diagnose("RL026", span, help=f"write `{fixed}`", fixes=[Fix(span, fixed)])
        dot = place.tokens[dots[0]]
        return Mistake(found, Edit(dots[0], dots[0] + 1, (("COMMA", ",", dot[2], dot[3]),)))
    zero = "[0, " + span.text[1:].strip()
    found = diagnose("RL026", span, help=f"from now on: `{zero}`", fixes=[Fix(span, zero)])
    start = place.tokens[opener][3]
    low = (("NUMBER", "0", start, start), ("COMMA", ",", start, start))
    return Mistake(found, Edit(opener + 1, opener + 1, low))


def _round_interval(place: Place) -> Mistake | None:
    opener = _opener(place, place.index - 1, "LPAR", "RPAR")
    if opener is None or place.tokens[opener - 1][0] not in TEMPORAL_KINDS:
        return None
    span = place.source.span(place.tokens[opener][2], place.token(-1)[3])
    fixed = f"[{span.text[1:-1]}]"
    found = diagnose("RL026", span, help=f"write `{fixed}`", fixes=[Fix(span, fixed)])
    inside = place.tokens[opener + 1 : place.index - 1]
    first, last = place.tokens[opener], place.token(-1)
    tokens = (("LSQB", "[", first[2], first[3]), *inside, ("RSQB", "]", last[2], last[3]))
    return Mistake(found, Edit(opener, place.index, tokens))


def _opener(place: Place, closer: int, opens: str, closes: str) -> int | None:
    depth = 0
    for index in range(closer, 0, -1):
        depth += (place.tokens[index][0] == closes) - (place.tokens[index][0] == opens)
        if depth == 0:
            return index
    return None


def list_operand(place: Place) -> Mistake | None:
    """A list beside an operator, or where an operand is due."""
    behind = place.kind(-1) == "RSQB" and place.kind() in (
        "PLUS", "MINUS", "TIMES", "DIVIDE", "COMPARISON", "RANGE", "POWER", "AND", "OR",
    )  # fmt: skip
    before = place.kind() == "LSQB" and place.wants_value
    if not behind and not before:
        return None
    return Mistake(diagnose("RL025", place.span()))


def actor_order(place: Place) -> Mistake | None:
    """`is K at P on R`: the order is fixed."""
    if place.first_kind not in ("AGENT", "OBJECT") or place.kind() not in ("ON", "IS"):
        return None
    kinds = [token[0] for token in place.tokens[: place.index]]
    if place.kind() != "ON" or "AT" not in kinds or "ON" in kinds:
        return None
    at = kinds.index("AT")
    end = place.index + 1
    while place.tokens[end][0] not in ("LBRACE", END):
        end += 1
    moved = (*place.tokens[place.index : end], *place.tokens[at : place.index])
    found = diagnose("RL022", place.span(), help="the order is `is KIND on ROAD at PLACE { ... }`")
    return Mistake(found, Edit(at, end, moved))


_KNOWN: tuple[Callable[[Place], Mistake | None], ...] = (
    loose_unit,
    decimal_point,
    decimal_comma,
    subscript,
    next_item,
    next_statement,
    turned_comparison,
    stray_closer,
    interval_form,
    missing_name,
    wrong_sign,
    power_of_python,
    actor_order,
    bare_letter,
    misspelt_word,
    reserved_name,
    bare_file_name,
    list_operand,
    one_too_many,
)
