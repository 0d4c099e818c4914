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
from ..types.expression_types import Typed, unknown


def define(checker: Checker, declaration: Declaration, context: Context) -> Typed:
    """Infer the definition; called once for each name."""
    name = declaration.name.text
    setting = checker.program.settings.get(name)
    statement = declaration.statement
    if setting is None or not hasattr(statement, "value"):
        typed = checker.infer(expression_of(checker.program, name), context)
        return _usable(checker, declaration, typed)
    default_context = replace(context, user="", place=f"{name}/default")
    default = _usable(checker, declaration, checker.infer(statement.value, default_context))
    strings = setting.from_command_line and isinstance(default.type, ty.TextType)
    typed = checker.infer(setting.value, replace(context, strings=strings))
    if typed.is_unknown or default.is_unknown:
        return unknown(typed.span)
    return _agreeing(checker, setting, declaration, default, typed)


def _usable(checker: Checker, declaration: Declaration, typed: Typed) -> Typed:
    if isinstance(typed.type, ty.EntityType | ty.ConstraintType):
        what = f"`{declaration.role}`"
        due = "a value"
        return checker.report(Code.WRONG_TYPE, typed.span, what=what, due=due, found=typed.type)
    if declaration.role == "param" and isinstance(typed.type, ty.SignalType | ty.FormulaType):
        word = declaration.statement.span.source.span(
            declaration.statement.span.start, declaration.statement.span.start + len("param")
        )
        return checker.report(
            Code.PARAM_NOT_A_VALUE, typed.span, found=typed.type, fixes=[Fix(word, "let")],
            help="`let` names signals and formulas",
        )  # fmt: skip
    return typed


def _agreeing(
    checker: Checker, setting: Setting, declaration: Declaration, default: Typed, typed: Typed
) -> Typed:
    """The value from outside, if it is of the sort of the default."""
    name = declaration.name.text
    labels = [Label(declaration.name.span, f"its default is {default.type}")]
    if isinstance(typed.type, ty.EntityType | ty.ConstraintType | ty.SignalType | ty.FormulaType):
        what, due = f"`{name}`", default.type
        return checker.report(Code.WRONG_TYPE, typed.span, what=what, due=due, found=typed.type)
    if isinstance(default.type, ty.Quantity):
        if not isinstance(typed.type, ty.Quantity):
            what, due = f"`{name}`", default.type
            return checker.report(
                Code.WRONG_TYPE, typed.span, labels=labels, what=what, due=due, found=typed.type
            )
        return _same_dimension(checker, name, default.type, typed, labels)
    if type(default.type) is not type(typed.type):
        what, due = f"`{name}`", default.type
        return checker.report(
            Code.WRONG_TYPE, typed.span, labels=labels, what=what, due=due, found=typed.type
        )
    return typed


def _same_dimension(
    checker: Checker, name: str, default: ty.Quantity, typed: Typed, labels: list[Label]
) -> Typed:
    assert isinstance(typed.type, ty.Quantity)
    due = QuantityType(default.dimension)
    if default.fits_any or typed.type.fits_any or typed.type.dimension == due.dimension:
        return typed
    if typed.type.bare:
        return unit_missing(checker, typed, due.dimension)
    return checker.report(
        Code.WRONG_DIMENSION, typed.span, labels=labels, what=f"`{name}`", due=due.dimension,
        found=typed.type.dimension,
    )  # fmt: skip
