"""Words: misspelled, reserved, missing, or read as something they are not."""

from __future__ import annotations

from ...diagnostics import Code, Fix, diagnose
from ..operators import letters, token_kinds
from ..parsing.grammar import END
from ..words import CONNECTIVES, RESERVED, RESERVED_KINDS, STATEMENT_KINDS, misspelled
from .error_position import Edit, ErrorPosition, Mistake
from .token_names import expectation

_LETTERS = letters("temporal")
_BETWEEN_FORMULAS = token_kinds("logic")


def next_item(place: ErrorPosition) -> Mistake | None:
    """A value is missing, and the next line's `key:` or `verb with` was read as the value."""
    if place.kind() not in ("COLON", "WITH") or not place.starts_line(-1):
        return None
    return _value_missing(place)


def next_statement(place: ErrorPosition) -> Mistake | None:
    """A value is missing, and the next line's statement word was read as the value."""
    if place.kind(-1) not in STATEMENT_KINDS or not place.starts_line(-1):
        return None
    return _value_missing(place)


def _value_missing(place: ErrorPosition) -> Mistake | None:
    """The word before the place, on a new line, was read as the value of what precedes it."""
    before = place.back(-1)
    if before is None or not before.wants_value:
        return None
    end = before.token(-1)[3]
    span = place.source.span(end, end)
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected=expectation(before),
        found=f"the next line, `{place.word(-1)}`",
    )
    return Mistake(found, culprit=place.index - 2)


def misspelled_word(place: ErrorPosition) -> Mistake | None:
    """A word of the language with a slip in it, here or just before."""
    for offset in (0, -1):
        at = place if offset == 0 else place.back(-1)
        if at is None or at.kind() != "NAME":
            continue
        words = [word for word in (*CONNECTIVES, *RESERVED) if at.expects(word.upper())]
        meant = misspelled(at.word(), words)
        if meant is None or not at.continues(meant.upper(), skip=1, over=1):
            continue
        span = at.span()
        help = f"did you mean `{meant}`?"
        found = diagnose(
            Code.MISSPELLED_WORD, span, word=at.word(), help=help, fixes=[Fix(span, meant)]
        )
        token = (meant.upper(), meant, span.start, span.end)
        return Mistake(found, Edit(at.index, at.index + 1, (token,)))
    return None


def reserved_name(place: ErrorPosition) -> Mistake | None:
    """A reserved word where a name is declared or a key stands."""
    if place.kind() not in RESERVED_KINDS or not place.expects("NAME") or place.wants_value:
        return None
    if place.first_kind in ("REQUIRE", "EXPECT") and place.kind(1) not in ("COLON", "WITH"):
        return None
    if not place.continues("NAME", skip=1, over=1):
        return None
    help = "choose another name"
    found = diagnose(Code.RESERVED_WORD_AS_NAME, place.span(), word=place.word(), help=help)
    token = ("NAME", *place.token()[1:])
    return Mistake(found, Edit(place.index, place.index + 1, (token,)))


def missing_name(place: ErrorPosition) -> Mistake | None:
    """`require always (p)`: the name and its colon are missing; `require with sbft`: the name."""
    if place.first_kind not in ("REQUIRE", "EXPECT") or place.index not in (1, 2):
        return None
    if place.kind() in ("EQUAL", "NAME", END) or (place.kind() == "WITH" and place.index == 2):
        return None
    if place.index == 1 and place.kind() in RESERVED_KINDS and place.kind(1) == "COLON":
        return None  # a name like that
    if place.index == 2 and (place.kind() in ("COLON", "STRING", "NUMBER") or _word_then(place)):
        return None
    statement = place.tokens[0]
    follows = place.kind() if place.index == 1 else ""
    start = place.tokens[1][2]
    span = place.source.span(statement[2], statement[3])
    colon = () if follows in ("COLON", "WITH") else (("COLON", ":", start, start),)
    name = ("NAME", "NAME", start, start)
    example = f"{statement[1]} NAME{' with' if follows == 'WITH' else ':'}"
    found = diagnose(
        Code.UNNAMED_REQUIREMENT, span, word=statement[1], help=f"write `{example} ...`"
    )
    return Mistake(found, Edit(1, 1, (name, *colon)))


def _word_then(place: ErrorPosition) -> bool:
    """`require phi1 always ...`: there is a name, the colon is missing."""
    return place.kind() in RESERVED_KINDS and place.kind() not in _BETWEEN_FORMULAS


def bare_letter(place: ErrorPosition) -> Mistake | None:
    """`G e1 < 10m`: the letters are temporal words only before brackets."""
    letter = place.word(-1)
    if letter not in _LETTERS or place.kind(-1) != "NAME":
        return None
    before = place.back(-1)
    if before is None or not before.expects("ALWAYS") or not before.continues("ALWAYS", skip=1):
        return None
    span = before.span()
    word = _LETTERS[letter]
    found = diagnose(
        Code.LETTER_READ_AS_NAME,
        span,
        letter=letter,
        word=word,
        help=f"write `{word}`",
        fixes=[Fix(span, word)],
    )
    token = (word.upper(), word, span.start, span.end)
    return Mistake(found, Edit(before.index, before.index + 1, (token,)))


def subscript(place: ErrorPosition) -> Mistake | None:
    """`G_{[0, 10]}` or `G_[0, 10]`: LaTeX without a backslash."""
    # The brace may have been read as the beginning of a block.
    word = -2 if place.kind() == "LSQB" and place.kind(-1) == "LBRACE" else -1
    if not place.word(word).endswith("_") or place.kind(word + 1) not in ("LBRACE", "LSQB"):
        return None
    meant = letters("temporal", "binding").get(place.word(word).rstrip("_"))
    if meant is None:
        return None
    found = diagnose(Code.LATEX_FORMULA, place.span(word, word + 1), help=f"write `{meant}[a, b]`")
    return Mistake(found, culprit=place.index + word)


def bare_file_name(place: ErrorPosition) -> Mistake | None:
    """`include street.rl`: a file name without quotes."""
    if place.kind() != "NAME" or place.expected() != {"STRING"}:
        return None
    last = 0
    while place.kind(last + 1) in ("DOT", "NAME", "DIVIDE") and place.glued(last + 1):
        last += 1
    span = place.span(0, last)
    meant = f'"{span.text}"'
    found = diagnose(
        Code.UNEXPECTED_TOKEN, span, expected="a string in double quotes", found=f"`{span.text}`",
        help=f"write `{meant}`", fixes=[Fix(span, meant)],
    )  # fmt: skip
    token = ("STRING", meant, span.start, span.end)
    return Mistake(found, Edit(place.index, place.index + last + 1, (token,)))
