"""Nodes of the tree as documents: expressions, and statements up to their block."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TypeAlias

from ..tree import nodes as ast
from ..tree.strings import quoted
from .layout import HARD, LINE, SOFT, Doc, LayoutGroup, Nest, enclosed, joined, render

_PIECE = re.compile(r"\{\w+\}|[^\s{}]+")

Braced: TypeAlias = ast.Block | ast.MapValue


@dataclass(frozen=True, slots=True)
class Part:
    """A statement or item: what stands before its braces, and the braces, if any."""

    head: Doc
    braced: Braced | None = None


def one_line(node: ast.Expression) -> str:
    """The text of an expression in canonical words, however it was laid out."""
    return render(expression(node), width=10**9)


def expression(node: ast.SyntaxNode) -> Doc:
    """An expression in canonical words; no parentheses are added or taken away."""
    match node:
        case ast.NumberLiteral():
            return node.digits + node.unit
        case ast.String():
            return quoted(node.value)
        case ast.Text():
            return _text(node.value)
        case ast.Boolean():
            return "true" if node.value else "false"
        case ast.Name(text, quoted=True):
            return f"`{text}`"
        case ast.Name() | ast.Word() | ast.KindName():
            return node.text
        case ast.Member():
            return (expression(node.of), ".", node.name.text)
        case ast.Numbered():
            return (expression(node.of), "[", expression(node.number), "]")
        case ast.CallExpression():
            return (expression(node.function), enclosed("(", _all(node.arguments), ")"))
        case ast.Argument(key=None):
            return expression(node.value)
        case ast.Argument(key=ast.Word(text=key)):
            return (key, ": ", expression(node.value))
        case ast.GroupExpression():
            return LayoutGroup(("(", Nest(2, (SOFT, expression(node.inner))), SOFT, ")"))
        case ast.Point():
            return enclosed("(", _all(node.items), ")")
        case ast.ListValue():
            return enclosed("[", _all(node.items), "]")
        case ast.IntervalExpression():
            return enclosed("[", [expression(node.low), expression(node.high)], "]")
        case ast.MapValue():
            return braces([(item, False) for item in map(_flat_entry, node.entries)])
        case _:
            return _operation(node)


def _operation(node: ast.SyntaxNode) -> Doc:
    match node:
        case ast.NegateExpression():
            return ("-", expression(node.operand))
        case ast.Draw():
            return (expression(node.low), "..", expression(node.high))
        case ast.ArithmeticExpression(operator="^"):
            # `2m^2` is one number, two square meters: a number and `^` are kept apart.
            sign = " ^ " if isinstance(node.left, ast.NumberLiteral) else "^"
            return (expression(node.left), sign, expression(node.right))
        case ast.ArithmeticExpression():
            return _chain([expression(node.left), expression(node.right)], [node.operator])
        case ast.ComparisonExpression():
            return _chain(_all(node.operands), list(node.operators))
        case ast.Logic():
            return _chain(_all(node.operands), [node.word] * (len(node.operands) - 1))
        case ast.NotExpression():
            return ("not ", expression(node.operand))
        case ast.Temporal() | ast.MeasureExpression():
            return (node.word, *_interval(node.interval), " ", expression(node.operand))
        case ast.Binding():
            left, right = expression(node.left), expression(node.right)
            word: Doc = (node.word, *_interval(node.interval))
            return LayoutGroup((left, Nest(2, (LINE, word, " ", right))))
    raise TypeError(f"no expression: {type(node).__name__}")


def _interval(interval: ast.IntervalExpression | None) -> tuple[Doc, ...]:
    return () if interval is None else (expression(interval),)


def _all(nodes: tuple[ast.SyntaxNode, ...]) -> list[Doc]:
    return [expression(node) for node in nodes]


def _chain(operands: list[Doc], signs: list[str]) -> Doc:
    """Operands with signs between them; lines break before a sign."""
    rest = tuple(
        (LINE, f"{sign} ", operand) for sign, operand in zip(signs, operands[1:], strict=True)
    )
    return LayoutGroup((operands[0], Nest(2, rest)))


def _text(value: str) -> Doc:
    if not value:
        return '""""""'
    lines = [("  " + line if line else "") for line in value.split("\n")]
    return ('"""', *((HARD, line) for line in lines), HARD, '"""')


def _flat_entry(entry: ast.MapEntry) -> Doc:
    return (expression(entry.key), ": ", expression(entry.value))


def braces(items: list[tuple[Doc, bool]]) -> Doc:
    """`{ a, b }`; an item that is flagged ends with `}` and needs no comma after it."""
    if not items:
        return "{}"
    inner: list[Doc] = []
    for index, (item, closed) in enumerate(items):
        inner.append(item)
        if index + 1 < len(items):
            inner.append(LINE if closed else (",", LINE))
    return LayoutGroup(("{", Nest(2, (LINE, *inner)), LINE, "}"))


def part(node: ast.SyntaxNode) -> Part:
    """A statement, an item of a block or an entry of a map."""
    match node:
        case ast.Option(key=key, value=value) | ast.MapEntry(key=key, value=value):
            return _valued((expression(key), ":"), value)
        case ast.Pass():
            label = (" as ", node.label.text) if node.label is not None else ()
            return Part((node.verb.text, " with ", node.kind.text, *label), node.block)
        case ast.Statement():
            return _statement(node)
    raise TypeError(f"no statement or item: {type(node).__name__}")


def _statement(node: ast.Statement) -> Part:
    """A statement by its layout."""
    docs: list[Doc] = []
    words: list[str] = []
    for piece in _PIECE.findall(node.layout):
        if not piece.startswith("{"):
            words.append(piece)
            continue
        value = getattr(node, piece[1:-1])
        if piece == "{block}":
            return Part(joined(" ", [*docs, *words]), value)
        if value is not None and words in ([":"], ["="]):
            head = (joined(" ", docs), ":" if words == [":"] else " =")
            if isinstance(value, ast.MapValue):
                return Part(head, value)
            docs = [head, expression(value)]
        elif value is not None:
            docs.extend([*words, value if isinstance(value, str) else expression(value)])
        words.clear()
    return Part(joined(" ", docs))


def _valued(head: Doc, value: ast.Expression) -> Part:
    if isinstance(value, ast.MapValue):
        return Part(head, value)
    return Part((head, " ", expression(value)))
