"""Diagnostics that a kind raises itself: they stand where the kind says, or where it is used."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from roadlang import testing
from roadlang.api import Code, DiagnosticError, Perturber, diagnose
from roadlang.diagnostics import Source

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
road bent from main { perturb with picky }
"""
ELSEWHERE = Source("table.csv", "x,y\n0,zero\n")


@dataclass(frozen=True)
class Picky(Perturber):
    """Refuses every road, by a diagnostic of its own."""

    name: ClassVar[str] = "picky"
    has_place: ClassVar[bool] = False

    def displacement(self, road: Any, random: Any) -> Any:
        span = ELSEWHERE.span(6, 10) if self.has_place else None
        raise DiagnosticError(diagnose(Code.DEGENERATE_ROAD, span, name="bent"))


@dataclass(frozen=True)
class PickyElsewhere(Picky):
    """The same, with a place in another file."""

    has_place: ClassVar[bool] = True


@pytest.mark.parametrize(
    ("kind", "path", "marked"),
    [(Picky, "scene.rl", "perturb with picky"), (PickyElsewhere, "table.csv", "zero")],
)
def test_a_diagnostic_of_a_kind_keeps_its_place_or_has_that_of_its_use(
    kind: type[Picky], path: str, marked: str
) -> None:
    with pytest.raises(DiagnosticError) as error:
        testing.sample(TEXT, kinds=[kind])
    (found,) = error.value.diagnostics
    assert found.span is not None
    assert (found.span.source.path, found.span.text) == (path, marked)
