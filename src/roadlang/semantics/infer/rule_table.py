"""Which rule looks at which node of the syntax tree."""

from __future__ import annotations

from collections.abc import Mapping

from ...syntax.tree import nodes as ast
from ..checker import Rule
from ..types.dimensions import infer_number
from . import calls, expressions, formulas, group_copies, measures, members

RULES: Mapping[type, Rule] = {
    ast.NumberLiteral: infer_number,
    ast.String: expressions.infer_string,
    ast.Text: expressions.infer_string,
    ast.Boolean: expressions.infer_boolean,
    ast.Name: expressions.infer_name,
    ast.Member: members.infer_member,
    ast.Numbered: group_copies.infer_numbered,
    ast.CallExpression: calls.infer_call,
    ast.NegateExpression: expressions.infer_negation,
    ast.ArithmeticExpression: expressions.infer_arithmetic,
    ast.Draw: expressions.infer_draw,
    ast.ComparisonExpression: measures.infer_any_comparison,
    ast.NotExpression: formulas.infer_not,
    ast.Temporal: formulas.infer_temporal,
    ast.MeasureExpression: measures.infer_measure,
    ast.Binding: formulas.infer_binding,
    ast.Logic: formulas.infer_logic,
    ast.GroupExpression: expressions.infer_group,
    ast.Point: expressions.infer_point,
    ast.ListValue: expressions.infer_list,
    ast.MapValue: expressions.infer_map,
}
