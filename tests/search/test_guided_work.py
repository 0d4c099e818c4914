"""Guided sampling does not go on guessing where its guesses are of no use."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from roadlang.scenes.sampling import SamplingResult
from roadlang.search.guiding import STEERED, TURNS_WHERE_RARE
from roadlang.search.surrogate import Surrogate
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
BENT = """
road bent from main { perturb with sine { amplitude: 0m..3m, wavelength: 40m..90m } }
road wide from main { width: 10m..11m }
sample with guided { pilot: 112, attempts: 500 }
"""


@pytest.fixture
def guesses(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many points the surrogate was asked about, each time."""
    counts: list[int] = []
    chance = Surrogate.chance

    def counted(self: Surrogate, points: Any) -> Any:
        counts.append(len(points))
        return chance(self, points)

    monkeypatch.setattr(Surrogate, "chance", counted)
    return counts


def test_what_cannot_hold_is_drawn_evenly_after_the_pilot(
    sample: Sample, guesses: list[int]
) -> None:
    result = sample(STRAIGHT + BENT + "require thin: always (width(wide) < 9.7m)\n", 3)
    assert result.scenes == ()
    assert result.candidates == 112 + 500
    assert len(guesses) < 10


def test_proposals_end_where_they_never_hold(sample: Sample, guesses: list[int]) -> None:
    """The robustness jumps, so that the surrogate goes on to hope."""
    odd = "require odd: always (abs(width(wide) - 10.5m) < 0.4m and width(wide) < 10m)\n"
    result = sample(STRAIGHT + BENT + odd, 1)
    assert result.scenes == ()
    assert result.candidates == 112 + 500
    assert len(guesses) <= STEERED * TURNS_WHERE_RARE + 10
