"""The LALR(1) tables of the grammar: made by lark, kept as `tables.json`, run by `engine.py`.

Importing lark and building the tables costs a third of a second; reading them costs a few
milliseconds. So they are made once, when the grammar changes:

    python -m roadlang.syntax.parsing.tables

When `tables.json` does not match the grammar, a warning says so and the tables are built in memory.
"""

from __future__ import annotations

import json
import re
import warnings
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from .grammar import digest, grammar_text

_STORED = Path(__file__).with_name("tables.json")
_STALE = (
    f"{_STORED.name} does not match grammar/roadlang.lark, so that every start builds the parse "
    "tables anew: run `python -m roadlang.syntax.parsing.tables`"
)


class Rule(NamedTuple):
    """`build` is the method of the builder that makes the value; "" returns the only child, and
    `LIST` returns the children of a repetition as a list.

    `selection` says which children are passed: an index, ~index for a list whose items are passed
    one by one, None for an optional part that is not there.
    """

    origin: str
    size: int
    build: str
    selection: tuple[int | None, ...]
    takes_all: bool
    """All children are handed over as they are."""


@dataclass(frozen=True, slots=True)
class Tables:
    """What the lexer and the engine need to know of the grammar."""

    scanner: re.Pattern[str]
    """One token, with the white space before it; the name of the group is its kind."""
    keywords: dict[str, str]
    letters: dict[str, str]
    """`G`, `F`, `next`, ...: words that are such only before what their pattern looks for. Patterns
    are compiled when their word is met: few of the 30 are in one file."""
    soft: frozenset[str]
    """Kinds of words that are names where the grammar has no other use for them."""
    rules: tuple[Rule, ...]
    actions: tuple[dict[str, int], ...]
    """By state and symbol: the next state, or ~rule to reduce by."""
    starts: dict[str, int]

    def terminals(self, state: int) -> list[str]:
        """Names of the terminals that the parser accepts in `state`."""
        return [symbol for symbol in self.actions[state] if not symbol.islower()]


@cache
def tables() -> Tables:
    """The tables of the grammar, read from `tables.json` or, if that is stale, built anew."""
    grammar = grammar_text()
    stored: dict[str, Any] = {}
    if _STORED.is_file():
        stored = json.loads(_STORED.read_text(encoding="utf-8"))
    if stored.get("digest") != digest(grammar):
        from .generate import generate

        if stored:
            warnings.warn(_STALE, RuntimeWarning, stacklevel=2)
        stored = generate(grammar)
    return _load(stored)


def _load(stored: dict[str, Any]) -> Tables:
    groups = "|".join(f"(?P<{name}>{pattern})" for name, pattern in stored["terminals"])
    rows = [{symbol: int(to) for symbol, to in row.items()} for row in stored["rows"]]
    return Tables(
        scanner=re.compile(rf"{stored['space']}(?:{groups}|(?P<BAD>[\s\S])|\Z)"),
        keywords=stored["keywords"],
        letters=stored["letters"],
        soft=frozenset(stored["soft"]).union(word.upper() for word in stored["letters"]),
        rules=tuple(
            Rule(origin, size, build, tuple(take), take == list(range(size)))
            for origin, size, build, take in stored["rules"]
        ),
        actions=tuple(rows[row] for row in stored["states"]),
        starts=stored["starts"],
    )


def write() -> None:
    """Make `tables.json` from the grammar."""
    from .generate import generate

    generated = generate(grammar_text())
    lines = (f"{json.dumps(key)}: {_lines(value)}" for key, value in generated.items())
    _STORED.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def _lines(value: Any) -> str:
    if isinstance(value, list) and value and isinstance(value[0], (list, dict)):
        return "[\n" + ",\n".join(json.dumps(item, separators=(",", ":")) for item in value) + "\n]"
    return json.dumps(value, separators=(",", ":"))


if __name__ == "__main__":
    write()
