"""Outcomes as rows of tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..ir.controller_failure import failure_columns
from .outcome import Outcome


def row_of(outcome: Outcome, axes: Sequence[str]) -> dict[str, Any]:
    """Evaluation, params, draws, coordinates of what a pass draws for itself, robustness, and the
    moment at which a violated expectation begins to be violated; then the first controller that
    failed, where any did. `axes` names the coordinates."""
    passes = {k: v for k, v in zip(axes, outcome.point, strict=True) if k not in outcome.draws}
    row: dict[str, Any] = {"evaluation": outcome.index, "random": outcome.is_random}
    row |= {**outcome.draws, **passes, **outcome.expectations}
    row["violated"] = " ".join(outcome.violated)
    if outcome.is_failure:
        moment = outcome.moment
        for name in ("time", "agent", "x", "y", "station", "partner"):
            row[f"violation {name}"] = None if moment is None else getattr(moment, name)
    return row | failure_columns(outcome.controller_failures)
