"""What a `param` or a `let` is, with the value that it has from outside, if any."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code, Fix, Label
from ...plugins.option_types import QuantityType
from ..checker import Checker
from ..context import Context
from ..names.program import Declaration, Setting, expression_of
from ..types import expression_types as ty
from ..types.dimensions import unit_missing
from ..types.expression_types import TypedExpression, unknown
from ..types.quoted_strings import as_string


def define(checker: Checker, declaration: Declaration, context: Context) -> TypedExpression:
    """Infer the definition; called once for each name."""
    name = declaration.name.text
    setting = checker.program.settings.get(name)
    statement = declaration.statement
    if setting is None or not hasattr(statement, "value"):
        typed = checker.infer(expression_of(checker.program, name), context)
        return _usable(checker, declaration, typed)
    default_context = replace(context, user="", place=f"{name}/default")
    default = _usable(checker, declaration, checker.infer(statement.value, default_context))
    strings = setting.from_command_line and isinstance(default.type, ty.StringType)
    typed = checker.infer(setting.value, replace(context, strings=strings))
    if typed.is_unknown or default.is_unknown:
        return unknown(typed.span)
    return _agreeing(checker, setting, declaration, default, typed)


def _usable(checker: Checker, declaration: Declaration, typed: TypedExpression) -> TypedExpression:
    if isinstance(typed.type, ty.DeclaredType | ty.ConstraintType):
        what = f"`{declaration.role}`"
        expected = "a value"
        return checker.report(
            Code.WRONG_TYPE, typed.span, what=what, expected=expected, found=typed.type
        )
    if declaration.role == "param" and isinstance(typed.type, ty.SignalType | ty.FormulaType):
        word = declaration.statement.span.source.span(
            declaration.statement.span.start, declaration.statement.span.start + len("param")
        )
        return checker.report(
            Code.PARAM_NOT_A_VALUE,
            typed.span,
            found=typed.type,
            fixes=[Fix(word, "let")],
            help="`let` names signals and formulas",
        )
    return typed


def _agreeing(
    checker: Checker,
    setting: Setting,
    declaration: Declaration,
    default: TypedExpression,
    typed: TypedExpression,
) -> TypedExpression:
    """The value from outside, if it is of the sort of the default."""
    name = declaration.name.text
    labels = [Label(declaration.name.span, f"its default is {default.type}")]
    if isinstance(typed.type, ty.DeclaredType | ty.ConstraintType | ty.SignalType | ty.FormulaType):
        what, expected = f"`{name}`", default.type
        return checker.report(
            Code.WRONG_TYPE, typed.span, what=what, expected=expected, found=typed.type
        )
    if isinstance(default.type, ty.Quantity) and isinstance(typed.type, ty.Quantity):
        return _same_dimension(checker, name, default.type, typed, labels)
    if type(default.type) is not type(typed.type):
        what, expected = f"`{name}`", default.type
        is_string = isinstance(default.type, ty.StringType)
        help_, fixes = as_string(typed) if is_string else ((), ())
        return checker.report(
            Code.WRONG_TYPE, typed.span, labels=labels, what=what, expected=expected,
            found=typed.type, help=help_, fixes=fixes,
        )  # fmt: skip
    return typed


def _same_dimension(
    checker: Checker, name: str, default: ty.Quantity, typed: TypedExpression, labels: list[Label]
) -> TypedExpression:
    assert isinstance(typed.type, ty.Quantity)
    expected = QuantityType(default.dimension)
    if default.fits_any or typed.type.fits_any or typed.type.dimension == expected.dimension:
        return typed
    if typed.type.bare:
        return unit_missing(checker, typed, expected.dimension)
    return checker.report(
        Code.WRONG_DIMENSION,
        typed.span,
        labels=labels,
        what=f"`{name}`",
        expected=expected.dimension,
        found=typed.type.dimension,
    )
