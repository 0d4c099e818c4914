# ruff: noqa: RUF001 (signs that look like others are what this file is about)
"""Signs of other languages and typewriters, and what they are in roadlang."""

from __future__ import annotations

import re

from ..operators import OPERATORS, letters

SYMBOLS = {
    **{symbol: operator.word for operator in OPERATORS for symbol in operator.symbols},
    "≤": "<=",
    "⩽": "<=",
    "≥": ">=",
    "⩾": ">=",
    "≠": "!=",
    "≡": "==",
    "∞": "inf",
    "−": "-",
    "–": "-",
    "—": "-",
    "×": "*",
    "·": "*",
    "⋅": "*",
    "÷": "/",
    "∕": "/",
    "…": "..",
    "：": ":",
    "，": ",",
    "（": "(",
    "）": ")",
    "；": "",
    ";": "",
}

_LATEX = {
    **{command: operator.word for operator in OPERATORS for command in operator.latex},
    "leq": "<=",
    "le": "<=",
    "leqslant": "<=",
    "lt": "<",
    "geq": ">=",
    "ge": ">=",
    "geqslant": ">=",
    "gt": ">",
    "neq": "!=",
    "ne": "!=",
    "cdot": "*",
    "times": "*",
    "infty": "inf",
    "top": "true",
    "bot": "false",
}
_LETTERS = letters("temporal", "step", "binding")
_NAMES = {
    word: op.word for op in OPERATORS if op.form == "temporal" for word in op.breach
} | _LETTERS
"""Operators by what papers set upright."""
_FONT = re.compile(
    r"\\(?:math(?:bf|cal|rm|sf|it|tt)|text(?:bf|it|sf|tt|rm)?|operatorname|bm)\s*\{(\w+)\}"
)
_COMMAND = re.compile(r"\\([A-Za-z]+)")
_SUBSCRIPT = re.compile(r"\b([A-Za-z]+)\s*_\s*\{?\s*\[([^\]\n]*)\]\s*\}?")
_SIZE = re.compile(r"\\(?:left|right|big|Big|bigl|bigr|,|;|!|quad)\b ?|\\[,;! ]|\$")
_MEMBER = re.compile(r"\b([A-Za-z_]\w*) in \[([^\[\],]+),([^\[\],]+)\]")
_STEPS = "|".join(op.word for op in OPERATORS if op.contextual and op.latex)
_ATOM = re.compile(
    rf"\b({_STEPS}) (?!\()((?:[^()\[\]{{}}]|\([^()]*\))+?)"
    r"(?= (?:and|or|implies|iff|until)\b|[),]|$)"
)
"""What papers apply without parentheses to a comparison."""
_IN_BRACKETS = re.compile(r"(?<=[\[(]) | (?=[\]),])")
"""Spaces that nobody needs."""


def from_latex(text: str) -> str:
    """A formula in LaTeX, written in roadlang as far as that is clear."""
    text = _SIZE.sub(" ", text)
    text = _FONT.sub(lambda match: _NAMES.get(match[1], match[1]), text)
    text = _COMMAND.sub(lambda match: _LATEX.get(match[1], match[1]), text)
    text = _SUBSCRIPT.sub(_interval, text)
    text = re.sub(r"\s+", " ", text).strip()
    text = _ATOM.sub(r"\1(\2)", _MEMBER.sub(r"(\2 <= \1 and \1 <=\3)", text))
    return _IN_BRACKETS.sub("", text)


def _interval(match: re.Match[str]) -> str:
    word = _LETTERS.get(match[1], match[1])
    return f"{word}[{match[2]}] "
