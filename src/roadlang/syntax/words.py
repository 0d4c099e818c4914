"""The words of the language, by their use, and what people call the kinds of token."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from .operators import BY_WORD, token_kinds
from .tree import statements

STATEMENTS = tuple(word for node in statements.STATEMENTS for word in node.words)
CONNECTIVES = ("from", "is", "on", "at")
RESERVED = (
    "true", "false", "with",
    *(word for word, operator in BY_WORD.items() if not operator.contextual),
)  # fmt: skip
PASS_VERBS = ("adjust", "extract", "read", "draw", "perturb", "control", "drive", "sense")
"""Words before `with KIND` in the blocks of declarations."""
LABELED_PASS_VERBS = ("sense",)
"""Those of passes that may have names of their own, `with KIND as NAME`."""

NOT_NAMES = frozenset((*RESERVED, *STATEMENTS, *CONNECTIVES, "as", "inf"))
"""Words that name no signal unless they are in back quotes."""

DEEPEST = 150
"""Levels of a statement. Later passes go through trees by recursion, within Python's limit."""

STATEMENT_KINDS = frozenset(word.upper() for word in STATEMENTS)
RESERVED_KINDS = frozenset(word.upper() for word in RESERVED)
TEMPORAL_KINDS = token_kinds("temporal", "step")
BINDING_KINDS = token_kinds("binding")
LOGIC_KINDS = token_kinds("not", "logic", "temporal", "step", "binding")
OPERATOR_KINDS = {"PLUS", "MINUS", "TIMES", "DIVIDE", "POWER", "COMPARISON", "RANGE"}
OPENERS = {"LPAR": "RPAR", "LSQB": "RSQB", "LBRACE": "RBRACE"}
CLOSERS = {closer: opener for opener, closer in OPENERS.items()}
SIGNS = {
    "LPAR": "(",
    "RPAR": ")",
    "LSQB": "[",
    "RSQB": "]",
    "LBRACE": "{",
    "RBRACE": "}",
    "COLON": ":",
    "COMMA": ",",
    "EQUAL": "=",
    "DOT": ".",
    "RANGE": "..",
    "PLUS": "+",
    "MINUS": "-",
    "TIMES": "*",
    "DIVIDE": "/",
    "POWER": "^",
}


@lru_cache(maxsize=4096)
def slip(word: str, known: str) -> bool:
    """Whether `word` is `known` with one slip: a letter more, less, another, or two swapped.

    In a longer word there may be two, and the letters may be in any order, if the first is right.
    """
    if word == known or word.lower() == known:
        return word != known
    if word[:1] == known[:1] and sorted(word) == sorted(known):
        return True
    if len(known) <= 2:
        return sorted(word) == sorted(known)
    limit = 1 if len(known) < 6 or word[:1] != known[:1] else 2
    return distance(word.lower(), known) <= limit


def misspelled(word: str, known: Iterable[str]) -> str | None:
    """The one of the known words that `word` is a slip of, or begins."""
    known = list(known)
    slips = [candidate for candidate in known if slip(word, candidate)]
    if not slips and len(word) >= 3:
        slips = [candidate for candidate in known if candidate.startswith(word)]
    return min(slips, key=lambda candidate: (distance(word, candidate), candidate), default=None)


def distance(a: str, b: str) -> int:
    """Edit distance with swaps of neighbors (optimal string alignment)."""
    if abs(len(a) - len(b)) > 3:
        return abs(len(a) - len(b))
    rows = [list(range(len(b) + 1))]
    for i, x in enumerate(a, 1):
        row = [i]
        for j, y in enumerate(b, 1):
            best = min(rows[-1][j] + 1, row[j - 1] + 1, rows[-1][j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and y == a[i - 2]:
                best = min(best, rows[-2][j - 2] + 1)
            row.append(best)
        rows.append(row)
    return rows[-1][-1]
