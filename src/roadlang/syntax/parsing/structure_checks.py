"""What the grammar lets through and the language refuses, since more can be said about it here."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from ...diagnostics import Code, Diagnostic, Fix, Source, Span, diagnose
from ..operators import BY_WORD
from ..tree import nodes as ast
from ..tree.walk import walk
from ..words import CONNECTIVES, DEEPEST, STATEMENTS
from .line_positions import begins_line

_NOT_NAMES = frozenset([*STATEMENTS, *CONNECTIVES])
_CHAINS = ("and", "or")


@dataclass(slots=True)
class Checked:
    """The statements that are fit for later passes, the names of the others, what is wrong."""

    accepted: list[ast.Statement] = field(default_factory=list)
    spoiled: list[ast.Word] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)


def check(tree: ast.File) -> Checked:
    """Check every statement of a file."""
    checked = Checked()
    for statement in tree.statements:
        checked.diagnostics.extend(_place_of(statement))
        checked.diagnostics.extend(_declared_name(statement))
        wrong, fit = check_nodes(statement)
        checked.diagnostics.extend(wrong)
        name = getattr(statement, "name", None)
        if fit:
            checked.accepted.append(statement)
        elif isinstance(name, ast.Word):
            checked.spoiled.append(name)
    return checked


def check_nodes(root: ast.SyntaxNode) -> tuple[list[Diagnostic], bool]:
    """What is wrong below one node, and whether it is shallow enough for later passes."""
    found: list[Diagnostic] = []
    for node, depth in walk(root):
        if depth > DEEPEST:
            return [diagnose(Code.NESTING_TOO_DEEP, node.span)], False
        match node:
            case ast.Block():
                found.extend(_separated(node.items))
            case ast.MapValue():
                found.extend(_separated(node.entries))
            case ast.ArithmeticExpression():
                found.extend(_draw_beside(node))
            case ast.Draw(low=ast.Draw()):
                found.append(diagnose(Code.CHAINED_RANGE, node.span))
            case ast.Binding():
                found.extend(_chained_binding(node))
                found.extend(_parentheses(node, (node.left,)))
            case ast.Logic():
                found.extend(_chained_logic(node))
                found.extend(_parentheses(node, node.operands[:-1]))
    return found, True


# --- places --------------------------------------------------------------------------------------


def _place_of(statement: ast.Statement) -> Iterator[Diagnostic]:
    source, start = statement.span.source, statement.span.start
    if not begins_line(source, start):
        end = start + len(source.text[start : start + 12].split()[0])
        fix = Fix(source.span(start, start), "\n")
        help = "begin a new line before it"
        yield diagnose(
            Code.STATEMENT_NOT_AT_LINE_START, source.span(start, end), help=help, fixes=[fix]
        )


def _declared_name(statement: ast.Statement) -> Iterator[Diagnostic]:
    name = getattr(statement, "name", None)
    if isinstance(name, ast.Word) and name.text in _NOT_NAMES:
        help = f"choose another name, such as `{name.text}_1`"
        yield diagnose(Code.STATEMENT_WORD_AS_NAME, name.span, word=name.text, help=help)


def _separated(items: Iterable[ast.SyntaxNode]) -> Iterator[Diagnostic]:
    """Two items on one line have a comma or a `}` between them."""
    previous: ast.SyntaxNode | None = None
    for item in items:
        if previous is not None:
            start, end = previous.span.end, item.span.start
            between = item.span.source.text[start:end]
            closed = item.span.source.text[start - 1 : start] == "}"
            if "\n" not in between and "," not in between and not closed:
                fix = Fix(item.span.source.span(start, start), ",")
                place = item.span.source.span(end, min(item.span.end, end + _key_length(item)))
                yield diagnose(
                    Code.MISSING_COMMA, place, help="put a comma between them", fixes=[fix]
                )
        previous = item


def _key_length(item: ast.SyntaxNode) -> int:
    word = getattr(item, "key", None) or getattr(item, "verb", None)
    return word.span.end - word.span.start if isinstance(word, ast.SyntaxNode) else 1


# --- draws ---------------------------------------------------------------------------------------


def _draw_beside(node: ast.ArithmeticExpression) -> Iterator[Diagnostic]:
    """`a + 1m..2m` draws between 1 m and 2 m; many a reader thinks otherwise."""
    sign = f" {node.operator} "
    if isinstance(node.right, ast.Draw):
        left, low, high = (_text(part) for part in (node.left, node.right.low, node.right.high))
        readings = (f"{left}{sign}({low}..{high})", f"({left}{sign}{low})..{high}")
    elif isinstance(node.left, ast.Draw):
        low, high, right = (_text(part) for part in (node.left.low, node.left.high, node.right))
        readings = (f"({low}..{high}){sign}{right}", f"{low}..({high}{sign}{right})")
    else:
        return
    draw = node.right if isinstance(node.right, ast.Draw) else node.left
    yield _refused(Code.AMBIGUOUS_RANGE, draw.span, node.span, readings, node.operator)


# --- chains --------------------------------------------------------------------------------------


def _chained_binding(node: ast.Binding) -> Iterator[Diagnostic]:
    if isinstance(node.left, ast.Binding):
        inner = node.left
        a = _text(inner.left)
        first, second = _between(inner.left, inner.right), _between(inner, node.right)
        b, c = _text(inner.right), _text(node.right)
        readings = (f"({a}{first}{b}){second}{c}", f"{a}{first}({b}{second}{c})")
        yield _refused(Code.CHAINED_OPERATOR, node.word_span, node.span, readings, node.word)


def _chained_logic(node: ast.Logic) -> Iterator[Diagnostic]:
    inner = node.operands[0]
    if node.word in _CHAINS or not isinstance(inner, ast.Logic):
        return
    if BY_WORD[inner.word].level == BY_WORD[node.word].level:
        a, b, c = (_text(part) for part in (*inner.operands, node.operands[1]))
        first, second = f" {inner.word} ", f" {node.word} "
        readings = (f"({a}{first}{b}){second}{c}", f"{a}{first}({b}{second}{c})")
        place = _sign_between(inner, node.operands[1])
        yield _refused(Code.CHAINED_OPERATOR, place, node.span, readings, node.word)


# --- parentheses ---------------------------------------------------------------------------------


def _parentheses(
    node: ast.Binding | ast.Logic, left: Iterable[ast.Expression]
) -> Iterator[Diagnostic]:
    """To the left of `and` and looser words, what a temporal word governs is in parentheses."""
    for operand in left:
        temporal = _open_temporal(operand)
        if temporal is None:
            continue
        source = node.span.source
        body = _innermost(temporal).operand
        head = source.text[temporal.span.start : body.span.start].rstrip() + " "
        tail = source.text[body.span.end : node.span.end]
        readings = (f"{head}({_text(body)}){tail}", f"{head}({_text(body)}{tail})")
        place = source.span(temporal.span.start, node.span.end)
        yield _refused(
            Code.AMBIGUOUS_TEMPORAL_SCOPE,
            temporal.span,
            place,
            readings,
            node.word,
            temporal.word,
        )


def _open_temporal(node: ast.Expression) -> ast.Temporal | None:
    """The temporal word at the right edge of an operand whose formula has no parentheses."""
    found: ast.Temporal | None = None
    while True:
        match node:
            case ast.Temporal():
                found, node = found or node, node.operand
            case ast.NotExpression():
                node = node.operand
            case ast.Binding() if found is None:
                node = node.right
            case ast.Logic() if found is None:
                node = node.operands[-1]
            case ast.GroupExpression():
                return None
            case _:
                return found


def _innermost(node: ast.Temporal) -> ast.Temporal:
    while isinstance(node.operand, ast.Temporal):
        node = node.operand
    return node


# --- texts ---------------------------------------------------------------------------------------


def _text(node: ast.SyntaxNode) -> str:
    return node.span.text


def _between(left: ast.SyntaxNode, right: ast.SyntaxNode) -> str:
    return left.span.source.text[left.span.end : right.span.start]


def _sign_between(left: ast.SyntaxNode, right: ast.SyntaxNode) -> Span:
    source: Source = left.span.source
    between = _between(left, right)
    start = left.span.end + len(between) - len(between.lstrip())
    return source.span(start, max(start + 1, left.span.end + len(between.rstrip())))


def _refused(
    code: str, span: Span, replaced: Span, readings: tuple[str, str], word: str, temporal: str = ""
) -> Diagnostic:
    """Two readings of the expression, as help and as fixes of which one is to be chosen."""
    return diagnose(
        code,
        span,
        help=tuple(f"write `{' '.join(reading.split())}`" for reading in readings),
        fixes=tuple(Fix(replaced, reading) for reading in readings),
        word=word,
        temporal=temporal,
    )
