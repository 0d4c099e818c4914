"""Which formulas look ahead, and which look back."""

from __future__ import annotations

import pytest

from roadlang import stl


@pytest.mark.parametrize(
    ("text", "ahead", "back"),
    [
        ("x > 1 and not (y < 2)", False, False),
        ("always (x > 1)", True, False),
        ("(x > 1) until[0, 2] (y > 1)", True, False),
        ("x > 1 or once (y > 1)", False, True),
        ("prev (x > 1)", False, True),
        ("(x > 1) since (y > 1)", False, True),
        ("always ((x > 1) implies once[0, 2] (y > 1))", True, True),
    ],
)
def test_operators_say_which_way_they_look(text: str, ahead: bool, back: bool) -> None:
    formula = stl.parse(text)
    assert (formula.looks_ahead, formula.looks_back) == (ahead, back)
    assert formula.temporal is (ahead or back)
