"""A monitor of a plugin says in its own words why it rejects every candidate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import DiagnosticError, Monitor, RoadName, option
from tests.straight_road import STRAIGHT


def refusing(reason: Any) -> type[Monitor]:
    @dataclass(frozen=True)
    class Refusing(Monitor):
        """Rejects every road."""

        name: ClassVar[str] = "refusing"
        road: RoadName = option(help="the road")

        def robustness(self) -> Any:
            return np.array([-1.0])

        def reason(self) -> Any:
            return reason

    return Refusing


SCENE = f"{STRAIGHT}require good with refusing {{ road: main }}\n"


def test_the_reason_is_the_help() -> None:
    with pytest.raises(DiagnosticError) as raised:
        testing.sample(SCENE, 1, kinds=[refusing("it is too dull")])
    (found,) = raised.value.diagnostics
    assert (found.code, found.message) == ("RL600", "no draw can satisfy `good` (with refusing)")
    assert found.help == ("`good`: it is too dull",)


def test_no_reason_is_no_help() -> None:
    with pytest.raises(DiagnosticError) as raised:
        testing.sample(SCENE, 1, kinds=[refusing(None)])
    assert raised.value.diagnostics[0].help == ()


def test_a_reason_that_is_no_text_is_the_fault_of_the_plugin() -> None:
    with pytest.raises(DiagnosticError, match="gave the reason 3, not a text") as raised:
        testing.sample(SCENE, 1, kinds=[refusing(3)])
    assert raised.value.diagnostics[0].code == "RL474"
