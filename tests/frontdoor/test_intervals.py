"""`over: [a, b]`: intervals that hold no road, and those at whose ends the road would jump."""

from __future__ import annotations

import pytest

from roadlang import testing

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] } }\n"
SINE = "perturb with sine { amplitude: 3m, wavelength: 50m, OVER }"


def found(over: str, where: str = "road bent from main") -> list[str]:
    text = f"{ROAD}{where} {{ {SINE.replace('OVER', over)} }}\n"
    return [diagnostic.code for diagnostic in testing.check(text)]


@pytest.mark.parametrize("taper", ["", ", taper: 5m"])
def test_an_interval_without_length_is_found_by_check(taper: str) -> None:
    assert "RL414" in found(f"over: [50m, 50m]{taper}")
    assert "RL414" not in found(f"over: [50m, 50m..60m]{taper}")


def test_an_interval_without_taper_is_warned_of_and_fixed() -> None:
    assert found("over: [50m, 150m]") == ["RL193"]
    assert found("over: [50m, 150m], taper: 0m") == []
    assert found("over: [50m, 150m], taper: 5m") == []
    assert found("phase: 1rad") == []


@pytest.mark.parametrize(
    ("over", "taper"), [("[50m, 150m]", "10m"), ("[50m, 70m]", "5m"), ("[50m..60m, 70m]", "10m")]
)
def test_the_fix_is_a_taper_that_fits(over: str, taper: str) -> None:
    text = f"{ROAD}road bent from main {{ {SINE.replace('OVER', f'over: {over}')} }}\n"
    (warning,) = testing.check(text)
    (fix,) = warning.fixes
    fixed = text[: fix.span.start] + fix.replacement + text[fix.span.end :]
    assert f"over: {over}, taper: {taper} }}" in fixed
    assert not testing.check(fixed)
