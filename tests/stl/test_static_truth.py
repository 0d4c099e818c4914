"""What the bounds of signals say of a formula is true of every trace within them."""

from __future__ import annotations

import random

import numpy as np
import pytest

from roadlang import stl
from roadlang.stl.evaluate.static_truth import StaticTruth, static_truth
from tests.stl_draws import NAMES, FormulaDraw
from tests.stl_reference import Reference

EDGES = (0.0, -0.0, -1.0, 2.0)
KNOWN = {"x": (-1.0, 2.0), "low": (0.0, 1.0), "high": (1.0, 3.0), "one": (1.0, 1.0)}
ALWAYS, NEVER, OPEN = StaticTruth(True, True), StaticTruth(False, False), StaticTruth(False, True)


def drawn_bounds(draw: random.Random) -> dict[str, tuple[float, float]]:
    pairs = {name: sorted(draw.choices(EDGES, k=2)) for name in NAMES}
    return {name: (low, high) for name, (low, high) in pairs.items()}


def truth(text: str) -> StaticTruth:
    return static_truth(stl.parse(text), KNOWN)


@pytest.mark.parametrize("seed", range(80))
def test_no_trace_within_the_bounds_contradicts_it(seed: int) -> None:
    draw = random.Random(seed)
    formula = FormulaDraw(seed).formula(seed % 4)
    bounds = drawn_bounds(draw)
    found = static_truth(formula, bounds)
    for samples in (1, 2, 5, 5):
        signals = {name: draw.choices(ends, k=samples) for name, ends in bounds.items()}
        positions = [0.5 * index for index in range(samples)]
        satisfied = Reference(positions, signals).satisfied(formula)[0]
        assert satisfied or not found.certain
        assert found.possible or not satisfied


@pytest.mark.parametrize("seed", range(40))
def test_arrays_of_bounds_are_looked_at_row_by_row(seed: int) -> None:
    draw = random.Random(seed)
    formula = FormulaDraw(seed).formula(3)
    rows = [drawn_bounds(draw) for _ in range(3)]
    columns = {
        name: (np.array([row[name][0] for row in rows]), np.array([row[name][1] for row in rows]))
        for name in NAMES
    }
    together = static_truth(formula, columns)
    for index, row in enumerate(rows):
        alone = static_truth(formula, row)
        assert np.broadcast_to(together.certain, 3)[index] == alone.certain
        assert np.broadcast_to(together.possible, 3)[index] == alone.possible


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("low <= high", ALWAYS),
        ("low < high", OPEN),
        ("low > high", NEVER),
        ("low >= high", OPEN),
        ("one == 1", ALWAYS),
        ("one != 1", NEVER),
        ("one < 1", NEVER),
        ("one <= 1", ALWAYS),
        ("low == high", OPEN),
        ("low != high", OPEN),
        ("high == 0.5", NEVER),
        ("x * x >= 0", ALWAYS),
        ("unknown < unknown", OPEN),
        ("abs(unknown) >= 0", ALWAYS),
        ("abs(unknown) < 0", NEVER),
    ],
)
def test_comparisons_where_bounds_touch(text: str, expected: StaticTruth) -> None:
    assert truth(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("always[0, 5] (one < 1)", NEVER),
        ("always[2, 5] (one < 1)", OPEN),  # a trace may end before: nothing violates it then
        ("always[2, 5] (one == 1)", ALWAYS),
        ("eventually[2, 5] (one == 1)", OPEN),
        ("eventually[2, 5] (one < 1)", NEVER),
        ("once[2, 5] (one == 1)", OPEN),
        ("historically (one == 1)", ALWAYS),
        ("(unknown > 0) until (one == 1)", ALWAYS),
        ("(unknown > 0) until[1, 2] (one == 1)", OPEN),
        ("(one < 1) until[1, 2] (unknown > 0)", NEVER),
        ("(unknown > 0) since (one < 1)", NEVER),
        ("not ((unknown > 0) until (one == 1))", NEVER),
        ("unknown > 0 implies one == 1", ALWAYS),
        ("one == 1 iff low <= high", ALWAYS),
        ("one == 1 xor low <= high", NEVER),
        ("one == 1 iff unknown > 0", OPEN),
        ("true", ALWAYS),
        ("false or one != 1", NEVER),
    ],
)
def test_operators(text: str, expected: StaticTruth) -> None:
    assert truth(text) == expected


def test_formulas_that_share_parts_are_looked_at_once() -> None:
    formula = stl.parse("unknown > 0")
    for _ in range(30):
        formula = stl.Iff(formula, formula)
    assert static_truth(formula, {}) == OPEN
