"""What the scanner cannot read: reports it, and inserts the token that was meant."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from ...diagnostics import Code, Diagnostic, Fix, Source, diagnose
from ..parsing.tables import Tables
from ..parsing.tokens import Lexed, Token
from ..tree.strings import ESCAPE
from ..words import STATEMENTS
from .expression_habits import CONDITIONAL
from .foreign_notation import SYMBOLS, from_latex
from .suspect_tokens import COLOR, is_unknown_escape

_WORD = re.compile(r"[\w\u0300-\u036f]+")
"""Letters, also those of Unicode that are written as a letter and marks on it."""
_LATEX = re.compile(r"\$[^$\n]*\$|\\[A-Za-z]+|\\")
_SINGLE = re.compile(r"'([^'\r\n]*)'|[“”„«]([^“”»\"\r\n]*)[“”»]")
_UNIT_SIGNS = {
    "%": "%",
    "\N{DEGREE SIGN}": "deg",
    "\N{MASCULINE ORDINAL INDICATOR}": "deg",
    "\N{RING ABOVE}": "deg",
}
_CLOSED = re.compile(r'"(?:[^"\\\r\n]|\\[^\r\n])*"')
_BARE_STRING = re.compile(r"\"[\w./\\-]*(?=\s*[{,)\]}:])")
_MARGIN_STATEMENT = re.compile(rf"^(?:{'|'.join(STATEMENTS)})\b", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class UnlexableText:
    """Where the scanner stands, and what it has read so far."""

    source: Source
    tables: Tables
    lexed: Lexed
    start: int

    @property
    def tokens(self) -> list[Token]:
        """Tokens before the character that cannot be read."""
        return self.lexed.tokens

    @property
    def text(self) -> str:
        """The whole source."""
        return self.source.text

    def line_end(self) -> int:
        """Offset where the current line ends."""
        found = re.compile(r"[\r\n]|\Z").search(self.text, self.start)
        return found.start() if found else len(self.text)

    def read_as(self, kind: str, text: str, end: int) -> int:
        """Read the text up to offset `end` as a token of this kind; returns `end`."""
        self.tokens.append((kind, text, self.start, end))
        return end


Answer: TypeAlias = tuple[Diagnostic | None, int]
"""What to report, and where to go on."""


def explain_unlexable(place: UnlexableText) -> Answer:
    """Explain the character at `place.start`; adds the token that was meant, if any."""
    char = place.text[place.start]
    if char == '"':
        if place.text.startswith('"""', place.start):
            return _text(place)
        closed = _CLOSED.match(place.text, place.start)
        return _escape(place, closed.end()) if closed else _string(place)
    for explain in _EXPLAINERS:
        answer = explain(place)
        if answer is not None:
            return answer
    return _foreign(place)


def _text(place: UnlexableText) -> Answer:
    """`\"\"\"` without its end: the text probably ended before the next statement."""
    following = _MARGIN_STATEMENT.search(place.text, place.start + 3)
    end = following.start() if following else len(place.text)
    place.tokens.append(("TEXT", place.text[place.start : end].rstrip() + '"""', place.start, end))
    span = place.source.span(place.start, place.start + 3)
    return diagnose(Code.UNCLOSED_STRING, span, what="text", help='close it with `"""`'), end


def _escape(place: UnlexableText, end: int) -> Answer:
    """A string with an escape that means nothing; the string is read all the same."""
    place.read_as("STRING", place.text[place.start : end], end)
    match = next(
        match for match in ESCAPE.finditer(place.text, place.start, end) if is_unknown_escape(match)
    )
    span = place.source.span(*match.span())
    meant = "\\" + match[0]
    help = f"a backslash is written `\\\\`: `{meant}`"
    return diagnose(
        Code.UNKNOWN_ESCAPE, span, escape=match[0], help=help, fixes=[Fix(span, meant)]
    ), end


def _string(place: UnlexableText) -> Answer:
    bare = _BARE_STRING.match(place.text, place.start)
    end = bare.end() if bare else place.line_end()
    while not bare and end > place.start + 1 and place.text[end - 1] in " \t":
        end -= 1
    place.tokens.append(("STRING", place.text[place.start : end] + '"', place.start, end))
    span = place.source.span(place.start, end)
    fixes = [Fix(place.source.span(end, end), '"')]
    return diagnose(
        Code.UNCLOSED_STRING, span, what="string", help='close it with `"`', fixes=fixes
    ), end


def _single_quotes(place: UnlexableText) -> Answer | None:
    match = _SINGLE.match(place.text, place.start)
    if match is None:
        return None
    inner = match[1] if match[1] is not None else match[2]
    meant = '"' + inner.replace("\\", "\\\\") + '"'
    place.read_as("STRING", meant, match.end())
    span = place.source.span(*match.span())
    found = diagnose(
        Code.UNEXPECTED_CHARACTER,
        span,
        what=match[0][0],
        help=f"write `{meant}`",
        fixes=[Fix(span, meant)],
    )
    return found, match.end()


def _latex(place: UnlexableText) -> Answer | None:
    """LaTeX spoils its line: the form in roadlang is shown, the line is left out."""
    match = _LATEX.match(place.text, place.start)
    if match is None:
        return None
    end = place.line_end()
    for sign, word in (("/\\", "and"), ("\\/", "or")):
        start = place.start - sign.index("\\")
        if place.text.startswith(sign, start):
            sign_span = place.source.span(start, start + 2)
            help = f"write `{word}`"
            return diagnose(Code.UNEXPECTED_CHARACTER, sign_span, what=sign, help=help), end
    line = place.text[place.text.rfind("\n", 0, place.start) + 1 : end]
    formula = line.partition(":")[2] if ":" in line.partition("\\")[0] else line
    span = place.source.span(*match.span())
    shown = from_latex(formula)
    return diagnose(Code.LATEX_FORMULA, span, help=f"in roadlang: `{shown}`"), end


def _symbol(place: UnlexableText) -> Answer | None:
    char = place.text[place.start]
    meant = SYMBOLS.get(char)
    if meant is None:
        return None
    end = place.start + 1
    match = place.tables.scanner.match(meant)
    if meant and match is not None and match.lastgroup is not None:
        kind = place.tables.keywords.get(meant, match.lastgroup)
        place.read_as(kind, meant, end)
    span = place.source.span(place.start, end)
    help = f"write `{meant}`" if meant else "leave it out: a statement ends where the next begins"
    return diagnose(
        Code.UNEXPECTED_CHARACTER, span, what=char, help=help, fixes=[Fix(span, meant)]
    ), end


def _unit_sign(place: UnlexableText) -> Answer | None:
    """`5 %`, `90 °`: the sign belongs to the number before it. Also what looks like a degree sign,
    behind a space or not."""
    char = place.text[place.start]
    unit = _UNIT_SIGNS.get(char)
    if unit is None or not place.tokens:
        return None
    kind, number, start, end = place.tokens[-1]
    spaced = place.text[end : place.start]
    if kind != "NUMBER" or not number[-1].isdigit() or spaced.strip(" \t"):
        return None
    fixed = number + unit
    place.tokens[-1] = (kind, fixed, start, place.start + 1)
    span = place.source.span(start, place.start + 1)
    help, fixes = f"write `{fixed}`", [Fix(span, fixed)]
    if spaced:
        found = diagnose(
            Code.SPACE_BEFORE_UNIT, span, number=number, unit=unit, help=help, fixes=fixes
        )
    else:
        found = diagnose(Code.UNEXPECTED_CHARACTER, span, what=char, help=help, fixes=fixes)
    return found, place.start + 1


def _letter(place: UnlexableText) -> Answer | None:
    """A name with letters that are not ASCII. It is kept, so that its uses are not unknown."""
    match = _WORD.match(place.text, place.start)
    if match is None:
        return None
    start, end = match.span()
    if place.tokens and place.tokens[-1][3] == start and _WORD.fullmatch(place.tokens[-1][1]):
        start = place.tokens.pop()[2]
    name = unicodedata.normalize("NFC", place.text[start:end])  # one name, however it is typed
    place.tokens.append(("NAME", name, start, end))
    if name in place.lexed.names:
        return None, end
    place.lexed.names.add(name)
    span = place.source.span(start, end)
    return diagnose(
        Code.NON_ASCII_NAME, span, name=name, help="use the letters a-z, digits and `_`"
    ), end


def _color(place: UnlexableText) -> Answer | None:
    """`key: #2e7d32`: a comment that looks like a color where a value is expected."""
    match = COLOR.match(place.text, place.start)
    if match is None:
        return None
    meant = f'"{match[0]}"'
    place.read_as("STRING", meant, match.end())
    span = place.source.span(*match.span())
    help = f"a color is a string: `{meant}`"
    return diagnose(Code.UNQUOTED_COLOR, span, help=help, fixes=[Fix(span, meant)]), match.end()


def _comment(place: UnlexableText) -> Answer | None:
    """`// ...` and `/* ... */` are comments elsewhere."""
    if not place.text.startswith(("//", "/*"), place.start):
        return None
    mark = place.text[place.start : place.start + 2]
    end = place.line_end()
    if mark == "/*":
        closer = place.text.find("*/", place.start)
        end = closer + 2 if closer >= 0 else len(place.text)
    span = place.source.span(place.start, place.start + 2)
    return diagnose(Code.FOREIGN_COMMENT, span, what=mark, help="a comment begins with `#`"), end


def _foreign(place: UnlexableText) -> Answer:
    """Anything else; a run of the same kind of character is one mistake."""
    text, start = place.text, place.start
    end = start + 1
    if not text[start].isascii() or not text[start].isprintable():
        while end < len(text) and _same(text[start], text[end]):
            end += 1
    shown = text[start] if text[start].isprintable() else f"U+{ord(text[start]):04X}"
    help = CONDITIONAL if text[start] == "?" else ()
    span = place.source.span(start, end)
    return diagnose(Code.UNEXPECTED_CHARACTER, span, what=shown, help=help), end


def _same(first: str, char: str) -> bool:
    if char.isspace() or char in SYMBOLS or char.isalnum():
        return False
    return char.isprintable() == first.isprintable() and not (char.isascii() and char.isprintable())


_EXPLAINERS: tuple[Callable[[UnlexableText], Answer | None], ...] = (
    _color,
    _comment,
    _single_quotes,
    _latex,
    _symbol,
    _unit_sign,
    _letter,
)
