"""Distributions that refuse their options, where all of them are constant."""

from __future__ import annotations

from collections.abc import Iterator

from ..diagnostics import Diagnostic, DiagnosticError
from ..evaluate.indexed_scenario import IndexedScenario
from .constant_kinds import constant_kind


def refused_draws(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """What distributions raise as they are made, such as RL476; each place once."""
    places = {draw.call.span: draw.call for draw in scenario.draws()}
    for call in places.values():
        try:
            constant_kind(call, scenario)
        except DiagnosticError as error:
            yield from error.diagnostics
