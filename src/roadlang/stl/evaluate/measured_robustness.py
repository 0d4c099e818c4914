"""Evaluation with options: other semantics between samples, and other measures of robustness."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..formula.evaluation_options import EvaluationOptions
from ..formula.formulas import Formula
from .average_robustness import average_rho, average_robustness
from .time_robustness import time_rho, time_robustness
from .trace import FloatArray, Positions, Signals
from .weighted_robustness import weighted_rho, weighted_robustness


def measured_rho(
    formula: Formula,
    positions: Positions,
    signals: Signals,
    options: EvaluationOptions,
    wrap: float | None = None,
) -> FloatArray:
    """The robustness at the first sample, (V,) or a scalar."""
    if options.weights:
        return weighted_rho(formula, positions, signals, dict(options.weights), wrap=wrap)
    match options.robustness:
        case "average":
            return average_rho(formula, positions, signals, wrap=wrap)
        case "time":
            return time_rho(formula, positions, signals, wrap=wrap)
        case "time_left":
            return time_rho(formula, positions, signals, direction="left", wrap=wrap)
    return formula.rho(positions, signals, wrap=wrap, semantics=options.semantics)


def measured_robustness(
    formula: Formula,
    positions: Positions,
    signals: Signals,
    options: EvaluationOptions,
    wrap: float | None = None,
) -> FloatArray:
    """The robustness at every sample, (V, S) or (S,)."""
    if options.weights:
        return weighted_robustness(formula, positions, signals, dict(options.weights), wrap=wrap)
    match options.robustness:
        case "average":
            return average_robustness(formula, positions, signals, wrap=wrap)
        case "time":
            return time_robustness(formula, positions, signals, wrap=wrap)
        case "time_left":
            return time_robustness(formula, positions, signals, direction="left", wrap=wrap)
    return formula.robustness(positions, signals, wrap=wrap, semantics=options.semantics)


def satisfied_by(
    formula: Formula,
    positions: Positions,
    signals: Signals,
    options: EvaluationOptions,
    wrap: float | None = None,
) -> NDArray[np.bool_]:
    """Boolean satisfaction at the first sample, (V,) or a scalar: no measure changes it."""
    return formula.satisfied(positions, signals, wrap=wrap, semantics=options.semantics)
