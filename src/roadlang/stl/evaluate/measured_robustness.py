"""Evaluation with options: other semantics between samples, and other measures of robustness."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..formula.evaluation_options import EvaluationOptions
from ..formula.formulas import Formula
from .average_robustness import average_rho, average_robustness
from .time_robustness import time_rho, time_robustness
from .trace import FloatArray, Positions, Signals
from .weighted_robustness import weighted_rho, weighted_robustness

Measure: TypeAlias = Callable[..., FloatArray]


def measured_rho(
    formula: Formula,
    positions: Positions,
    signals: Signals,
    options: EvaluationOptions,
    wrap: float | None = None,
) -> FloatArray:
    """The robustness at the first sample, (V,) or a scalar; -inf where `strict` fails it."""
    at_start, _ = _measure(options)
    rho = at_start(formula, positions, signals, wrap=wrap)
    if not options.strict:
        return rho
    return np.where(_is_vacuous(formula, positions, signals, options, wrap), -np.inf, rho)


def measured_robustness(
    formula: Formula,
    positions: Positions,
    signals: Signals,
    options: EvaluationOptions,
    wrap: float | None = None,
) -> FloatArray:
    """The robustness at every sample, (V, S) or (S,)."""
    _, everywhere = _measure(options)
    return everywhere(formula, positions, signals, wrap=wrap)


def satisfied_by(
    formula: Formula,
    positions: Positions,
    signals: Signals,
    options: EvaluationOptions,
    wrap: float | None = None,
) -> NDArray[np.bool_]:
    """Boolean satisfaction at the first sample, (V,) or a scalar: no measure changes it."""
    holds = formula.satisfied(positions, signals, wrap=wrap, semantics=options.semantics)
    if not options.strict:
        return holds
    return holds & ~_is_vacuous(formula, positions, signals, options, wrap)


def _is_vacuous(
    formula: Formula,
    positions: Positions,
    signals: Signals,
    options: EvaluationOptions,
    wrap: float | None,
) -> NDArray[np.bool_]:
    """(V,) or a scalar: whether the verdict depends on windows without samples."""
    verdicts = formula.verdict(
        positions, signals, wrap=wrap, semantics=options.semantics, finished=True
    )
    return np.asarray(np.equal(verdicts, "vacuous"))


def _measure(options: EvaluationOptions) -> tuple[Measure, Measure]:
    """What gives the robustness at the first sample, and what gives it at every sample."""
    if options.weights:
        weights = dict(options.weights)
        return partial(weighted_rho, weights=weights), partial(weighted_robustness, weights=weights)
    match options.robustness:
        case "average":
            return average_rho, average_robustness
        case "time":
            return time_rho, time_robustness
        case "time_left":
            return partial(time_rho, direction="left"), partial(time_robustness, direction="left")
    between = options.semantics
    return partial(Formula.rho, semantics=between), partial(Formula.robustness, semantics=between)
