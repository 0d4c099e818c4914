"""Settings of a search that are given in Python."""

from __future__ import annotations

import pytest

from roadlang import DiagnosticError
from roadlang.testing import scenario
from tests.falsification.slider import TEXT, Slider


def test_settings_of_a_search_in_python_are_checked_like_those_of_a_file() -> None:
    loaded = scenario(TEXT, kinds=[Slider])
    with pytest.raises(DiagnosticError, match=r"RL220.*\n.*did you mean `evaluations`"):
        loaded.falsify(evaluation=10)
    with pytest.raises(DiagnosticError, match=r"RL208.*`random` must be"):
        loaded.falsify(evaluations=10, random=2)
    with pytest.raises(DiagnosticError, match=r"RL206.*`evaluations` expects integer.* 'many'"):
        loaded.falsify(evaluations="many")
    with pytest.raises(DiagnosticError, match=r"RL208.*`batch` must be >= 1"):
        loaded.falsify(batch=0)
