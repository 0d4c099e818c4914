"""Which simulator drives a scene, with which options."""

from __future__ import annotations

from typing import Any

import pytest

from roadlang import testing
from roadlang.drive.simulators import simulator_call

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }\n"
REGISTRY = testing.registry_with()


@pytest.mark.parametrize(
    ("written", "engine", "given", "expected"),
    [
        ("", None, {}, ("builtin", {})),
        ("", "godot", {"duration": 3.0}, ("godot", {"duration": 3.0})),
        ("simulate with builtin { duration: 2s }", None, {}, ("builtin", {"duration": 2.0})),
        ("simulate with builtin { duration: 2s }", "builtin", {}, ("builtin", {"duration": 2.0})),
        ("simulate with builtin { duration: 2s }", None, {"duration": 9.0},
         ("builtin", {"duration": 9.0})),
        ("simulate with builtin { duration: 2s }", "godot", {}, ("godot", {})),
    ],
)  # fmt: skip
def test_options_of_the_file_count_for_the_engine_that_it_names(
    written: str, engine: str | None, given: dict[str, Any], expected: tuple[str, dict[str, Any]]
) -> None:
    scene = testing.sample(ROAD + written)[0].record
    call = simulator_call(scene, REGISTRY, engine, given)
    kind, options = expected
    assert call.kind.rpartition(".")[2] == kind
    assert {name: call.options[name] for name in options} == options
    if "simulate" in written and kind == "godot":
        assert call.options == {}, "they are of another engine"
