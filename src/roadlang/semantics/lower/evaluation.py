"""The options of a formula: what robustness measures, and what signals are between samples."""

from __future__ import annotations

from typing import cast

from ...diagnostics import Code
from ...ir.values import ConstantValue, Entries, TextValue, Value
from ...ir.values import Flag as FlagValue
from ...stl.formula.between_samples import unknown_between_samples
from ...stl.formula.evaluation_options import PLAIN, EvaluationOptions, Measure, Semantics
from ...stl.formula.formulas import Formula
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_options, lower_passes
from ..infer.formulas import as_formula
from ..infer.statement_spec import StatementSpec
from ..types.expression_types import TypedExpression
from .randomness import is_random


def lower_evaluation(
    checker: Checker, spec: StatementSpec, statement: ast.Constraint, typed: TypedExpression
) -> EvaluationOptions | None:
    """How the formula `typed` is evaluated; None, reported, where its options are wrong."""
    block = statement.block
    if block is None:
        return PLAIN
    name = statement.name
    context = Context(user=name.text, place=name.text, drive_time=False)
    bound = lower_options(checker, spec, block, context, name.span)
    passes = lower_passes(checker, spec, block, context)
    if not bound.complete or passes is None or not block.complete:
        return None
    if not all(_is_fixed(checker, key, option) for key, option in bound.stated.items()):
        return None
    words = {
        key: option.value.value
        for key, option in bound.stated.items()
        if isinstance(option.value, TextValue)
    }
    weights = _weights(checker, statement, typed, bound.stated.get("weights"), context)
    if weights is None:
        return None
    semantics = cast(Semantics, words.get("semantics", PLAIN.semantics))
    robustness = cast(Measure, words.get("robustness", PLAIN.robustness))
    strict = bound.stated.get("strict")
    is_strict = strict is not None and strict.value == FlagValue(True)
    found = EvaluationOptions(semantics, robustness, weights, is_strict)
    fits = _go_together(checker, found, bound.stated)
    return found if fits and _is_known(checker, found, typed, bound.stated) else None


def _is_fixed(checker: Checker, name: str, option: TypedExpression) -> bool:
    """Whether an option is the same in every scene; reported where it is not."""
    if (
        option.value is not None
        and not is_random(checker, option.value)
        and _is_plain(option.value)
    ):
        return True
    checker.report(
        Code.MUST_NOT_BE_RANDOM,
        option.span,
        what=f"`{name}`",
        expected="written in place, the same in every scene",
    )
    return False


def _is_plain(value: Value) -> bool:
    if isinstance(value, Entries):
        return all(isinstance(item, ConstantValue) for item in value.entries.values())
    return isinstance(value, TextValue | FlagValue)


def _weights(
    checker: Checker,
    statement: ast.Constraint,
    typed: TypedExpression,
    stated: TypedExpression | None,
    context: Context,
) -> tuple[tuple[Formula, float], ...] | None:
    """The weighted operands; None, reported, where one is none."""
    if stated is None:
        return ()
    from ...stl.formula.weighted_operands import WeightedOperands  # few formulas have weights

    assert isinstance(stated.value, Entries)
    assert typed.formula is not None
    # Keys of maps are not names to whoever reads included files: these stand for names beside it.
    prefix = statement.name.text.removesuffix(statement.name.span.text)
    found: dict[Formula, float] = {}
    for key, span in stated.keys:
        named = ast.Name(prefix + key, short=key, span=span)
        operand = as_formula(checker, checker.infer(named, context), f"the weight of `{key}`")
        if operand.formula is None:
            return None
        weight = stated.value.entries[key]
        assert isinstance(weight, ConstantValue)
        found[operand.formula] = weight.value
        if WeightedOperands.of(typed.formula, {operand.formula: weight.value}).missing:
            checker.report(
                Code.WEIGHT_WITHOUT_OPERAND, span, name=key, constraint=statement.name.text
            )
            return None
    return tuple(found.items())


def _go_together(
    checker: Checker, found: EvaluationOptions, stated: dict[str, TypedExpression]
) -> bool:
    if found.conflict is None:
        return True
    first, second = found.conflict
    checker.report(Code.CONFLICTING_OPTIONS, stated[second].span, first=first, second=second)
    return False


def _is_known(
    checker: Checker,
    found: EvaluationOptions,
    typed: TypedExpression,
    stated: dict[str, TypedExpression],
) -> bool:
    """Whether the formula has a value between samples, if it is to have one."""
    assert typed.formula is not None
    constants = {number.variable for number in typed.numbers}
    text = unknown_between_samples(typed.formula, found.semantics, constants)
    if text is None:
        return True
    span = stated["semantics"].span
    checker.report(Code.UNKNOWN_BETWEEN_SAMPLES, span, text=text, semantics=found.semantics)
    return False
