"""Where an agent or object stands, in another order or with a word left out."""

from __future__ import annotations

from ...diagnostics import Code, Fix, diagnose
from ..parsing.tokens import Token
from .error_position import Edit, ErrorPosition, Mistake


def position_on_road(place: ErrorPosition) -> Mistake | None:
    """`at main 5m`, `at 5m main`, `at 5m of main`, `on main 5m` and `is car main at 5m`."""
    if place.first_kind not in ("AGENT", "OBJECT"):
        return None
    return _road_after_at(place) or _missing_at(place) or _missing_on(place)


def _road_after_at(place: ErrorPosition) -> Mistake | None:
    of = place.kind() == "NAME" and place.word() == "of"
    shape = [place.kind(offset) for offset in (-2, -1, int(of))]
    has_road = any(token[0] == "ON" for token in place.tokens[: place.index])
    if has_road or shape not in (["AT", "NAME", "NUMBER"], ["AT", "NUMBER", "NAME"]):
        return None
    first, second = place.token(-1), place.token(int(of))
    road, position = (first, second) if first[0] == "NAME" else (second, first)
    return _rewritten(place, -2, int(of), road, position)


def _missing_at(place: ErrorPosition) -> Mistake | None:
    shape = [place.kind(offset) for offset in (-2, -1, 0)]
    if shape != ["ON", "NAME", "NUMBER"]:
        return None
    return _rewritten(place, -2, 0, place.token(-1), place.token())


def _missing_on(place: ErrorPosition) -> Mistake | None:
    shape = [place.kind(offset) for offset in (0, 1, 2)]
    if shape != ["NAME", "AT", "NUMBER"] or not place.expects("ON"):
        return None
    return _rewritten(place, 0, 2, place.token(), place.token(2))


def _rewritten(
    place: ErrorPosition, first: int, last: int, road: Token, position: Token
) -> Mistake:
    """The tokens at offsets `first` to `last` as `on ROAD at POSITION`."""
    span = place.span(first, last)
    meant = f"on {road[1]} at {position[1]}"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected="`on ROAD at POSITION`",
        found=f"`{span.text}`",
        help=f"write `{meant}`",
        fixes=[Fix(span, meant)],
    )
    on: Token = ("ON", "on", span.start, span.start)
    at: Token = ("AT", "at", span.start, span.start)
    edit = Edit(place.index + first, place.index + last + 1, (on, road, at, position))
    return Mistake(found, edit)


def weights_map(place: ErrorPosition) -> Mistake | None:
    """`Discrete({1m: 2, 3m: 1})`: Scenic's weighted choice."""
    around = [place.kind(offset) for offset in (-3, -2, -1)]
    if around != ["NAME", "LPAR", "LBRACE"] or place.word(-3) not in ("Discrete", "Options"):
        return None
    pairs, after = _pairs(place)
    if not pairs or place.kind(after) != "RPAR":
        return None
    span = place.span(-3, after)
    values = ", ".join(_text(place, key) for key, _ in pairs)
    weights = ", ".join(_text(place, weight) for _, weight in pairs)
    meant = f"choice({values}, weights: [{weights}])"
    found = diagnose(
        Code.UNKNOWN_FUNCTION,
        place.span(-3),
        name=place.word(-3),
        help=f"write `{meant}`",
        fixes=[Fix(span, meant)],
    )
    tokens = _choice(place, pairs)
    return Mistake(found, Edit(place.index - 3, place.index + after + 1, tuple(tokens)))


Tokens = list[Token]


def _pairs(place: ErrorPosition) -> tuple[list[tuple[Tokens, Tokens]], int]:
    """The keys and values of a map, and the offset of the token after its brace."""
    pairs: list[tuple[Tokens, Tokens]] = []
    parts: list[Tokens] = [[]]
    offset, depth = 0, 0
    while place.kind(offset) not in ("$END", ""):
        token = place.token(offset)
        depth += (token[0] in ("LPAR", "LSQB")) - (token[0] in ("RPAR", "RSQB"))
        ends = depth == 0 and token[0] in ("COMMA", "RBRACE")
        if depth == 0 and token[0] == "COLON":
            parts.append([])
        elif ends:
            if len(parts) != 2 or not all(parts):
                return [], offset
            pairs.append((parts[0], parts[1]))
            parts = [[]]
            if token[0] == "RBRACE":
                return pairs, offset + 1
        else:
            parts[-1].append(token)
        offset += 1
    return [], offset


def _choice(place: ErrorPosition, pairs: list[tuple[Tokens, Tokens]]) -> list[Token]:
    start = place.token(-3)[2]

    def sign(kind: str, text: str) -> Token:
        return (kind, text, start, start)

    comma = sign("COMMA", ",")
    name = place.token(-3)
    tokens: list[Token] = [("NAME", "choice", name[2], name[3]), place.token(-2)]
    for key, _ in pairs:
        tokens += [*key, comma]
    tokens += [sign("NAME", "weights"), sign("COLON", ":"), sign("LSQB", "[")]
    for number, (_, weight) in enumerate(pairs):
        tokens += ([comma] if number else []) + weight
    return [*tokens, sign("RSQB", "]"), sign("RPAR", ")")]


def _text(place: ErrorPosition, tokens: Tokens) -> str:
    return place.source.text[tokens[0][2] : tokens[-1][3]]
