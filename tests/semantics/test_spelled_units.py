"""Units in words, or apart from their number, are answered with the unit that is meant."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text
from roadlang.syntax.unit_words import meant_unit

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] }, WIDTH }\n"
CURVE = "road main { draw with segments { pieces: [straight(60m), arc(40m, ANGLE)] } }\n"


@pytest.mark.parametrize(
    ("text", "code", "mended"),
    [
        (ROAD.replace("WIDTH", "width: 8 meters, lanes: 2"), "RL009", "8m"),
        (ROAD.replace("WIDTH", "lanes: 2, width: 8 metres"), "RL009", "8m"),
        (ROAD.replace("WIDTH", "width: 25 feet\n"), "RL009", "25ft"),
        (ROAD.replace("WIDTH", "width: 8 M"), "RL009", "8m"),
        (ROAD.replace("WIDTH", "speed_limit: 50 kph"), "RL009", "50km/h"),
        (ROAD.replace("WIDTH", "speed_limit: 50 kilometers per hour"), "RL009", "50km/h"),
        (ROAD.replace("WIDTH", "speed_limit: 50 km per h, lanes: 2"), "RL009", "50km/h"),
        (ROAD.replace("WIDTH", "speed_limit: 50KPH"), "RL203", "50km/h"),
        (ROAD.replace("WIDTH", "speed_limit: 14 meters/second"), "RL009", "14m/s"),
        (ROAD.replace("WIDTH", "speed_limit: 14m/second"), "RL203", "14m/s"),
        (CURVE.replace("ANGLE", "90 degrees"), "RL009", "90deg"),
        (CURVE.replace("ANGLE", "1.5 radians"), "RL009", "1.5rad"),
        (CURVE.replace("ANGLE", "90 \N{DEGREE SIGN}"), "RL009", "90deg"),
        (CURVE.replace("ANGLE", "90\N{DEGREE SIGN}"), "RL203", "90deg"),
        (CURVE.replace("ANGLE", "90 \N{MASCULINE ORDINAL INDICATOR}"), "RL009", "90deg"),
        (CURVE.replace("ANGLE", "90\N{MASCULINE ORDINAL INDICATOR}"), "RL203", "90deg"),
        (CURVE.replace("ANGLE", "90\N{RING ABOVE}"), "RL006", "90deg"),
        ("simulate with builtin { duration: 3 seconds }\n", "RL009", "3s"),
        ("param share = 50 percent\n", "RL009", "50%"),
    ],
)
def test_a_unit_in_words_gets_one_error_with_the_unit(text: str, code: str, mended: str) -> None:
    registry = load_registry()
    _, found = check_text(text, Path("a.rl"), {}, registry)
    assert [diagnostic.code for diagnostic in found] == [code]
    (fix,) = found[0].fixes
    assert fix.replacement == mended
    assert f"`{mended}`" in "\n".join(found[0].help)
    fixed = text[: fix.span.start] + mended + text[fix.span.end :]
    assert not check_text(fixed, Path("a.rl"), {}, registry)[1]


def test_an_option_behind_a_number_is_no_unit() -> None:
    text = ROAD.replace("WIDTH", "lanes: 2 seconds: 3")
    _, found = check_text(text, Path("a.rl"), {}, load_registry())
    assert "RL014" in [diagnostic.code for diagnostic in found]


@pytest.mark.parametrize("text", ["yards", "m with", "meters per fathom"])
def test_other_words_mean_no_unit(text: str) -> None:
    assert meant_unit(text) is None
