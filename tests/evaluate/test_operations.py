"""Arithmetic of what is drawn, for many candidates at once and for one."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from roadlang import testing

OPERATIONS: dict[str, Callable[[float, float], float]] = {
    "-u": lambda u, v: -u,
    "abs(-u)": lambda u, v: u,
    "-(u - v)": lambda u, v: v - u,
    "u + v": lambda u, v: u + v,
    "u - v": lambda u, v: u - v,
    "u * v": lambda u, v: u * v,
    "u / v": lambda u, v: u / v,
    "u ^ 2": lambda u, v: u * u,
    "min(u, -v, 7)": lambda u, v: -v,
    "max(u, -v, 0.5)": lambda u, v: u,
    "u - v - 1": lambda u, v: u - v - 1.0,
    "u / v / 2": lambda u, v: u / v / 2.0,
    "2 - -u * 3": lambda u, v: 2.0 + u * 3.0,
}
TEXT = "let u = 1..2\nlet v = 3..5\n" + "".join(
    f"let w{number} = {text}\n" for number, text in enumerate(OPERATIONS)
)


@pytest.mark.parametrize("count", [1, 5])
def test_each_scene_has_the_arithmetic_of_its_draws(count: int) -> None:
    scenes = testing.sample(TEXT, count)
    assert len({scene.values["u"] for scene in scenes}) == count
    for scene in scenes:
        u, v = scene.values["u"], scene.values["v"]
        for number, operation in enumerate(OPERATIONS.values()):
            assert math.isclose(scene.values[f"w{number}"], operation(u, v), rel_tol=1e-12)
