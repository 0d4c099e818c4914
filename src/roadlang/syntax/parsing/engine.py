"""Runs the LALR(1) tables over tokens. No recursion: nesting costs stack entries, not frames."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from .grammar import LIST
from .tables import Tables
from .tokens import Token

Build: TypeAlias = Callable[..., Any]


@dataclass(frozen=True, slots=True)
class ParseError:
    """No rule goes on with the token at `index`."""

    index: int


def run(tables: Tables, start: str, tokens: Sequence[Token], builds: Sequence[Build]) -> Any:
    """The value that the builder makes of the tokens (the last one is `$END`), or `ParseError`.

    `builds` holds one callable for each rule, called with the offsets where the rule's text starts
    and ends, and with the children that the rule hands over.
    """
    actions, rules, soft = tables.actions, tables.rules, tables.soft
    states = [tables.starts[start]]
    values: list[Any] = []
    starts: list[int] = []
    ends: list[int] = []
    for index, token in enumerate(tokens):
        kind, _, first, last = token
        while True:
            row = actions[states[-1]]
            to = row.get(kind)
            if to is None:
                # Statement words and letters are names where the grammar wants nothing but a name.
                if kind not in soft or "NAME" not in row:
                    return ParseError(index)
                to = row["NAME"]
            if to >= 0:
                states.append(to)
                values.append(token)
                starts.append(first)
                ends.append(last)
                break
            origin, size, build, selection, takes_all = rules[~to]
            if build:
                children = values[len(values) - size :]
                if not takes_all:
                    grow = build == LIST and selection[0] == -1
                    children = _selected(children, selection, grow)
                if size:
                    place, end = starts[-size], ends[-1]
                    del states[-size:], values[-size:], starts[-size:], ends[-size:]
                else:
                    place = end = ends[-1] if ends else 0
                values.append(children if build == LIST else builds[~to](place, end, *children))
                starts.append(place)
                ends.append(end)
            else:
                states.pop()
            states.append(actions[states[-1]][origin])
    return values[0]


def _selected(children: list[Any], selection: Sequence[int | None], grow: bool) -> list[Any]:
    """The children that a rule hands over; a list from a repetition is spread out.

    A repetition grows its own list in place, so that long lists are linear in cost.
    """
    selected: list[Any] = children[0] if grow else []
    for index in selection[1:] if grow else selection:
        if index is None:
            selected.append(None)
        elif index >= 0:
            selected.append(children[index])
        else:
            selected.extend(children[~index])
    return selected


def advance(tables: Tables, stack: list[int], kind: str) -> bool:
    """Move the stack over a token of this kind; False, with the stack unusable, if it cannot."""
    while True:
        row = tables.actions[stack[-1]]
        to = row.get(kind, row.get("NAME") if kind in tables.soft else None)
        if to is None:
            return False
        if to >= 0:
            stack.append(to)
            return True
        rule = tables.rules[~to]
        if rule.size:
            del stack[-rule.size :]
        stack.append(tables.actions[stack[-1]][rule.origin])


def accepts(tables: Tables, states: Sequence[int], *kinds: str) -> bool:
    """Whether the parser with this stack would go on over tokens of these kinds."""
    stack = list(states)
    return all(advance(tables, stack, kind) for kind in kinds)


def expected(tables: Tables, states: Sequence[int]) -> set[str]:
    """The kinds of token that the parser with this stack would go on with, exactly."""
    return {kind for kind in tables.terminals(states[-1]) if accepts(tables, states, kind)}
