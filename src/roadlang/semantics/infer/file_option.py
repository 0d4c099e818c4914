"""Options that name a file, which must be there."""

from __future__ import annotations

from dataclasses import replace

from ...ir.values import TextValue
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..names.file_checks import file_fault
from ..types.assignable import check_assignable
from ..types.expression_types import StringType, TypedExpression


def check_file(
    checker: Checker, value: ast.Expression, schema: OptionSchema, context: Context
) -> TypedExpression | None:
    """A string that names a file, which must be there."""
    typed = check_assignable(checker, checker.infer(value, context), schema)
    if typed is None or not isinstance(typed.type, StringType) or not typed.type.values:
        return typed
    declared = checker.program.declarations.get(context.user)
    folder = declared.folder_at(value.span) if declared else checker.program.path.parent
    for name in sorted(typed.type.values):
        fault = file_fault(folder, name, typed.span, picture=False)
        if fault is not None:
            checker.diagnostics.append(fault)
            return None
    if isinstance(typed.value, TextValue):
        path = str(folder / typed.value.value)
        checker.program.inputs.append(path)
        return replace(typed, value=TextValue(path))
    return typed
