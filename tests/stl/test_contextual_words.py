"""The operators that came late are words only where nothing else fits; names may be the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roadlang import load, stl
from roadlang.diagnostics import DiagnosticError
from roadlang.stl.formula.formulas import COMPOUNDS
from roadlang.syntax.operators import OPERATORS

WORDS = [operator.word for operator in OPERATORS if operator.contextual]


@pytest.mark.parametrize("word", WORDS)
def test_signals_may_be_called_like_operators(word: str) -> None:
    formula = stl.parse(f"always ({word} < 3 and abs({word}) > {word} / 2)")
    assert formula.variables == {word}
    assert stl.parse(str(formula)) == formula


@pytest.mark.parametrize("word", WORDS)
def test_params_may_be_called_like_operators(word: str, tmp_path: Path) -> None:
    scene = tmp_path / "a.rl"
    scene.write_text(f"param {word} = 2m\nlet twice = 2 * {word}\n")
    load(scene)


def test_where_an_operator_fits_it_is_one() -> None:
    assert stl.parse("next (release > 1)") == stl.Next(None, stl.parse("release > 1"))
    assert stl.parse("(a > 1) R (R > 2)") == stl.Release(
        None, stl.parse("a > 1"), stl.parse("R > 2")
    )


def test_operators_that_count_samples_have_no_interval() -> None:
    with pytest.raises(DiagnosticError):
        stl.parse("next[0, 2] (x > 1)")
    with pytest.raises(DiagnosticError, match="RL310"):
        stl.from_json({"next": {">": ["x", 1]}, "interval": [0, 2]})
    with pytest.raises(TypeError):
        COMPOUNDS["rise"].of([stl.parse("x > 1")], stl.Interval(0, 2))


def test_the_first_and_the_last_sample() -> None:
    trace = np.arange(4), {"x": np.array([2.0, -1.0, 3.0, 4.0])}
    inf = np.inf
    expected = {
        "next (x > 0)": [-1, 3, 4, -inf],
        "prev (x > 0)": [-inf, 2, -1, 3],
        "rise (x > 0)": [2, -2, 1, -3],
        "fall (x > 0)": [-2, 1, -3, -4],
        "(x > 0) release[0, 1] (x > -3)": [2, 2, 6, 7],
    }
    for text, values in expected.items():
        np.testing.assert_array_equal(stl.parse(text).robustness(*trace), values)


def test_a_lap_has_neither_first_nor_last_sample() -> None:
    positions, signals = np.arange(3), {"x": np.array([1.0, 2.0, 3.0])}
    for text, values in (("next (x > 0)", [2, 3, 1]), ("prev (x > 0)", [3, 1, 2])):
        found = stl.parse(text).robustness(positions, signals, wrap=3)
        np.testing.assert_array_equal(found, values)


def test_a_window_of_release_without_a_sample_holds() -> None:
    formula = stl.parse("(x > 0) release[5, 6] (x > 9)")
    assert formula.rho([0, 1], {"x": [-2, -1]}) == np.inf
    assert formula.range([0, 1], {"x": [-2, -1]}).lo == -1
    assert formula.range([0, 1], {"x": [-2, 1]}).lo == 1


def test_explanations_name_the_neighbor() -> None:
    why = stl.parse("always (rise (x > 0) implies next (y > 1))").explain(
        [0, 1, 2, 3], {"x": [-1, -9, 4, 1], "y": [0, 0, 0, -2]}
    )
    assert (why.verdict, why.position, why.predicate) == ("violated", 3, "y > 1")


@pytest.mark.parametrize("name", ["lateral error", "e [m]", "cross-track", "2d", "always", "inf"])
def test_a_formula_quotes_a_column(name: str) -> None:
    formula = stl.parse(f"always (`{name}` < 3)")
    assert formula.variables == {name}
    assert str(formula) == f"always (`{name}` < 3)"
    assert stl.parse(str(formula)) == formula
    assert stl.from_json(formula.to_json()) == formula
    assert formula.rho([0, 1], {name: [1, 2]}) == 1


def test_quotes_that_are_not_needed_go() -> None:
    assert str(stl.parse("`speed` > 1")) == "speed > 1"
