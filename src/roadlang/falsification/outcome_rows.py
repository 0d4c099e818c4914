"""Outcomes as rows of tables."""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from typing import Any

from ..evaluate.draw_names import draw_place
from ..ir.controller_failure import failure_columns
from ..ir.result_columns import OF_SEARCH, robustness_column, value_columns
from .outcome import Outcome


def places_of(outcomes: Iterable[Outcome]) -> frozenset[str]:
    """Where the scenes of a search draw values."""
    return frozenset(draw_place(name) for outcome in outcomes for name in outcome.draws)


def is_made(axis: str, draws: Container[str], places: Container[str]) -> bool:
    """Whether a scene with these `draws` depends on a coordinate: that of a draw that it makes, or
    of a number that a pass draws itself, which is not at any of the `places` of draws."""
    return axis in draws or draw_place(axis) not in places


def row_of(outcome: Outcome, axes: Sequence[str], places: Container[str]) -> dict[str, Any]:
    """Evaluation, params, draws, coordinates of what a pass draws for itself, robustness, and the
    moment at which a violated expectation begins to be violated; then the first controller that
    failed, where any did. `axes` names the coordinates.

    `places`: of the draws, by `places_of` all outcomes of the search. A draw that is not among
    those of the outcome was not made, such as that of a fifth copy where there are four: its
    coordinate says nothing.
    """
    named = zip(axes, outcome.point, strict=True)
    passes = {name: at for name, at in named if draw_place(name) not in places}
    row: dict[str, Any] = {"evaluation": outcome.index, "random": outcome.is_random}
    row |= value_columns({**outcome.draws, **passes}, OF_SEARCH)
    row |= {robustness_column(name, OF_SEARCH): rho for name, rho in outcome.expectations.items()}
    row["violated"] = " ".join(outcome.violated)
    if outcome.is_failure:
        moment = outcome.moment
        for name in ("time", "agent", "x", "y", "station", "partner"):
            row[f"violation {name}"] = None if moment is None else getattr(moment, name)
    return row | failure_columns(outcome.controller_failures)
