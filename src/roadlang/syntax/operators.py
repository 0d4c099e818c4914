# ruff: noqa: RUF001 (characters of mathematics that look like letters)
"""How every operator of formulas is written, in the language and in other notations: one table.

What an operator means is its class in `roadlang.stl.formula.formulas`, found by its word.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

Form: TypeAlias = Literal["not", "temporal", "step", "binding", "logic", "measure"]
"""`not p`; `always[a, b] p`; `next p`; `p until[a, b] q`; `p and q`; `count[a, b] (p) < 3`."""

PREFIXES: tuple[Form, ...] = ("not", "temporal", "step")
"""The forms with one operand, which follows the word."""

IFF, IMPLIES, OR, AND, UNTIL, PREFIX, COMPARISON = range(1, 8)
"""How tightly operators bind, from loose to tight."""


@dataclass(frozen=True, slots=True)
class Operator:
    """`word` is what the language prints. An operand whose level is below `operand_level` stands
    in parentheses. `mirror` is the operator that looks the other way along the axis.
    """

    word: str
    form: Form
    level: int
    operand_level: int
    json: str
    """The tag in JSON files; a word that is renamed keeps it."""
    letter: str = ""
    """The letter of the literature."""
    signs: tuple[str, ...] = ()
    """Other spellings that the grammar reads."""
    symbols: tuple[str, ...] = ()
    """Characters of mathematics, for which the word is suggested."""
    latex: tuple[str, ...] = ()
    """Names of LaTeX commands."""
    breach: tuple[str, ...] = ()
    """Words of Breach, beside our own."""
    rtamt: str = ""
    """The word of RTAMT; without one the operator is written by others."""
    mirror: str = ""
    contextual: bool = False
    """A word only where nothing else fits: options and names may be called the same."""


OPERATORS: tuple[Operator, ...] = (
    Operator(
        "not", "not", PREFIX, PREFIX, "not",
        signs=("!",), symbols=("¬",), latex=("neg", "lnot"), breach=("not",), rtamt="not",
    ),
    Operator(
        "and", "logic", AND, UNTIL, "and",
        signs=("&", "&&"), symbols=("∧",), latex=("land", "wedge"), rtamt="and",
    ),
    Operator(
        "or", "logic", OR, AND, "or",
        signs=("|", "||"), symbols=("∨",), latex=("lor", "vee"), rtamt="or",
    ),
    Operator(
        "implies", "logic", IMPLIES, OR, "implies",
        signs=("->", "=>"), symbols=("→", "⇒", "⟹", "⟶"),
        latex=("implies", "to", "rightarrow", "Rightarrow"), rtamt="->",
    ),
    Operator(
        "iff", "logic", IFF, OR, "iff",
        signs=("<->", "<=>"), symbols=("↔", "⇔", "⟺"),
        latex=("iff", "leftrightarrow", "Leftrightarrow"),
    ),
    Operator("xor", "logic", IFF, PREFIX, "xor", symbols=("⊕",), latex=("oplus",)),
    Operator(
        "always", "temporal", PREFIX, PREFIX, "always",
        letter="G", symbols=("□", "◻"), latex=("Box", "square"),
        breach=("alw", "always"), rtamt="always", mirror="historically",
    ),
    Operator(
        "eventually", "temporal", PREFIX, PREFIX, "eventually",
        letter="F", symbols=("◇", "◊", "⋄"), latex=("Diamond", "lozenge"),
        breach=("ev", "eventually"), rtamt="eventually", mirror="once",
    ),
    Operator(
        "historically", "temporal", PREFIX, PREFIX, "historically",
        letter="H", latex=("boxminus", "blacksquare"),
        breach=("hist", "historically"), rtamt="historically", mirror="always",
    ),
    Operator(
        "once", "temporal", PREFIX, PREFIX, "once",
        letter="O", latex=("diamondminus", "blacklozenge"),
        breach=("once",), rtamt="once", mirror="eventually",
    ),
    Operator(
        "until", "binding", UNTIL, PREFIX, "until",
        letter="U", breach=("until",), rtamt="until", mirror="since",
    ),
    Operator(
        "since", "binding", UNTIL, PREFIX, "since",
        letter="S", breach=("since",), rtamt="since", mirror="until",
    ),
    Operator(
        "release", "binding", UNTIL, PREFIX, "release",
        letter="R", mirror="trigger", contextual=True,
    ),
    Operator(
        "trigger", "binding", UNTIL, PREFIX, "trigger",
        letter="T", mirror="release", contextual=True,
    ),
    Operator(
        "weak_until", "binding", UNTIL, PREFIX, "weak_until",
        letter="W", mirror="weak_since", contextual=True,
    ),
    Operator(
        "weak_since", "binding", UNTIL, PREFIX, "weak_since",
        letter="B", mirror="weak_until", contextual=True,
    ),
    Operator(
        "next", "step", PREFIX, PREFIX, "next",
        letter="X", symbols=("○", "◯"), latex=("bigcirc", "circ"), rtamt="s_next",
        mirror="prev", contextual=True,
    ),
    Operator(
        "prev", "step", PREFIX, PREFIX, "prev",
        letter="Y", latex=("ominus",), rtamt="s_prev", mirror="next", contextual=True,
    ),
    Operator("rise", "step", PREFIX, PREFIX, "rise", rtamt="rise", contextual=True),
    Operator("fall", "step", PREFIX, PREFIX, "fall", rtamt="fall", contextual=True),
    Operator("count", "measure", COMPARISON, PREFIX, "count", contextual=True),
    Operator("duration", "measure", COMPARISON, PREFIX, "duration", contextual=True),
)  # fmt: skip

BY_WORD: dict[str, Operator] = {operator.word: operator for operator in OPERATORS}


def words(*forms: Form) -> tuple[str, ...]:
    """The words of the operators of these forms."""
    return tuple(operator.word for operator in OPERATORS if operator.form in forms)


def letters(*forms: Form) -> dict[str, str]:
    """The word for each letter of the literature."""
    return {
        operator.letter: operator.word
        for operator in OPERATORS
        if operator.letter and operator.form in forms
    }


def token_kinds(*forms: Form) -> frozenset[str]:
    """The kinds of token that the grammar has for the words and letters of these forms."""
    return frozenset(word.upper() for word in words(*forms)).union(letters(*forms))
