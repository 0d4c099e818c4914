"""Arguments of calls: those that a kind gathers, as `choice` does, and whether a call is drawn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import pytest

from roadlang import testing
from roadlang.api import Length, ListOf, Piece, option
from roadlang.geometry import Straight


@dataclass(frozen=True)
class Total(Piece):
    """A straight as long as all that is given."""

    name: ClassVar[str] = "total"
    rest: ClassVar[str] = "lengths"
    lengths: ListOf[Length] = option(at_least=1, help="meters, added")

    def to_segment(self, curvature: float) -> Straight:
        """The sum."""
        return Straight(sum(self.lengths))


TWO = """
let piece = {}
road one {{ draw with segments {{ pieces: [piece] }} }}
road other {{ draw with segments {{ pieces: [fresh(piece)] }} }}
"""


def codes(text: str) -> list[str]:
    return [str(found.code) for found in testing.check(text, kinds=[Total])]


@pytest.mark.parametrize("draws", ["10m, 20m..40m", "20m..40m, 10m", "20m..40m, 10m..20m"])
def test_what_gathers_a_draw_is_drawn(draws: str) -> None:
    (scene,) = testing.sample(TWO.format(f"total({draws})"), kinds=[Total])
    one, other = (scene.roads[name].length for name in ("one", "other"))
    assert 30.0 <= min(one, other) <= max(one, other) <= 60.0
    assert one != other


@pytest.mark.parametrize("call", ["arc(40m, 30deg..60deg)", "arc(30m..60m, 30deg)"])
def test_a_call_with_a_draw_among_its_arguments_is_drawn(call: str) -> None:
    (scene,) = testing.sample(TWO.format(call))
    assert scene.roads["one"].length != scene.roads["other"].length
    fixed = TWO.format("arc(40m, 30deg)")
    assert [str(found.code) for found in testing.check(fixed)] == ["RL232"]


def test_what_gathers_no_draw_cannot_be_drawn_again() -> None:
    assert codes(TWO.format("total(10m, 20m)")) == ["RL232"]


@pytest.mark.parametrize(
    ("call", "code"),
    [
        ("total(10m, 2s)", "RL201"),
        ("total()", "RL221"),
        ("total(10m, 20m, lengths: [3m])", "RL222"),
        ("total(10m, size: 3m)", "RL220"),
    ],
)
def test_arguments_that_do_not_fit_are_reported_once(call: str, code: str) -> None:
    text = f"road one {{ draw with segments {{ pieces: [{call}] }} }}\n"
    assert codes(text) == [code]
