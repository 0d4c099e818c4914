"""What can be said of a requirement from the draws alone, before any geometry.

A displacement is never greater than the sum of the reaches of its passes, so that a bound on
`deviation` or `distance` can be settled for a candidate, or for the whole scenario, by interval
arithmetic on the formula.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import DiagnosticError
from ..evaluate.candidates import CandidateBatch, fixed_candidate
from ..evaluate.dependencies import draws_in, walk
from ..evaluate.evaluation import build, evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import Road
from ..ir.values import (
    Condition,
    Constant,
    Draw,
    Entity,
    Measure,
    Operation,
    PassCall,
    Reference,
    Value,
)
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.registry import KindEntry
from ..stl.formula import formulas as f
from ..stl.formula import terms as t
from .requirement import Requirement

Floats = NDArray[np.float64]
Range = tuple[Any, Any]
"""Least and greatest value: numbers, or columns (V,) for each candidate"""
_UNKNOWN: Range = (-math.inf, math.inf)
_DISPLACED = ("deviation", "distance")
_ROUNDING = 1e-9
_FROM_LOW_TO_HIGH = ("standard.uniform", "standard.integer")


def settled_rows(requirement: Requirement, candidates: CandidateBatch) -> NDArray[np.bool_]:
    """(V,) True where a requirement is certain to hold, whatever the geometry."""
    if not isinstance(requirement.test, Condition) or requirement.test.domain != "road":
        return np.zeros(candidates.count, dtype=bool)
    low, _ = formula_range(requirement.test, _Candidates(candidates))
    return np.broadcast_to(np.asarray(low) > _ROUNDING, (candidates.count,))


def is_impossible(requirement: Requirement, scenario: IndexedScenario) -> bool:
    """Whether no draw of the scenario can satisfy a requirement, as far as intervals tell."""
    if not isinstance(requirement.test, Condition):
        return False
    _, high = formula_range(requirement.test, _Anything(scenario))
    return bool(np.all(np.asarray(high) < -_ROUNDING))


class _Candidates:
    """Ranges for given candidates: their draws are known."""

    def __init__(self, candidates: CandidateBatch) -> None:
        self.scenario = candidates.scenario
        self._variants = candidates

    def number(self, value: Value) -> Range:
        if _is_geometric(value, self.scenario):
            return _UNKNOWN
        found = np.asarray(evaluate(value, self._variants), dtype=float).reshape(-1)
        return found, found

    def reach(self, call: PassCall) -> Any:
        candidates = self._variants
        built = build(call, candidates)
        with built.guarded:
            reach = np.asarray(built.kind.reach(), dtype=float).reshape(-1)
        _check_reach(reach, candidates.count, built.entry, call)
        return reach


class _Anything:
    """Ranges for every candidate that the scenario has."""

    def __init__(self, scenario: IndexedScenario) -> None:
        self.scenario = scenario

    def number(self, value: Value) -> Range:
        return value_range(value, self.scenario)

    def reach(self, call: PassCall) -> Any:
        """The greatest reach at the ends of the ranges of all options."""
        entry, kind = self.scenario.kind(call)
        ends: list[dict[str, float]] = [{}]
        for name, value in call.options:
            low, high = value_range(value, self.scenario)
            if not (math.isfinite(low) and math.isfinite(high)):
                return math.inf
            both = {low, high}
            ends = [{**given, name: end} for given in ends for end in sorted(both)]
            if len(ends) > 64:
                return math.inf
        whole = {option.name for option in entry.options if getattr(option.type, "whole", False)}
        reach = 0.0
        for given in ends:
            fields = {k: round(v) if k in whole else v for k, v in given.items()}
            with plugin_guard(entry, call.span):
                made: Any = kind(**fields)
                found = np.asarray(made.reach(), dtype=float).reshape(-1)
            _check_reach(found, 1, entry, call)
            reach = max(reach, float(found[0]))
        return reach


def _check_reach(reach: Floats, count: int, entry: KindEntry, call: PassCall) -> None:
    if reach.size not in (1, count) or not (reach >= 0.0).all():
        raise wrong_result(entry, call.span, f"gave a reach that is no bound: {reach[:3]}")


def formula_range(condition: Condition, known: _Candidates | _Anything) -> Range:
    """Least and greatest robustness of a formula."""
    ranges: dict[str, Range] = {
        binding.variable: _signal_range(binding.call, known) for binding in condition.signals
    }
    for number in condition.numbers:
        ranges[number.variable] = known.number(number.value)
    with np.errstate(invalid="ignore"):
        return _formula(condition.formula, ranges)


def value_range(value: Value, scenario: IndexedScenario) -> tuple[float, float]:
    """Least and greatest number that a value can be."""
    if isinstance(value, Constant):
        return value.value, value.value
    if isinstance(value, Reference):
        return value_range(scenario.values[value.name].value, scenario)
    if isinstance(value, Draw):
        return _support(value, scenario)
    if isinstance(value, Operation):
        parts = [value_range(operand, scenario) for operand in value.operands]
        return _operation(value.operator, parts)
    return -math.inf, math.inf


def _support(draw: Draw, scenario: IndexedScenario) -> tuple[float, float]:
    ranges = dict(draw.call.options)
    if draw.call.kind in _FROM_LOW_TO_HIGH:
        return value_range(ranges["low"], scenario)[0], value_range(ranges["high"], scenario)[1]
    if any(True for _, v in draw.call.options for _ in draws_in(v, scenario.values)):
        return -math.inf, math.inf
    try:
        built = build(draw.call, fixed_candidate(scenario), single=True)
    except DiagnosticError:  # bounds are a convenience: what is wrong shows when it is drawn
        return -math.inf, math.inf
    with built.guarded:
        support = built.kind.support()
        low, high = (-math.inf, math.inf) if support is None else map(float, support)
    if not low <= high:
        raise wrong_result(built.entry, draw.call.span, f"gave the support ({low:g}, {high:g})")
    return low, high


def _operation(operator: str, parts: list[tuple[float, float]]) -> tuple[float, float]:
    (low, high), *rest = parts
    if operator == "negate" or (operator == "-" and not rest):
        return -high, -low
    if operator == "abs":
        return (0.0 if low <= 0 <= high else min(abs(low), abs(high))), max(abs(low), abs(high))
    for other in rest:
        low, high = _both(operator, (low, high), other)
    return low, high


def _both(operator: str, a: Range, b: Range) -> Range:
    if operator == "+":
        return a[0] + b[0], a[1] + b[1]
    if operator == "-":
        return a[0] - b[1], a[1] - b[0]
    if operator == "min":
        return np.minimum(a[0], b[0]), np.minimum(a[1], b[1])
    if operator == "max":
        return np.maximum(a[0], b[0]), np.maximum(a[1], b[1])
    if operator == "*":
        with np.errstate(invalid="ignore"):
            products = [np.asarray(x * y) for x in a for y in b]
        if any(np.isnan(product).any() for product in products):
            return _UNKNOWN
        return np.minimum.reduce(products), np.maximum.reduce(products)
    if operator == "/" and bool(np.all(np.asarray(b[0]) > 0)):
        return _both("*", a, (1.0 / b[1], 1.0 / b[0]))
    return _UNKNOWN


def _formula(formula: f.Formula, ranges: dict[str, Range]) -> Range:
    if isinstance(formula, f.Truth):
        return (math.inf, math.inf) if formula.value else (-math.inf, -math.inf)
    if isinstance(formula, f.Comparison):
        left, right = _term(formula.left, ranges), _term(formula.right, ranges)
        if formula.op in ("<", "<="):
            return _both("-", right, left)
        return _both("-", left, right) if formula.op in (">", ">=") else _UNKNOWN
    parts = [_formula(part, ranges) for part in formula.parts]
    if isinstance(formula, f.Not):
        return -parts[0][1], -parts[0][0]
    if isinstance(formula, f.Implies):
        return _fold("max", [(-parts[0][1], -parts[0][0]), parts[1]])
    if isinstance(formula, f.And):
        return _fold("min", parts) if parts else (math.inf, math.inf)
    if isinstance(formula, f.Or):
        return _fold("max", parts) if parts else (-math.inf, -math.inf)
    if isinstance(formula, f.Always | f.Eventually) and formula.interval is None:
        return parts[0]
    return _UNKNOWN


def _fold(operator: str, parts: list[Range]) -> Range:
    found = parts[0]
    for part in parts[1:]:
        found = _both(operator, found, part)
    return found


def _term(term: t.Term, ranges: dict[str, Range]) -> Range:
    if isinstance(term, t.Constant):
        return term.value, term.value
    if isinstance(term, t.Variable):
        return ranges.get(term.name, _UNKNOWN)
    parts = [_term(part, ranges) for part in term.parts]
    if isinstance(term, t.Negate):
        return -parts[0][1], -parts[0][0]
    if isinstance(term, t.Arithmetic):
        return _both(term.op, parts[0], parts[1])
    if isinstance(term, t.Apply) and term.function != "abs":
        return _fold(term.function, parts)
    low, high = parts[0]
    zero = (np.asarray(low) <= 0) & (np.asarray(high) >= 0)
    least = np.where(zero, 0.0, np.minimum(np.abs(low), np.abs(high)))
    return least, np.maximum(np.abs(low), np.abs(high))


def _signal_range(call: PassCall, known: _Candidates | _Anything) -> Range:
    name = call.kind.rpartition(".")[2]
    roads = [value for _, value in call.options if isinstance(value, Entity)]
    standard = call.kind.startswith("standard.")
    if not standard or name not in _DISPLACED or len(roads) != 2:
        return _UNKNOWN
    between = _passes_between(roads[0], roads[1], known.scenario)
    if between is None:
        return (0.0, math.inf)
    return 0.0, sum((known.reach(call) for call in between), start=0.0)


def _passes_between(a: Entity, b: Entity, scenario: IndexedScenario) -> list[PassCall] | None:
    """The passes by which two roads of one root differ; None where they have not one root."""
    if a.role != "road" or b.role != "road":
        return None
    first = [link for link in scenario.chain(scenario.roads[a.name]) if isinstance(link, Road)]
    second = [link for link in scenario.chain(scenario.roads[b.name]) if isinstance(link, Road)]
    if first[-1] is not second[-1]:
        return None
    shared = {link.name for link in first} & {link.name for link in second}
    apart = [link for link in (*first, *second) if link.name not in shared]
    return [call for link in apart for call in link.passes if call.verb == "perturb"]


def _is_geometric(value: Value, scenario: IndexedScenario) -> bool:
    return any(isinstance(item, Measure) for item in walk(value, scenario.values))
