"""Formulas for the trace of a drive: what they compare has to be of one dimension, as in scenes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, pairwise
from pathlib import Path

from ..diagnostics import Code, Diagnostic, DiagnosticError, Source, diagnose
from ..files.reading import UnreadableFile, read_start
from ..ir.dimension import TIME, Dimension
from ..ir.trace_document import COLUMN_UNITS
from ..ir.units import parse_unit
from ..stl.formats.drive_traces import is_start_of_document, is_table
from ..syntax.parsing.parser import parse_formula
from ..syntax.tree import nodes as ast
from ..syntax.tree.walk import walk

_HEAD = 4096
"""Bytes of a file that tell whether it is the trace of a drive."""
_COLUMNS = {name: parse_unit(unit).dimension for name, unit in COLUMN_UNITS.items()}


def check_dimensions(formula: str, paths: Sequence[str]) -> None:
    """Raises DiagnosticError RL205 if one of the files is the trace of a drive, whose columns are
    in SI units, and the formula compares, adds or subtracts what differs in dimension there. A
    number without a unit goes with everything."""
    if not any(map(_is_drive, paths)):
        return
    expression, _ = parse_formula(Source("<formula>", formula))
    if expression is None:
        return
    faults = [fault for node, _ in walk(expression) for fault in _mismatches(node)]
    if faults:
        raise DiagnosticError(*faults)


def _is_drive(path: str) -> bool:
    try:
        head = read_start(Path(path), _HEAD).decode("utf-8", "replace")
    except UnreadableFile:  # whoever reads the whole file says so
        return False
    return is_start_of_document(head) or is_table(head.partition("\n")[0].split(","))


def _mismatches(node: ast.SyntaxNode) -> Iterator[Diagnostic]:
    """Of one comparison, sum or difference, or of the least or greatest of some."""
    pairs: Iterable[tuple[ast.Expression, ast.Expression]]
    match node:
        case ast.ComparisonExpression():
            pairs, verb = pairwise(node.operands), "compared"
        case ast.ArithmeticExpression("+" | "-" as operator, left, right):
            pairs, verb = pairwise((left, right)), "added" if operator == "+" else "subtracted"
        case ast.CallExpression(ast.Name("min" | "max"), arguments):
            pairs, verb = combinations((each.value for each in arguments), 2), "compared"
        case ast.IntervalExpression(low, high):
            for bound in (low, high):
                yield from _mismatch("time", TIME, bound, "compared")
            return
        case _:
            return
    for left, right in pairs:
        yield from _mismatch(" ".join(left.span.text.split()), _dimension(left), right, verb)


def _mismatch(
    left: str, expected: Dimension | None, right: ast.Expression, verb: str
) -> Iterator[Diagnostic]:
    found = _dimension(right)
    if expected is not None and found is not None and expected != found:
        text = " ".join(right.span.text.split())
        yield diagnose(
            Code.DIMENSION_MISMATCH,
            right.span,
            left=left,
            expected=expected,
            right=text,
            found=found,
            verb=verb,
        )


def _dimension(node: ast.Expression) -> Dimension | None:
    """None where it is not known, as of a number without a unit or a signal of another name."""
    match node:
        case ast.GroupExpression(inner) | ast.NegateExpression(inner):
            return _dimension(inner)
        case ast.NumberLiteral():
            return parse_unit(node.unit).dimension if node.unit else None
        case ast.Name() | ast.Member():
            return _COLUMNS.get(node.span.text.rpartition(".")[2].strip("` "))
        case ast.MeasureExpression("duration"):
            return TIME
        case ast.CallExpression():
            known = (_dimension(argument.value) for argument in node.arguments)
            return next(filter(None, known), None)
        case ast.ArithmeticExpression(operator, left, right):
            return _combined(operator, _dimension(left), _dimension(right))
    return None


def _combined(operator: str, left: Dimension | None, right: Dimension | None) -> Dimension | None:
    if operator in ("+", "-"):
        return right if left is None else left
    if left is None or right is None or operator not in ("*", "/"):
        return None
    return left * right if operator == "*" else left / right
