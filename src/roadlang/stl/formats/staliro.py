"""Formulas pasted from S-TaLiRo and its relatives, rewritten in the language and then parsed."""

from __future__ import annotations

import re

from ...diagnostics import arguments
from ..formula import formulas as f
from .text import parse

_INTERVAL = re.compile(r"_\s*([\[(])\s*([^\[\](),]*),([^\[\](),]*)([\])])")
_WORDS = (
    (re.compile(r"\[\s*\]"), " always"),
    (re.compile(r"<\s*>"), " eventually"),
    (re.compile(r"/\\"), " and "),
    (re.compile(r"\\/"), " or "),
    (re.compile(r"\bglobally(?![A-Za-z0-9])"), "always"),
    (re.compile(r"\bfinally(?![A-Za-z0-9])"), "eventually"),
)


def read_staliro(text: str) -> f.Formula:
    r"""A formula as S-TaLiRo writes it: `[]_[0, 5] (x > 3 -> <>_[0, 2] y < 1)`, with `/\`, `\/`.

    Predicates are comparisons; names of predicates that a script defines elsewhere have to be
    replaced by them. Raises what `parse` raises for the text in the language: RL026 for half-open
    intervals that end.
    """
    arguments.text("text", text)
    for sign, word in _WORDS:
        text = sign.sub(word, text)
    text = _INTERVAL.sub(_interval, text)
    return parse(" ".join(text.split()), path="<S-TaLiRo formula>")


def _interval(match: re.Match[str]) -> str:
    """Infinity may stand on the open side."""
    opening, low, high, closing = match.groups()
    if opening == "[" and high.strip() in ("inf", "Inf", "infinity"):
        closing = "]"
    return f"{opening}{low.strip()}, {high.strip().replace('Inf', 'inf')}{closing}"
