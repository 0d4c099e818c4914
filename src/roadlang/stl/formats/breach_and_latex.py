"""Formulas pasted from Breach and from papers, rewritten in the language and then parsed."""

from __future__ import annotations

import re

from ...diagnostics import Code, Source, arguments
from ...syntax.operators import OPERATORS
from ..errors import stl_error
from ..formula import formulas as f
from .text import parse

_SIGNAL = re.compile(r"\b([A-Za-z_]\w*)\s*\[\s*t\b\s*([^\]]*)\]")
_BREACH_WORDS = {
    word: operator.word
    for operator in OPERATORS
    if operator.form in ("temporal", "binding")
    for word in operator.breach
}
_TEMPORAL = "|".join(sorted(_BREACH_WORDS, key=len, reverse=True))
_BREACH_TEMPORAL = re.compile(rf"\b({_TEMPORAL})\b_?")
_UNDERSCORE = re.compile(rf"\b({_TEMPORAL})_(?=\s*\[)")
_BREACH_DEFINITION = re.compile(r"^\s*\w+\s*:=")
_COMMENT = re.compile(r"%[^\n]*")

_MARKUP = re.compile(
    r"\\(?:begin|end)\{\w+\*?\}|\\label\{[^}]*\}|\\(?:nonumber|notag|displaystyle)\b|\\[][()]|&|\\\\"
)
_BINARY = re.compile(r"\\math(?:bin|rel|op)\s*\{")
_FRACTION = re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_SUBSCRIPT_FONT = re.compile(r"_\{\s*\\(?:text|math)\w*\s*\{([A-Za-z0-9_]+)\}\s*\}")
_SUBSCRIPTED_NAME = re.compile(r"([A-Za-z]\w*)_\{([A-Za-z0-9_]+)\}")
_NOW = re.compile(r"(?<=[\w}])\s*\(\s*t\s*\)")
_EARLIER = re.compile(r"\\mathbf\s*\{P\}|\\mathcal\s*\{P\}")
_OPEN_INTERVAL = re.compile(r"_\s*\{?\s*([\[(])([^\[\](){}]*)([\])])\s*\}?")
_MAGNITUDE = re.compile(
    r"\\[lr]?vert(?![a-z])\s*(.*?)\s*\\[lr]?vert(?![a-z])"
    r"|\\\|\s*(.*?)\s*\\\||(?<!\|)\|([^|]+)\|(?!\|)"
)
_DEFINITION = re.compile(
    r"^\s*\\?[A-Za-z_]+(?:_\{?\w+\}?)?\s*(?::=|\\coloneqq|=(?!=)|\\equiv|\\triangleq)"
)


def read_breach(text: str) -> f.Formula:
    """A formula as Breach writes it: `alw_[0, 5] (x[t] > 3 => ev_[0, 2] y[t] < 1)`.

    Raises DiagnosticError: RL331 for a signal at another time than t, and what `parse` raises for
    the text in the language.
    """
    arguments.text("text", text)
    text = _COMMENT.sub("", text)
    text = _BREACH_DEFINITION.sub("", text)
    for match in _SIGNAL.finditer(text):
        if match[2].strip():
            span = Source("<Breach formula>", text).span(*match.span())
            raise stl_error(
                Code.TIME_SHIFTED_SIGNAL, span, signal=" ".join(match[0].split()), name=match[1]
            )
    text = _SIGNAL.sub(r"\1", text).replace("~=", "!=").replace("~", "!")
    text = _UNDERSCORE.sub(r"\1", text)
    text = _BREACH_TEMPORAL.sub(lambda match: _BREACH_WORDS[match[1]], text)
    return parse(" ".join(text.split()), path="<Breach formula>")


def read_latex(text: str) -> f.Formula:
    r"""A formula as papers print it: `\mathbf{G}_{[0, 5]} (x > 3 \implies \mathbf{F} y < 1)`.

    `|x|` is abs(x), and `[0, \infty)` has no end. Raises what `parse` raises for the text in the
    language: RL026 for other half-open intervals.
    """
    from ...syntax.recovery.foreign_notation import from_latex

    arguments.text("text", text)
    text = _DEFINITION.sub("", _MARKUP.sub(" ", text).strip(" $\n.,"))
    text = re.sub(r"\\(?:left|right|middle)(?![a-z])", "", text).replace("~", " ")
    text = text.replace(r"\{", "(").replace(r"\}", ")")
    text = _EARLIER.sub(r"\\mathbf{O}", _without_binary(text))
    text = _SUBSCRIPT_FONT.sub(r"_{\1}", text)
    text = _SUBSCRIPTED_NAME.sub(r"\1_\2", text)
    text = _NOW.sub("", text)
    text = _MAGNITUDE.sub(lambda match: f"abs({match[1] or match[2] or match[3]})", text)
    text = _OPEN_INTERVAL.sub(_interval, text)
    while _FRACTION.search(text):
        text = _FRACTION.sub(r"((\1) / (\2))", text)
    return parse(from_latex(text).replace("{", "(").replace("}", ")"), path="<LaTeX formula>")


def _without_binary(text: str) -> str:
    r"""`\mathbin{...}` and the like, which only set the space around an operator, left out."""
    while match := _BINARY.search(text):
        depth, end = 1, match.end()
        while end < len(text) and depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        text = f"{text[: match.start()]} {text[match.end() : end - 1]} {text[end:]}"
    return text


def _interval(match: re.Match[str]) -> str:
    """As it stands, but infinity may be written on the open side, where papers have it."""
    opening, bounds, closing = match.groups()
    if opening == "[" and bounds.strip().endswith(("infty", "inf")):
        closing = "]"
    return f"_{{[{bounds}]}}" if (opening, closing) == ("[", "]") else f"{opening}{bounds}{closing}"
