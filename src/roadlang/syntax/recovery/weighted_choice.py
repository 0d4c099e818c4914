"""Scenic's weighted choice: a map from values to weights as the only argument."""

from __future__ import annotations

from ..parsing.tokens import Token
from .error_position import Edit, ErrorPosition, Mistake

Tokens = list[Token]


def weights_map(place: ErrorPosition) -> Mistake | None:
    """`Discrete({1m: 2, 3m: 1})` is read as `Discrete(1m, 3m, weights: [2, 1])`.

    The unknown function is reported once, where functions are looked up.
    """
    around = [place.kind(offset) for offset in (-3, -2, -1)]
    if around != ["NAME", "LPAR", "LBRACE"] or place.word(-3) not in ("Discrete", "Options"):
        return None
    pairs, after = _pairs(place)
    if not pairs or place.kind(after) != "RPAR":
        return None
    edit = Edit(place.index - 1, place.index + after, tuple(_arguments(place, pairs)))
    return Mistake(None, edit)


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


def _arguments(place: ErrorPosition, pairs: list[tuple[Tokens, Tokens]]) -> list[Token]:
    start = place.token(-1)[2]

    def sign(kind: str, text: str) -> Token:
        return (kind, text, start, start)

    comma = sign("COMMA", ",")
    tokens: list[Token] = []
    for key, _ in pairs:
        tokens += [*key, comma]
    tokens += [sign("NAME", "weights"), sign("COLON", ":"), sign("LSQB", "[")]
    for number, (_, weight) in enumerate(pairs):
        tokens += ([comma] if number else []) + weight
    return [*tokens, sign("RSQB", "]")]
