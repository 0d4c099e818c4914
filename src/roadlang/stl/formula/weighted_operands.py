"""Weights of operands of `and` and `or`, wherever in a formula these stand."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from . import formulas as f
from . import terms as t
from .normal_form import normal_form


@dataclass(frozen=True)
class WeightedOperands:
    """`plain`: the formula in normal form, with a comparison `name > 0` for each weighted operand,
    so that the operand stays one whatever it is made of. `operands`: the operands by those names.
    `weights` by comparison, as it is and negated. `missing`: the weighted formulas that are no
    operand of `and` or `or`."""

    plain: f.Formula
    operands: Mapping[str, f.Formula]
    weights: Mapping[f.Formula, float]
    missing: tuple[f.Formula, ...]

    @classmethod
    def of(cls, formula: f.Formula, weights: Mapping[f.Formula, float]) -> WeightedOperands:
        """Find them in a formula as it is written, else in its normal form."""
        found = cls._in(formula, weights)
        return found if not found.missing else cls._in(normal_form(formula), weights)

    @classmethod
    def _in(cls, formula: f.Formula, weights: Mapping[f.Formula, float]) -> WeightedOperands:
        known = {normal_form(part): weight for part, weight in weights.items()}
        names: dict[f.Formula, str] = {}

        def margin(same: f.Formula) -> f.Formula:
            name = names.setdefault(same, f"weighted {len(names)}")
            return f.Comparison(">", t.Variable(name), t.Constant(0.0))

        def replaced(part: f.Formula) -> f.Formula:
            if (same := normal_form(part)) in known:
                return margin(same)
            if (opposite := normal_form(part, negated=True)) in known:
                return f.Not(margin(opposite))
            return _with_parts(part, replaced)

        # The whole formula is no operand, even if it is weighted.
        plain = normal_form(_with_parts(formula, replaced))
        joined = {
            operand
            for part in plain.walk()
            if isinstance(part, f.LogicalJunction)
            for operand in part.operands
        }
        placed: dict[f.Formula, float] = {}
        found: set[f.Formula] = set()
        for same in list(names):
            forms = {margin(same), normal_form(margin(same), negated=True)}
            placed |= dict.fromkeys(forms, known[same])
            if forms & joined:
                found.add(same)
        missing = tuple(part for part in weights if normal_form(part) not in found)
        return cls(plain, {name: same for same, name in names.items()}, placed, missing)


def _with_parts(formula: f.Formula, replaced: Callable[[f.Formula], f.Formula]) -> f.Formula:
    if not isinstance(formula, f.Compound):
        return formula
    return formula.with_parts([replaced(part) for part in formula.parts])
