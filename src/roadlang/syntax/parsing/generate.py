"""From the grammar to parse tables, by lark. Imported only when the grammar has changed."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from .grammar import END, LIST, STARTS, digest

_REDUCE = 1
_CONTEXTUAL = re.compile(r"[A-Za-z_]+(?=\(\?=)")


def generate(grammar: str) -> dict[str, Any]:
    """The tables of a grammar as JSON values, in the form that `tables.py` loads."""
    from lark import Lark
    from lark.grammar import Rule
    from lark.lexer import TerminalDef

    parser = Lark(grammar, parser="lalr", start=list(STARTS), maybe_placeholders=True)
    data, memo = parser.memo_serialize([TerminalDef, Rule])
    table = data["parser"]["parser"]
    rules = [memo[entry["@"]] for entry in data["rules"]]
    numbers = {entry["@"]: number for number, entry in enumerate(data["rules"])}
    order, states, rows = _states(table, numbers)
    return (
        {"digest": digest(grammar)}
        | _lexicon(parser.terminals)
        | {
            "starts": {start: order[table["start_states"][start]] for start in STARTS},
            "soft": sorted(
                {rule["expansion"][0]["name"] for rule in rules if rule["origin"]["name"] == "word"}
            ),
            "rules": [_rule(rule) for rule in rules],
            "states": states,
            "rows": rows,
        }
    )


def _lexicon(terminals: Iterable[Any]) -> dict[str, Any]:
    """Split the terminals into words (looked up) and shapes (matched, in lark's order)."""
    patterns = {
        terminal.name: terminal.pattern.to_regexp()
        for terminal in sorted(terminals, key=_lark_order)
        if terminal.pattern is not None
    }
    words = {word for pattern in patterns.values() for word in re.findall(r"[a-z]+", pattern)}
    keywords = {
        word: name
        for name, pattern in patterns.items()
        for word in sorted(words)
        if name != "NAME" and re.fullmatch(pattern, word)
    }
    letters = {m[0]: p for p in patterns.values() if (m := _CONTEXTUAL.match(p))}
    shapes = {
        name: pattern
        for name, pattern in patterns.items()
        if pattern not in letters.values()
        and not re.fullmatch(r"[a-z]+", pattern)
        and name != "SPACE"
    }
    first = {"NAME": shapes.pop("NAME"), "NUMBER": shapes.pop("NUMBER")}
    return {
        "space": f"(?:{patterns['SPACE']})?",
        "terminals": [list(shape) for shape in (first | shapes).items()],
        "keywords": keywords,
        "letters": letters,
    }


def _lark_order(terminal: Any) -> tuple[int, int, int, str]:
    pattern = terminal.pattern
    if pattern is None:
        return (0, 0, 0, terminal.name)
    return (-terminal.priority, -pattern.max_width, -len(pattern.value), terminal.name)


def _states(
    table: Mapping[str, Any], numbers: Mapping[int, int]
) -> tuple[dict[int, int], list[int], list[dict[str, int]]]:
    """Number the states in the order they are reached; equal rows are stored once."""
    order = _order(table)
    names = table["tokens"]
    places: dict[tuple[tuple[str, int], ...], int] = {}
    states: list[int] = []
    for state in order:
        row = {
            names[symbol]: ~numbers[to["@"]] if action == _REDUCE else order[to]
            for symbol, (action, to) in table["states"][state].items()
        }
        if state in table["end_states"].values():
            row[END] = order[state]
        key = tuple(sorted(row.items()))
        states.append(places.setdefault(key, len(places)))
    return order, states, [dict(key) for key in places]


def _order(table: Mapping[str, Any]) -> dict[int, int]:
    """lark numbers states as its sets fall; ours must be the same on every run."""
    queue = [table["start_states"][start] for start in STARTS]
    order: dict[int, int] = {}
    while queue:
        state = queue.pop(0)
        if state not in order:
            order[state] = len(order)
            row = table["states"][state]
            by_name = sorted(row, key=lambda symbol: str(table["tokens"][symbol]))
            queue.extend(row[symbol][1] for symbol in by_name if row[symbol][0] != _REDUCE)
    return order


def _rule(rule: Mapping[str, Any]) -> list[Any]:
    """origin, size, builder method, children taken: what lark's tree builder would do."""
    symbols, options, origin = rule["expansion"], rule["options"], str(rule["origin"]["name"])
    take: list[int | None] = []
    gaps = _gaps(options["empty_indices"], len(symbols))
    for index, symbol in enumerate(symbols):
        take.extend([None] * gaps[index])
        if not symbol.get("filter_out", False):
            take.append(~index if symbol["name"].startswith("_") else index)
    take.extend([None] * gaps[-1])
    build = rule["alias"] or origin
    if options["expand1"] and not rule["alias"] and len(take) == 1:
        build = ""
    elif build.startswith("_"):
        build = LIST
    return [origin, len(symbols), build, take]


def _gaps(empty_indices: Iterable[bool], size: int) -> list[int]:
    """How many absent optional parts stand before each child, and after the last one."""
    flags = "".join("1" if empty else "0" for empty in empty_indices)
    return [len(ones) for ones in flags.split("0")] if flags else [0] * (size + 1)
