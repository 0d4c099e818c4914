"""Options that are right by themselves, but not together: said at the option, also where one of
them is drawn and only a scene shows it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang import testing
from roadlang.diagnostics import DiagnosticError
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
