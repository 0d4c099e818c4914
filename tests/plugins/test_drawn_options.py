"""Options that are right by themselves, but not together: said at the option, also where one of
them is drawn and only a scene shows it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import BatchRandom, Length, OptionError, Perturber, RoadBatch, option
from roadlang.diagnostics import DiagnosticError
from roadlang.geometry.arrays import Floats
from tests.straight_road import STRAIGHT

TOWN = 'image plan from """\n####\n.#..\n.#..\n""" { scale: 16m/px, legend: { "#": road } }\n'
TOGETHER = {
    "points": (
        "road main { draw with waypoints { points: [(X, 0m), (X, 0m)] } }\n",
        "[(X, 0m), (X, 0m)]",
        "are all the same",
    ),
    "angle": (
        "road main { draw with segments { pieces: [straight(9m), arc(50m, 0deg * (X / 1m))] } }\n",
        "0deg * (X / 1m)",
        "is 0",
    ),
    "by": (
        STRAIGHT + "road bent from main { perturb with nudges { at: [20m, X], by: [(1m, 0m)] } }\n",
        "[(1m, 0m)]",
        "has 1 moves, but `at` has 2 places",
    ),
    "end": (
        TOWN
        + "network town from plan\nroad main from town { select: route((X, 40m), (X, 40m)) }\n",
        "(X, 40m)",
        "is the same point as `start`",
    ),
}


@pytest.mark.parametrize("length", ["40m", "p"])
@pytest.mark.parametrize("option", TOGETHER)
def test_options_that_do_not_go_together_are_said_at_one_of_them(
    option: str, length: str, tmp_path: Path
) -> None:
    text, place, reason = TOGETHER[option]
    text = f"param p = 39m..40m\n{text}".replace("X", length)
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(text, 1, folder=tmp_path)
    found = caught.value.diagnostics[0]
    assert found.code == "RL480"
    assert reason in found.message
    assert f"`{option}`" in found.message
    assert found.span is not None
    assert found.span.start == text.rindex(place.replace("X", length))


@dataclass(frozen=True)
class Between(Perturber):
    """Moves nothing; `low` is below `high`, and neither is an end of 0 m to 10 m."""

    name: ClassVar[str] = "between"
    low: Length = option(help="the lower place")
    high: Length = option(10.0 - 1e-9, help="the higher place")

    def __post_init__(self) -> None:
        inside = np.all(self.low > 0) and np.all(self.low < self.high) and np.all(self.high < 10)
        if not inside:
            reason = "is not between 0 m and `high`, or `high` is not below 10 m"
            raise OptionError("low", reason, help="write `low: 1m`")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        return np.zeros((1, len(roads.stations), 2))


@pytest.mark.parametrize(
    ("options", "codes"),
    [
        ("low: 0m..10m", []),
        ("low: 0m..10m, high: 0m..10m", []),
        ("low: -3m..0m", ["RL480"]),
        ("low: 0m", ["RL480"]),
        ("low: 1m, high: 10m..12m", ["RL480"]),
    ],
)
def test_options_are_refused_before_sampling_only_if_nothing_drawn_can_fit(
    options: str, codes: list[str]
) -> None:
    """A kind may refuse the ends of a range and take what is between them."""
    text = f"{STRAIGHT}road bent from main {{ perturb with between {{ {options} }} }}\n"
    found = testing.check(text, kinds=[Between])
    assert [one.code for one in found] == codes
    assert [one.help for one in found] == [("write `low: 1m`",)] * len(codes)
