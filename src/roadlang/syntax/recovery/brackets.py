"""Brackets of a piece that are never closed: reported where they are opened, and closed."""

from __future__ import annotations

from ...diagnostics import Code, Diagnostic, Fix, Source, diagnose
from ..operators import token_kinds
from ..parsing.grammar import END
from ..parsing.line_positions import indentation, starts_line
from ..parsing.tokens import Token
from ..words import CLOSERS, DEEPEST, OPENERS, SIGNS
from .block_items import UNREADABLE, spoil
from .error_position import looks_like_item

_OPEN_INTERVALS = {("LPAR", "RSQB"), ("LPAR", "LSQB"), ("LSQB", "LSQB"),
                   ("RSQB", "RPAR"), ("RSQB", "LSQB"), ("RSQB", "RSQB")}  # fmt: skip
_OVER_INTERVALS = token_kinds("temporal", "binding", "measure")


def close_brackets(source: Source, tokens: list[Token]) -> tuple[list[Token], list[Diagnostic]]:
    """The tokens with every bracket closed, and what was not. A closer too many is left alone."""
    found: list[Diagnostic] = []
    tokens = _closed_intervals(source, tokens, found)
    for _ in range(20):
        fault = _first_fault(source, tokens)
        if fault is None:
            break
        opener, place = fault
        if tokens[place][0] in CLOSERS and not _opened(tokens, opener, tokens[place][0]):
            tokens = _exchange(source, tokens, opener, place, found)
        else:
            tokens = _close(source, tokens, opener, place, found)
    return tokens, found


def _closed_intervals(source: Source, tokens: list[Token], found: list[Diagnostic]) -> list[Token]:
    """`(a, b]`, `]a, b[` and `[a, b[` after a temporal operator, as `[a, b]`.

    `[a, b)` is like any bracket that is closed by another; `(a, b)` may be an operand.
    """
    result = list(tokens)
    for index in range(1, len(tokens) - 4):
        first, *bounds, last = tokens[index : index + 5]
        forms = first[0], last[0]
        if (
            tokens[index - 1][0] not in _OVER_INTERVALS
            or forms not in _OPEN_INTERVALS
            or [kind for kind, *_ in bounds[::2]] != ["NUMBER"] * 2
            or bounds[1][0] != "COMMA"
        ):
            continue
        span = source.span(first[2], last[3])
        fixed = f"[{span.text[1:-1]}]"
        help = f"intervals include both ends: write `{fixed}`"
        fixes = [Fix(span, fixed)]
        found.append(diagnose(Code.MALFORMED_INTERVAL, span, help=help, fixes=fixes))
        result[index] = ("LSQB", "[", *first[2:])
        result[index + 4] = ("RSQB", "]", *last[2:])
    return result


def _exchange(
    source: Source, tokens: list[Token], opener: int, place: int, found: list[Diagnostic]
) -> list[Token]:
    """`(a]`: the closing bracket is of another form than the opening one."""
    kind, text, start, end = tokens[opener]
    wrong, closer = tokens[place], SIGNS[OPENERS[kind]]
    there = source.span(wrong[2], wrong[3])
    line = source.span(start, end).line
    fixes = [Fix(there, closer)]
    if kind == "LSQB" and tokens[opener - 1][0] in _OVER_INTERVALS:
        help = f"intervals include both ends: close it with `{closer}`"
        fault = diagnose(
            Code.MALFORMED_INTERVAL, source.span(start, wrong[3]), help=help, fixes=fixes
        )
    else:
        help = f"`{text}` of line {line} is closed by `{closer}`"
        fault = diagnose(Code.UNMATCHED_BRACKET, there, what=wrong[1], help=help, fixes=fixes)
    found.append(fault)
    return [*tokens[:place], (OPENERS[kind], closer, *wrong[2:]), *tokens[place + 1 :]]


def _close(
    source: Source, tokens: list[Token], opener: int, place: int, found: list[Diagnostic]
) -> list[Token]:
    """Report a bracket that is never closed, and close it where it should have been."""
    kind, text, start, end = tokens[opener]
    closer = SIGNS[OPENERS[kind]]
    span = source.span(start, end)
    found.append(diagnose(Code.UNCLOSED_BRACKET, span, what=text, help=f"close it with `{closer}`"))
    behind, before = tokens[place - 1][3], tokens[place - 1][0]
    closed = [*tokens[:place], (OPENERS[kind], closer, behind, behind), *tokens[place:]]
    if kind == "LBRACE":
        return closed
    # What the bracket holds is a guess: say nothing more about the item around it.
    if before in OPENERS or before == "COMMA":
        everything: Token = (UNREADABLE, "", tokens[0][2], behind)
        return spoil(source, closed, opener) or [everything, tokens[-1]]
    if tokens[place][0] != END:
        return spoil(source, closed, opener) or closed
    return closed


def too_deep(tokens: list[Token]) -> int | None:
    """The index of the first bracket that is nested too deep to be read."""
    depth = 0
    for index, token in enumerate(tokens):
        if token[0] in OPENERS:
            depth += 1
            if depth > DEEPEST:
                return index
        elif token[0] in CLOSERS:
            depth = max(0, depth - 1)
    return None


def _opened(tokens: list[Token], before: int, closer: str) -> bool:
    """Whether a bracket that this one closes is open before the token `before`."""
    depth = 0
    for token in tokens[:before]:
        depth += (token[0] == CLOSERS[closer]) - (token[0] == closer)
    return depth > 0


def _first_fault(source: Source, tokens: list[Token]) -> tuple[int, int] | None:
    """An opener without its closer, and the index of the token before which it should be closed."""
    stack: list[int] = []
    for index, token in enumerate(tokens):
        kind = token[0]
        if kind in OPENERS:
            stack.append(index)
        elif kind in CLOSERS and stack:
            top = stack[-1]
            further_out = _belongs_further_out(source, tokens, stack, token)
            if CLOSERS[kind] != tokens[top][0] or further_out:
                return top, _where(source, tokens, top, index)
            stack.pop()
        elif kind not in CLOSERS and stack and _item_inside(source, tokens, stack[-1], index):
            return stack[-1], index
    if stack:
        return stack[-1], _where(source, tokens, stack[-1], len(tokens) - 1)
    return None


def _item_inside(source: Source, tokens: list[Token], opener: int, index: int) -> bool:
    """A line begins `key:` or `verb with` where a `(` or `[` is open.

    Within `f(`, such lines are arguments.
    """
    if tokens[opener][0] == "LBRACE" or not starts_line(source, tokens[index]):
        return False
    in_call = (
        tokens[opener][0] == "LPAR"
        and tokens[opener - 1][0] == "NAME"
        and tokens[opener - 1][3] == tokens[opener][2]
    )
    return not in_call and looks_like_item(tokens, index)


def _belongs_further_out(
    source: Source, tokens: list[Token], stack: list[int], closer: Token
) -> bool:
    """`}` on a line of its own stands under the line of another `{` than the innermost."""
    if closer[0] != "RBRACE" or len(stack) < 2 or not starts_line(source, closer):
        return False
    column = indentation(source, closer[2])
    innermost = indentation(source, tokens[stack[-1]][2])
    outer = [indentation(source, tokens[opener][2]) for opener in stack[:-1]]
    return innermost > column and column in outer


def _where(source: Source, tokens: list[Token], opener: int, latest: int) -> int:
    """Before which token a bracket should be closed: a `{` before the next line not further in."""
    if tokens[opener][0] == "LBRACE":
        column = indentation(source, tokens[opener][2])
        inside = any(token[0] == "LBRACE" for token in tokens[:opener])
        for index in range(opener + 1, latest):
            token = tokens[index]
            if not starts_line(source, token) or indentation(source, token[2]) > column:
                continue
            if inside or not looks_like_item(tokens, index):
                return index
    return latest
