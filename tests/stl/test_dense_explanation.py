"""What decides between samples, and where the comparison fails there."""

from __future__ import annotations

from typing import Any

import pytest

from roadlang import stl
from tests.stl.test_dense import DenseDraw, draw_grids


@pytest.mark.parametrize("semantics", ["held", "linear"])
@pytest.mark.parametrize("seed", [seed for seed in range(30) if seed not in (14, 17, 28)])
def test_the_chain_carries_the_robustness_to_a_comparison(seed: int, semantics: Any) -> None:
    formula = DenseDraw(seed, bounded=True).formula(1 + seed % 3)
    grids = draw_grids(seed, same=seed % 2 == 0)
    if not formula.variables:
        return
    signals = {name: stl.OwnGrid(*grid) for name, grid in grids.items()}
    start = max(grids[name][0][0] for name in formula.variables)
    why = formula.explain([start], signals, semantics=semantics)
    assert why.rho == formula.rho([start], signals, semantics=semantics)
    assert why.verdict == formula.verdict([start], signals, semantics=semantics)
    for link in why.chain:
        assert abs(link.rho) == pytest.approx(abs(why.rho), abs=1e-9)
    if isinstance(stl.parse(why.predicate), stl.Comparison) and why.predicate not in (
        "true",
        "false",
    ):
        values = {name: [value] for name, value in why.values.items()}
        assert abs(stl.parse(why.predicate).rho([0], values)) == pytest.approx(
            abs(why.rho), abs=1e-9
        )


def test_the_peak_between_two_samples_is_named() -> None:
    x = {"x": stl.OwnGrid([10, 12, 14], [0, 8, 0]), "y": stl.OwnGrid([10, 13, 14], [6, 6, 6])}
    why = stl.parse("always (x < y)").explain([10], x, semantics="linear")
    assert (why.verdict, why.rho, why.position, why.predicate) == ("violated", -2, 12, "x < y")
    assert why.values == {"x": 8, "y": 6}
    (stretch,) = why.stretches
    assert stretch.start == pytest.approx(11.5)
    assert stretch.end == pytest.approx(12.5)
    assert (stretch.worst, stretch.worst_position) == (-2, 12)


def test_a_held_value_fails_until_the_next_sample() -> None:
    why = stl.parse("always[0, 5] (x < 5)").explain(
        [0, 1, 2, 3], {"x": [1, 9, 7, 2]}, semantics="held"
    )
    (stretch,) = why.stretches
    assert (stretch.start, stretch.end, stretch.worst, stretch.worst_position) == (1, 3, -4, 1)


def test_under_not_the_opposite_fails() -> None:
    why = stl.parse("not (true until (x > 5))").explain(
        [0, 1, 2], {"x": [0, 9, 0]}, semantics="held"
    )
    assert [(s.predicate, s.start, s.end) for s in why.stretches] == [("x <= 5", 1, 2)]


def test_a_window_behind_the_end_is_empty() -> None:
    why = stl.parse("eventually[5, 6] (x > 5)").explain([0, 1], {"x": [0, 9]}, semantics="linear")
    assert (why.window_empty, why.verdict) == (True, "unknown")


def test_a_duration_is_explained_by_the_moment_at_its_level() -> None:
    """For 1.5 s the tent is above 2.5 - 1 = 1.5; it crosses that level between two samples."""
    x = {"x": [0, 1, 1.5, 1, 0]}
    why = stl.parse("duration (x > 1) >= 2.5").explain([0, 1, 2, 3, 4], x, semantics="linear")
    assert why.predicate == "x > 1"
    assert why.values["x"] == pytest.approx(1 + why.rho)
    assert why.rho == pytest.approx(-0.25)
