"""Warnings of formulas with windows that hold no sample of what they are judged on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..diagnostics import Code, Diagnostic, diagnose
from ..evaluate.candidates import CandidateBatch
from ..geometry.arrays import Floats
from ..ir.scenario import ScenarioConstraint
from ..ir.values import Condition
from ..stl import Formula
from ..stl.evaluate.vacuity import empty_operators
from ..stl.formula.evaluation_options import EvaluationOptions
from .road_conditions import condition_traces


@dataclass(frozen=True)
class JudgedAxis:
    """Where a formula is judged: `positions` (S,); `wrap`: the length of a closed road."""

    name: str
    positions: Floats
    wrap: float | None = None


def window_warnings(
    formula: Formula, evaluation: EvaluationOptions, axes: Sequence[JudgedAxis]
) -> Iterator[Diagnostic]:
    """RL308 for each operator with a window between two samples of one of the axes, RL313 for each
    whose windows begin after the end of all of them."""
    empty = [empty_operators(formula, axis.positions, axis.wrap) for axis in axes]
    if evaluation.semantics == "sampled":
        for axis, found in zip(axes, empty, strict=True):
            for operator in found.between_samples:
                text = str(operator)
                yield diagnose(Code.WINDOW_BETWEEN_SAMPLES, None, formula=text, trace=axis.name)
    for operator in empty[0].beyond_end if empty else ():
        if all(operator in found.beyond_end for found in empty):
            text, first = str(operator), axes[0].name
            name = first if len(axes) == 1 else f"{first} and {len(axes) - 1} more"
            yield diagnose(Code.WINDOWS_BEYOND_END, None, formula=text, trace=name)


def road_window_warnings(candidates: CandidateBatch) -> tuple[Diagnostic, ...]:
    """Of all requirements and expectations over roads; once for all candidates where no root of a
    road is drawn, as their stations are the same."""
    found: list[Diagnostic] = []
    source = candidates.scenario.source
    for constraint in (*source.requirements, *source.expectations):
        test = constraint.test
        if isinstance(test, Condition) and test.domain == "road" and test.formula.temporal:
            found += _of_roads(constraint, test, candidates)
    return tuple(dict.fromkeys(found))


def _of_roads(
    constraint: ScenarioConstraint, test: Condition, candidates: CandidateBatch
) -> tuple[Diagnostic, ...]:
    def find() -> tuple[Diagnostic, ...]:
        axes = [
            JudgedAxis(f"road `{trace.road}`", trace.positions, trace.wrap)
            for trace in condition_traces(test, candidates)
        ]
        found = window_warnings(test.formula, test.evaluation, axes)
        return tuple(replace(warning, span=constraint.span) for warning in found)

    scenario = candidates.scenario
    key: Any = ("windows", constraint.name)
    return scenario.once(key, find) if scenario.has_fixed_roots else find()
