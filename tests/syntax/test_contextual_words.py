"""Words of operators that files from before the operators used as names."""

from __future__ import annotations

import pytest

from roadlang import stl, testing

WORDS = ["release", "trigger", "weak_until", "weak_since", "next", "prev", "rise", "fall"]
WORDS += ["count", "duration"]


@pytest.mark.parametrize("word", WORDS)
def test_params_and_signals_may_be_called_the_same(word: str) -> None:
    text = f"""
param {word} = 3m
road main {{ draw with segments {{ pieces: [straight(30m + {word})] }} }}
expect c: length(main) > {word}
"""
    assert testing.check(text) == ()
    formula = stl.parse(f"always ({word} < 3)")
    assert formula.variables == {word}
    assert str(formula) == f"always ({word} < 3)"
    assert stl.parse(str(formula)) == formula
