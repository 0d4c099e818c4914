"""What each rule of the grammar becomes in the tree. Methods are named after the rules."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from dataclasses import fields
from functools import partial
from typing import Any

from ...diagnostics import Source, Span
from ..operators import OPERATORS, letters
from ..tree import nodes as ast
from ..tree.statements import BY_RULE
from ..tree.strings import dedented, unescaped
from .tokens import Token

_DIGITS = re.compile(r"[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?")
_WORD = {operator.word.upper(): operator.word for operator in OPERATORS} | letters(
    "temporal", "step", "binding"
)
"""The operator that a kind of token stands for."""


class Builder:
    """Makes the nodes of one source. Each method gets the rule's offsets and its children."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.spoiled: list[ast.Word] = []

    def method(self, rule: str) -> Callable[..., Any]:
        """What makes the value of a rule; a rule without a method makes a tuple of its children."""
        statement = BY_RULE.get(rule)
        return partial(self._statement, statement) if statement else getattr(self, rule, tuple)

    def _statement(
        self, node: type[ast.Statement], start: int, end: int, *children: Any
    ) -> ast.Statement:
        """A statement whose children are its fields, in order."""
        names = [field.name for field in fields(node) if not field.kw_only]
        values = {
            name: child if not isinstance(child, tuple) else child[1] if name == "word"
            else self._word(child)
            for name, child in zip(names, children, strict=False)
        }  # fmt: skip
        return node(**values, span=Span(self.source, start, end))

    def _word(self, token: Token) -> ast.Word:
        return ast.Word(token[1], span=Span(self.source, token[2], token[3]))

    def _span(self, token: Token) -> Span:
        return Span(self.source, token[2], token[3])

    # --- statements ---------------------------------------------------------------------

    def file(self, start: int, end: int, *statements: ast.Statement | None) -> ast.File:
        read = tuple(statement for statement in statements if statement is not None)
        return ast.File(read, span=Span(self.source, 0, len(self.source.text)))

    def formula_constraint(
        self,
        start: int,
        end: int,
        word: Token,
        name: Token,
        formula: ast.Expression,
        block: ast.Block | None,
    ) -> ast.Constraint:
        span = Span(self.source, start, end)
        return ast.Constraint(word[1], self._word(name), formula, None, block, span=span)

    def judged_constraint(
        self,
        start: int,
        end: int,
        word: Token,
        name: Token,
        kind: ast.KindName,
        block: ast.Block | None,
    ) -> ast.Constraint:
        span = Span(self.source, start, end)
        return ast.Constraint(word[1], self._word(name), None, kind, block, span=span)

    def unreadable(self, start: int, end: int, token: Token) -> None:
        return None

    # --- blocks -------------------------------------------------------------------------

    def block(self, start: int, end: int, *items: ast.Option | ast.Pass | None) -> ast.Block:
        read = tuple(item for item in items if item is not None)
        span = Span(self.source, start, end)
        return ast.Block(read, complete=len(read) == len(items), span=span)

    def option(self, start: int, end: int, key: ast.Word, value: ast.Expression) -> ast.Option:
        return ast.Option(key, value, span=Span(self.source, start, end))

    def pass_(
        self,
        start: int,
        end: int,
        verb: Token,
        kind: ast.KindName,
        label: Token | None,
        block: ast.Block | None,
    ) -> ast.Pass:
        named = None if label is None else self._word(label)
        return ast.Pass(self._word(verb), kind, named, block, span=Span(self.source, start, end))

    def kind(self, start: int, end: int, *words: Token) -> ast.KindName:
        text = ".".join(word[1] for word in words)
        return ast.KindName(text, span=Span(self.source, start, end))

    def key(self, start: int, end: int, token: Token) -> ast.Word:
        return self._word(token)

    # --- values -------------------------------------------------------------------------

    def list(self, start: int, end: int, *items: ast.Expression | None) -> ast.ListValue:
        values = tuple(item for item in items if item is not None)
        return ast.ListValue(values, span=Span(self.source, start, end))

    def map(self, start: int, end: int, *entries: ast.MapEntry) -> ast.MapValue:
        return ast.MapValue(entries, span=Span(self.source, start, end))

    def entry(
        self, start: int, end: int, key: ast.Word | ast.String, value: ast.Expression
    ) -> ast.MapEntry:
        return ast.MapEntry(key, value, span=Span(self.source, start, end))

    def number(self, start: int, end: int, token: Token) -> ast.NumberLiteral:
        text = token[1]
        match = _DIGITS.match(text)
        assert match is not None, "the lexer lets only numbers through"
        digits = match[0]
        return ast.NumberLiteral(digits, text[len(digits) :], span=Span(self.source, start, end))

    def string(self, start: int, end: int, token: Token) -> ast.String:
        return ast.String(unescaped(token[1]), span=Span(self.source, start, end))

    def text(self, start: int, end: int, token: Token) -> ast.Text:
        return ast.Text(dedented(token[1]), span=Span(self.source, start, end))

    def boolean(self, start: int, end: int, token: Token) -> ast.Boolean:
        return ast.Boolean(token[0] == "TRUE", span=Span(self.source, start, end))

    # --- expressions --------------------------------------------------------------------

    def name(self, start: int, end: int, token: Token) -> ast.Name:
        return ast.Name(token[1], span=Span(self.source, start, end))

    def quoted(self, start: int, end: int, token: Token) -> ast.Name:
        name = unicodedata.normalize("NFC", token[1][1:-1])  # as names of columns are read
        return ast.Name(name, quoted=True, span=Span(self.source, start, end))

    def member(self, start: int, end: int, of: ast.Expression, name: Token) -> ast.Member:
        return ast.Member(of, self._word(name), span=Span(self.source, start, end))

    def numbered(self, start: int, end: int, of: ast.Expression, number: Token) -> ast.Numbered:
        place = self._span(number)
        literal = self.number(place.start, place.end, number)
        return ast.Numbered(of, literal, span=Span(self.source, start, end))

    def call(
        self, start: int, end: int, function: ast.Name | ast.Member, *arguments: ast.Argument | None
    ) -> ast.CallExpression:
        present = tuple(argument for argument in arguments if argument is not None)
        return ast.CallExpression(function, present, span=Span(self.source, start, end))

    def positional(self, start: int, end: int, value: ast.Expression) -> ast.Argument:
        return ast.Argument(value, span=Span(self.source, start, end))

    def named(self, start: int, end: int, key: ast.Word, value: ast.Expression) -> ast.Argument:
        return ast.Argument(value, key, span=Span(self.source, start, end))

    def group(self, start: int, end: int, inner: ast.Expression) -> ast.GroupExpression:
        return ast.GroupExpression(inner, span=Span(self.source, start, end))

    def point(self, start: int, end: int, *items: ast.Expression) -> ast.Point:
        return ast.Point(items, span=Span(self.source, start, end))

    def negate(
        self, start: int, end: int, sign: Token, operand: ast.Expression
    ) -> ast.NegateExpression:
        return ast.NegateExpression(operand, span=Span(self.source, start, end))

    def draw(
        self, start: int, end: int, low: ast.Expression, dots: Token, high: ast.Expression
    ) -> ast.Draw:
        return ast.Draw(low, high, span=Span(self.source, start, end))

    def arithmetic(
        self, start: int, end: int, left: ast.Expression, sign: Token, right: ast.Expression
    ) -> ast.ArithmeticExpression:
        span = Span(self.source, start, end)
        return ast.ArithmeticExpression(
            sign[1], left, right, operator_span=self._span(sign), span=span
        )

    def comparison(self, start: int, end: int, *parts: Any) -> ast.ComparisonExpression:
        signs = tuple(sign[1] for sign in parts[1::2])
        return ast.ComparisonExpression(
            tuple(parts[::2]), signs, span=Span(self.source, start, end)
        )

    def not_(self, start: int, end: int, word: Token, operand: ast.Expression) -> ast.NotExpression:
        return ast.NotExpression(operand, span=Span(self.source, start, end))

    def temporal(
        self,
        start: int,
        end: int,
        word: Token,
        interval: ast.IntervalExpression | None,
        operand: ast.Expression,
    ) -> ast.Temporal:
        span = Span(self.source, start, end)
        canonical = _WORD[word[0]]
        return ast.Temporal(canonical, interval, operand, word_span=self._span(word), span=span)

    def step(self, start: int, end: int, word: Token, operand: ast.Expression) -> ast.Temporal:
        return self.temporal(start, end, word, None, operand)

    def measured(
        self,
        start: int,
        end: int,
        word: Token,
        interval: ast.IntervalExpression | None,
        operand: ast.GroupExpression,
    ) -> ast.MeasureExpression:
        span = Span(self.source, start, end)
        return ast.MeasureExpression(
            _WORD[word[0]], interval, operand, word_span=self._span(word), span=span
        )

    def interval(
        self, start: int, end: int, low: ast.Expression, high: ast.Expression
    ) -> ast.IntervalExpression:
        return ast.IntervalExpression(low, high, span=Span(self.source, start, end))

    def binding(
        self,
        start: int,
        end: int,
        left: ast.Expression,
        word: Token,
        interval: ast.IntervalExpression | None,
        right: ast.Expression,
    ) -> ast.Binding:
        span = Span(self.source, start, end)
        canonical = _WORD[word[0]]
        return ast.Binding(canonical, interval, left, right, word_span=self._span(word), span=span)

    def logic(self, start: int, end: int, *parts: Any) -> ast.Logic:
        word = _WORD[parts[1][0]]
        return ast.Logic(word, tuple(parts[::2]), span=Span(self.source, start, end))

    def pair(
        self, start: int, end: int, left: ast.Expression, word: Token, right: ast.Expression
    ) -> ast.Logic:
        canonical = _WORD[word[0]]
        return ast.Logic(canonical, (left, right), span=Span(self.source, start, end))
