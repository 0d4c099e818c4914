"""Random syntax trees that could have been read from a file, for hypothesis.

Trees follow the precedence of the language: what binds looser stands in a `Group`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from string import ascii_letters, digits
from typing import Any, TypeVar

from hypothesis import strategies as st

from roadlang.diagnostics import Source, Span
from roadlang.syntax.operators import BY_WORD, letters
from roadlang.syntax.recovery.operator_spelling import meant_temporal
from roadlang.syntax.tree import nodes as ast
from roadlang.syntax.tree.strings import dedented
from roadlang.syntax.words import CONNECTIVES, RESERVED, STATEMENTS

T = TypeVar("T")
NOWHERE = Span(Source("generated", ""), 0, 0)
_LETTERS_OF_THE_LITERATURE = letters("temporal", "binding")
_ANY_WORD = [*STATEMENTS, *CONNECTIVES]
_DEEPEST = 3


def _free(name: str) -> bool:
    taken = name in RESERVED or name in (*_ANY_WORD, "as") or name in _LETTERS_OF_THE_LITERATURE
    # `X (p)` is `next (p)`, and `count[0]` the beginning of a formula.
    is_operator = name in BY_WORD or (len(name) == 1 and name.isupper())
    return not taken and not is_operator and meant_temporal(name) is None


def _begun(word: str) -> str:
    """With a letter or `_` in front where it begins with a digit."""
    return f"_{word}" if word[0].isdigit() else word


_letters = ascii_letters + digits + "_"  # `from_regex` takes twice as long to draw
_identifiers = st.text(_letters, min_size=1, max_size=8).map(_begun).filter(_free)
_digits = st.sampled_from(["0", "8", "12", "0.35", "2.50", "1e3", "1e-3"])
_units = st.sampled_from(["", "m", "m/s", "m/s^2", "/m", "%", "m^1.5", "m^-1", "deg", "px"])
_printable = st.characters(exclude_categories=["Cc", "Cs"])
_content = st.text(st.one_of(_printable, st.sampled_from('"\\\n\t#')), max_size=12)
_drawing = st.text(st.sampled_from("#.T \n\\"), max_size=30)


class _Grower:
    """Draws trees of limited depth; each method is one level of precedence."""

    def __init__(self, draw: Callable[[st.SearchStrategy[Any]], Any]) -> None:
        self.draw = draw

    def one_of(self, *makers: Callable[[int], T]) -> Callable[[int], T]:
        index: int = self.draw(st.integers(0, len(makers) - 1))
        return makers[index]

    def pick(self, words: str) -> str:
        return str(self.draw(st.sampled_from(words.split())))

    def some(
        self, make: Callable[[int], Any], depth: int, least: int, most: int
    ) -> tuple[Any, ...]:
        return tuple(make(depth) for _ in range(self.draw(st.integers(least, most))))

    def maybe(self, make: Callable[[int], Any], depth: int) -> Any:
        return make(depth) if self.draw(st.booleans()) else None

    # --- words ----------------------------------------------------------------------------

    def word(self, depth: int = 0) -> ast.Word:
        return ast.Word(self.draw(_identifiers), span=NOWHERE)

    def key(self, depth: int = 0) -> ast.Word:
        text = self.draw(st.one_of(_identifiers, st.sampled_from(_ANY_WORD)))
        return ast.Word(text, span=NOWHERE)

    def kind(self, depth: int = 0) -> ast.KindName:
        words = [self.word().text, *(word.text for word in self.some(self.key, 0, 0, 1))]
        return ast.KindName(".".join(words), span=NOWHERE)

    def string(self, depth: int = 0) -> ast.String:
        return ast.String(self.draw(_content), span=NOWHERE)

    def text(self, depth: int = 0) -> ast.Text:
        return ast.Text(dedented(f'"""{self.draw(_drawing)}"""'), span=NOWHERE)

    # --- expressions, tight to loose ------------------------------------------------------

    def number(self, depth: int = 0) -> ast.Expression:
        return ast.NumberLiteral(self.draw(_digits), self.draw(_units), span=NOWHERE)

    def boolean(self, depth: int = 0) -> ast.Expression:
        return ast.Boolean(self.draw(st.booleans()), span=NOWHERE)

    def reference(self, depth: int = 0) -> ast.Name | ast.Member:
        name = ast.Name(self.word().text, span=NOWHERE)
        if self.draw(st.booleans()):
            return name
        return ast.Member(self.maybe_numbered(name), self.key(), span=NOWHERE)

    def maybe_numbered(self, name: ast.Name) -> ast.Expression:
        if self.draw(st.booleans()):
            return name
        return ast.Numbered(name, ast.NumberLiteral("0", span=NOWHERE), span=NOWHERE)

    def argument(self, depth: int) -> ast.Argument:
        return ast.Argument(self.value(depth), self.maybe(self.key, 0), span=NOWHERE)

    def call(self, depth: int) -> ast.CallExpression:
        arguments = self.some(self.argument, depth - 1, 0, 2)
        return ast.CallExpression(self.reference(), arguments, span=NOWHERE)

    def called_member(self, depth: int) -> ast.Expression:
        return ast.Member(self.call(depth), self.key(), span=NOWHERE)

    def group(self, depth: int) -> ast.Expression:
        return ast.GroupExpression(self.formula(depth - 1), span=NOWHERE)

    def point(self, depth: int) -> ast.Expression:
        return ast.Point(self.some(self.formula, depth - 1, 2, 3), span=NOWHERE)

    def atom(self, depth: int) -> ast.Expression:
        simple = (self.number, self.reference, self.boolean, self.string)
        if depth <= 0:
            return self.one_of(*simple)(depth)
        return self.one_of(*simple, self.call, self.called_member, self.group, self.point)(depth)

    def unary(self, depth: int) -> ast.Expression:
        return self.one_of(self.atom, self.atom, self.power, self.negate)(depth)

    def power(self, depth: int) -> ast.Expression:
        return self._arithmetic("^", self.atom(depth), self.unary(depth - 1))

    def negate(self, depth: int) -> ast.Expression:
        return ast.NegateExpression(self.unary(depth), span=NOWHERE)

    def random_value(self, depth: int) -> ast.Expression:
        return ast.Draw(self.unary(depth), self.unary(depth), span=NOWHERE)

    def product(self, depth: int) -> ast.Expression:
        return self._arithmetic(self.pick("* /"), self.unary(depth), self.unary(depth))

    def sum(self, depth: int) -> ast.Expression:
        term = self.one_of(self.unary, self.unary, self.product)
        if self.draw(st.booleans()):
            return term(depth)
        return self._arithmetic(self.pick("+ -"), term(depth), self.unary(depth))

    def _arithmetic(self, sign: str, left: ast.Expression, right: ast.Expression) -> ast.Expression:
        return ast.ArithmeticExpression(sign, left, right, operator_span=NOWHERE, span=NOWHERE)

    def comparison(self, depth: int) -> ast.Expression:
        operands = self.some(self.sum, depth, 2, 3)
        signs = tuple(self.pick("< <= > >= == !=") for _ in operands[1:])
        return ast.ComparisonExpression(operands, signs, span=NOWHERE)

    def interval(self, depth: int) -> ast.IntervalExpression:
        return ast.IntervalExpression(self.sum(depth - 1), self.sum(depth - 1), span=NOWHERE)

    def negation(self, depth: int) -> ast.Expression:
        return ast.NotExpression(self.group(depth), span=NOWHERE)

    def temporal(self, depth: int) -> ast.Expression:
        inner = self.one_of(self.group, self.group, self.temporal)(depth)
        word = self.pick("always eventually once historically")
        interval = self.maybe(self.interval, depth)
        return ast.Temporal(word, interval, inner, word_span=NOWHERE, span=NOWHERE)

    def prefixed(self, depth: int) -> ast.Expression:
        return self.one_of(self.sum, self.comparison, self.negation, self.temporal)(depth)

    def binding(self, depth: int) -> ast.Expression:
        left, right = self.prefixed(depth), self.prefixed(depth)
        word, interval = self.pick("until since"), self.maybe(self.interval, depth)
        return ast.Binding(word, interval, left, right, word_span=NOWHERE, span=NOWHERE)

    def conjunction(self, depth: int) -> ast.Expression:
        tight = self.one_of(self.prefixed, self.binding)
        return ast.Logic("and", self.some(tight, depth, 2, 3), span=NOWHERE)

    def disjunction(self, depth: int) -> ast.Expression:
        tight = self.one_of(self.prefixed, self.conjunction)
        return ast.Logic("or", self.some(tight, depth, 2, 3), span=NOWHERE)

    def pair(self, depth: int) -> ast.Expression:
        tight = self.one_of(self.prefixed, self.conjunction, self.disjunction)
        word = self.pick("implies iff xor")
        return ast.Logic(word, self.some(tight, depth, 2, 2), span=NOWHERE)

    def formula(self, depth: int) -> ast.Expression:
        if depth <= 0:
            return self.prefixed_shallow()
        looser = (self.binding, self.conjunction, self.disjunction, self.pair)
        return self.one_of(self.prefixed, self.random_value, *looser)(depth)

    def prefixed_shallow(self) -> ast.Expression:
        return self.one_of(self.unary, self.sum, self.random_value)(0)

    def value(self, depth: int) -> ast.Expression:
        if depth <= 0:
            return self.formula(0)
        return self.one_of(self.formula, self.formula, self.list, self.map, self.text)(depth)

    def list(self, depth: int) -> ast.Expression:
        return ast.ListValue(self.some(self.value, depth - 1, 0, 3), span=NOWHERE)

    def map(self, depth: int) -> ast.Expression:
        return ast.MapValue(self.some(self.entry, depth - 1, 0, 3), span=NOWHERE)

    def entry(self, depth: int) -> ast.MapEntry:
        makers: tuple[Callable[[int], ast.Word | ast.String], ...] = (self.key, self.string)
        key = self.one_of(*makers)(0)
        return ast.MapEntry(key, self.value(depth), span=NOWHERE)

    def source(self, depth: int) -> ast.Expression:
        return self.one_of(self.reference, self.string, self.call)(depth)

    # --- blocks and statements ------------------------------------------------------------

    def option(self, depth: int) -> ast.Option:
        return ast.Option(self.key(), self.value(depth), span=NOWHERE)

    def pass_(self, depth: int) -> ast.Pass:
        block = self.maybe(self.block, depth - 1)
        label = self.maybe(lambda _: self.word(), depth)
        return ast.Pass(self.word(), self.kind(), label, block, span=NOWHERE)

    def block(self, depth: int) -> ast.Block:
        item = self.option if depth <= 0 else self.one_of(self.option, self.pass_)
        return ast.Block(self.some(item, depth, 0, 3), span=NOWHERE)

    def statement(self, depth: int) -> ast.Statement:
        node = self.draw(st.sampled_from(ast.STATEMENTS))
        values = {
            field.name: self.field(node, field.name, str(field.type), depth)
            for field in dataclasses.fields(node)
            if not field.kw_only
        }
        if node is ast.Constraint:  # a formula or a kind, with or without a block
            left_out = self.one_of(
                lambda _: ["formula"], lambda _: ["kind", "block"], lambda _: ["kind"]
            )(0)
            values |= dict.fromkeys(left_out)
        made: ast.Statement = node(**values, span=NOWHERE)
        return made

    def field(self, node: type[ast.Statement], name: str, hint: str, depth: int) -> Any:
        """The value of one field of a statement, by its type and its name."""
        expressions: dict[str, Callable[[int], Any]] = {
            "value": self.value,
            "at": self.formula,
            "formula": self.formula,
        }
        if name == "source":
            expressions["source"] = self.one_of(self.source, self.text)
        expressions["target"] = self.reference
        make = {
            "str": lambda _: self.draw(st.sampled_from(node.words)),
            "Word": self.word,
            "String": self.string,
            "KindName": self.kind,
            "Block": lambda _: self.block(2),
            "Expression": expressions.get(name, self.source),
        }[hint.removesuffix(" | None")]
        always = node is ast.Constraint or not hint.endswith(" | None")
        return make(depth) if always else self.maybe(make, depth)


@st.composite
def formulas(draw: Callable[[st.SearchStrategy[Any]], Any]) -> ast.Expression:
    return _Grower(draw).formula(_DEEPEST)


@st.composite
def files(draw: Callable[[st.SearchStrategy[Any]], Any]) -> ast.File:
    grower = _Grower(draw)
    return ast.File(grower.some(grower.statement, _DEEPEST, 0, 3), span=NOWHERE)
