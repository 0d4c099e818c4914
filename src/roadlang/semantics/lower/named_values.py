"""`param` and `let`: values by name, and signals over roads by name."""

from __future__ import annotations

from dataclasses import replace

from ...ir import scenario as ir
from ...ir.dimension import Dimension
from ...stl import Comparison, Constant
from ..checker import Checker
from ..infer.formulas import condition_of
from ..infer.statement_spec import StatementSpec
from ..names.program import Declaration, expression_of
from ..types.expression_types import Quantity, SignalType


def lower_value(checker: Checker, spec: StatementSpec, declaration: Declaration) -> ir.Named | None:
    """The value; None for a signal or a formula, which is written out where it is used."""
    name = declaration.name.text
    typed = checker.definition(name)
    if typed.value is None:
        return None
    dimension: Dimension | None = None
    if isinstance(typed.type, Quantity):
        dimension = typed.type.dimension
    is_param = spec.word == "param"
    span = declaration.statement.span
    return ir.Named(name, typed.value, dimension, is_param, span)


def named_signals(checker: Checker) -> tuple[ir.NamedSignal, ...]:
    """The `let`s that name signals over roads, as written."""
    found = []
    for declaration in checker.program.in_role("let"):
        typed = checker.definition(declaration.name.text)
        if isinstance(typed.type, SignalType) and typed.type.domain == "road":
            assert typed.term is not None
            node = expression_of(checker.program, declaration.name.text)
            above_zero = Comparison(">=", typed.term, Constant(0.0))
            condition = condition_of(node, replace(typed, formula=above_zero))
            span = declaration.statement.span
            name = declaration.name.text
            found.append(ir.NamedSignal(name, condition, typed.type.dimension, span))
    return tuple(found)
