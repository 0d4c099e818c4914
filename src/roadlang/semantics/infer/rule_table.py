"""Which rule looks at which node of the syntax tree."""

from __future__ import annotations

from collections.abc import Mapping

from ...syntax.tree import nodes as ast
from ..checker import Rule
from ..types.dimensions import infer_number
from . import calls, expressions, formulas, members

RULES: Mapping[type, Rule] = {
    ast.Number: infer_number,
    ast.String: expressions.infer_string,
    ast.Text: expressions.infer_string,
    ast.Boolean: expressions.infer_boolean,
    ast.Name: expressions.infer_name,
    ast.Member: members.infer_member,
    ast.Call: calls.infer_call,
    ast.Negate: expressions.infer_negation,
    ast.Arithmetic: expressions.infer_arithmetic,
    ast.Draw: expressions.infer_draw,
    ast.Comparison: formulas.infer_comparison,
    ast.Not: formulas.infer_not,
    ast.Temporal: formulas.infer_temporal,
    ast.Binding: formulas.infer_binding,
    ast.Logic: formulas.infer_logic,
    ast.Group: expressions.infer_group,
    ast.Point: expressions.infer_point,
    ast.ListValue: expressions.infer_list,
    ast.MapValue: expressions.infer_map,
}
