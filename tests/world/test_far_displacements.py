"""Options that move a road beyond all measure are a fault of the file, not of the plugin."""

from __future__ import annotations

import pytest

import roadlang
from tests.straight_road import STRAIGHT


@pytest.mark.parametrize(
    "written",
    [
        "sine { amplitude: 2000km, wavelength: 60m }",
        "shift { at: 10m, offset: 2000km, length: 50m }",
        "random_walk { amplitude: 5000km, correlation: 20m }",
    ],
)
def test_a_road_that_is_moved_by_1000_km_is_the_fault_of_the_file(written: str) -> None:
    text = f"{STRAIGHT}road bent from main {{ perturb with {written} }}\n"
    with pytest.raises(roadlang.DiagnosticError, match="it moves `bent` by more than") as caught:
        roadlang.loads(text).sample()
    [found] = caught.value.diagnostics
    assert found.code == "RL472"
    assert found.span is not None
    assert found.span.text == f"perturb with {written}"
